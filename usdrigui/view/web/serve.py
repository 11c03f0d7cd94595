"""A loopback server for one page, and the file of its live link, behind an address that nobody can
guess."""

from __future__ import annotations

import hashlib
import os
import secrets
import sys
import tempfile
import threading
import time
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from usdrigui.errors import RigUIError, sentences
from usdrigui.isolation import worker
from usdrigui.view.web.live import LiveFile, revision

_MOST_DRAINED = 1 << 20
_MOST_WRITTEN = 1 << 28
"""Bytes of an animation layer that a page may send."""
_ASKED_AGAIN = 0.2
"""Seconds between looks for a request to stop that came while a file was written."""
_FIRST_PORT, _PORTS = 49152, 16384
_PORTS_TRIED = 8


def serve(
    html: str,
    open_browser: bool = True,
    announce: Callable[[str], None] | None = None,
    name: str = "",
    live: LiveFile | None = None,
) -> None:
    """Serve `html` on 127.0.0.1 until interrupted (Ctrl-C).

    The page has the one address ``http://127.0.0.1:PORT/TOKEN/`` with a random token of 256 bits
    and a port that `name` chooses: browsers keep what a page stores by its port, so that a page of
    the same name finds its work again.  Every other path or host name gets 404, every other method
    than GET gets 405.  `announce` receives the address before the browser opens.  The file
    of a live link is at ``edit`` below the address, for GET and PUT by the page itself.
    """
    with page_server(html, name, live) as server:
        threading.Thread(target=server.serve_forever, name="usdrigui-view", daemon=True).start()
        if announce is not None:
            announce(server.address)
        try:
            with _leading_to(server.address) as page:
                if open_browser:
                    webbrowser.open(page)
                # A request that comes amid a write interrupts nothing.
                while not worker.stop_requested():
                    time.sleep(_ASKED_AGAIN)
        except KeyboardInterrupt:
            pass
        finally:
            server.shutdown()
            if live is not None:
                live.close()


@contextmanager
def _leading_to(address: str) -> Iterator[str]:
    """The URL of a private file that leads to the address: what a browser is started with is on its
    command line, which every user of the machine can read."""
    with tempfile.TemporaryDirectory(prefix="usdrigui-") as folder:
        page = Path(folder, "view.html")
        page.write_text(f'<!doctype html><meta http-equiv="refresh" content="0; url={address}">\n')
        yield page.as_uri()


class PageServer(ThreadingHTTPServer):
    """Server of one page; `address` is where it is."""

    daemon_threads = True
    allow_reuse_address = os.name == "posix"
    """Elsewhere it would let two servers share a port."""

    def __init__(self, page: bytes, port: int, live: LiveFile | None) -> None:
        super().__init__(("127.0.0.1", port), _Handler)
        self.page, self.live = page, live
        self.path = f"/{secrets.token_urlsafe(32)}/"
        self.host = f"127.0.0.1:{self.server_port}"
        self.address = f"http://{self.host}{self.path}"

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Say nothing of a page that went away amid an answer."""
        if not isinstance(sys.exc_info()[1], OSError):
            super().handle_error(request, client_address)


def page_server(html: str, name: str = "", live: LiveFile | None = None) -> PageServer:
    """A server, bound but not yet serving, of one page; at any free port where those of its name
    are taken."""
    first = int.from_bytes(hashlib.sha256(name.encode()).digest()[:4], "big") % _PORTS
    for port in (*(_FIRST_PORT + (first + i) % _PORTS for i in range(_PORTS_TRIED)), 0):
        with suppress(OSError):
            return PageServer(html.encode("utf-8"), port, live)
    raise OSError("no port of 127.0.0.1 can be bound")


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    server_version = "usdrigui"
    sys_version = ""
    timeout = 10
    """Seconds that a client may keep the server waiting."""

    def do_GET(self) -> None:
        """The page, or the file of its live link, for its exact path; else 404."""
        if (live := self.server.live) is not None and self._is_asked("edit"):
            self._with_file(lambda: self._read(live))
        elif self._is_asked(""):
            self._send(HTTPStatus.OK, self.server.page, "text/html")
        else:
            self._send(HTTPStatus.NOT_FOUND, b"", "text/html")

    def do_PUT(self) -> None:
        """Replace the file of the live link, if it is as the page knows it."""
        live = self.server.live
        if live is None or not self._is_asked("edit"):
            self.send_error(HTTPStatus.NOT_IMPLEMENTED if live is None else HTTPStatus.NOT_FOUND)
            return
        if self.headers.get("Origin") != f"http://{self.server.host}":
            self.send_error(HTTPStatus.FORBIDDEN)
            return
        length = self.headers.get("Content-Length", "")
        if not length.isdecimal() or int(length) > _MOST_WRITTEN:
            self.send_error(
                HTTPStatus.REQUEST_ENTITY_TOO_LARGE if length else HTTPStatus.LENGTH_REQUIRED
            )
            return
        text = self.rfile.read(int(length))
        self._with_file(lambda: self._replaced(live, text if len(text) == int(length) else b""))

    def _is_asked(self, name: str) -> bool:
        """Whether a name below the address is asked for, of this host: no other site's name can be
        pointed here."""
        known = secrets.compare_digest(self.path.encode(), f"{self.server.path}{name}".encode())
        return known and self.headers.get("Host") == self.server.host

    def _read(self, live: LiveFile) -> None:
        found = live.content()
        tag = revision(found)
        if self.headers.get("If-None-Match") == tag:
            self._send(HTTPStatus.NOT_MODIFIED, b"", tag=tag)
        else:
            self._send(HTTPStatus.OK, live.told(found).encode(), tag=tag)

    def _replaced(self, live: LiveFile, text: bytes) -> None:
        made = live.replace(text, self.headers.get("If-Match", ""))
        self._send(HTTPStatus.OK if made else HTTPStatus.PRECONDITION_FAILED, b"", tag=made)

    def _with_file(self, act: Callable[[], None]) -> None:
        """Read or write the file; the page receives what is refused."""
        try:
            act()
        except RigUIError as error:
            words = f"{error.issue.code} {sentences(error.issue)}\n".encode()
            self._send(HTTPStatus.INSUFFICIENT_STORAGE, words)

    def send_error(self, code: int, *_words: str | None) -> None:
        """One line instead of the base class's page; a method without a function here gets the
        list of those that have one."""
        status = (
            HTTPStatus.METHOD_NOT_ALLOWED
            if code == HTTPStatus.NOT_IMPLEMENTED
            else HTTPStatus(code)
        )
        self._drain()
        self._send(status, f"{status.value} {status.phrase}\n".encode())

    def _drain(self) -> None:
        """Read what a request brings, within bounds: closing before that would reset the
        connection."""
        length = self.headers.get("Content-Length", "") if hasattr(self, "headers") else ""
        if length.isdecimal():
            with suppress(OSError):
                self.rfile.read(min(int(length), _MOST_DRAINED))

    def _send(
        self, status: HTTPStatus, content: bytes, kind: str = "text/plain", tag: str = ""
    ) -> None:
        headers = {
            "Content-Type": f"{kind}; charset=utf-8",
            "Content-Length": str(len(content)),
            "Allow": "GET" if status == HTTPStatus.METHOD_NOT_ALLOWED else "",
            "ETag": tag,
            "Cache-Control": "no-store",
            "Referrer-Policy": "no-referrer",
            "X-Content-Type-Options": "nosniff",
        }
        self.send_response(status)
        for name in filter(headers.get, headers):
            self.send_header(name, headers[name])
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - the base class's name
        """Say nothing: the terminal belongs to the command line."""
