"""A loopback server for one page, behind an address that nobody can guess."""

from __future__ import annotations

import hashlib
import os
import secrets
import threading
import webbrowser
from collections.abc import Callable
from contextlib import suppress
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

_MOST_DRAINED = 1 << 20
_FIRST_PORT, _PORTS = 49152, 16384
_PORTS_TRIED = 8


def serve(
    html: str,
    open_browser: bool = True,
    announce: Callable[[str], None] | None = None,
    stop: threading.Event | None = None,
    name: str = "",
) -> None:
    """Serve `html` on 127.0.0.1 until interrupted (Ctrl-C) or until `stop` is set.

    The page has the one address ``http://127.0.0.1:PORT/TOKEN/`` with a random token of 256 bits and a port that
    `name` chooses: browsers keep what a page stores by its port, so that a page of the same name finds its work
    again.  Every other path or host name gets 404, every other method than GET and HEAD gets 405.  `announce` is
    told the address before the browser opens.
    """
    with page_server(html, name) as server:
        threading.Thread(target=server.serve_forever, name="usdrigui-view", daemon=True).start()
        if announce is not None:
            announce(server.address)
        if open_browser:
            webbrowser.open(server.address)
        try:
            (stop or threading.Event()).wait()
        except KeyboardInterrupt:
            pass
        finally:
            server.shutdown()


class PageServer(ThreadingHTTPServer):
    """Server of one page; `address` is where it is."""

    daemon_threads = True
    allow_reuse_address = os.name == "posix"
    """Elsewhere it would let two servers share a port."""

    def __init__(self, page: bytes, port: int) -> None:
        super().__init__(("127.0.0.1", port), _Handler)
        self.page = page
        self.path = f"/{secrets.token_urlsafe(32)}/"
        self.host = f"127.0.0.1:{self.server_port}"
        self.address = f"http://{self.host}{self.path}"


def page_server(html: str, name: str = "") -> PageServer:
    """A server, bound but not yet serving, of one page; at any free port where those of its name are taken."""
    first = int.from_bytes(hashlib.sha256(name.encode()).digest()[:4], "big") % _PORTS
    for port in (*(_FIRST_PORT + (first + i) % _PORTS for i in range(_PORTS_TRIED)), 0):
        with suppress(OSError):
            return PageServer(html.encode("utf-8"), port)
    raise OSError("no port of 127.0.0.1 can be bound")


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    server_version = "usdrigui"
    sys_version = ""
    timeout = 10
    """Seconds that a client may keep the server waiting."""

    def do_GET(self) -> None:
        self._answer(with_body=True)

    def do_HEAD(self) -> None:
        self._answer(with_body=False)

    def _answer(self, with_body: bool) -> None:
        """The page for its exact path and host (so that no other site's name can be pointed here), else 404."""
        known = secrets.compare_digest(self.path.encode(), self.server.path.encode())
        found = known and self.headers.get("Host") == self.server.host
        status = HTTPStatus.OK if found else HTTPStatus.NOT_FOUND
        self._send(status, self.server.page if found else b"", "text/html", with_body)

    def send_error(self, code: int, *_words: str | None) -> None:
        """One line instead of the base class's page; a method without a function here is told what there is."""
        status = HTTPStatus.METHOD_NOT_ALLOWED if code == HTTPStatus.NOT_IMPLEMENTED else HTTPStatus(code)
        self._drain()
        self._send(status, f"{status.value} {status.phrase}\n".encode(), "text/plain", self.command != "HEAD")

    def _drain(self) -> None:
        """Read what a request brings, within bounds: closing before that would reset the connection."""
        length = self.headers.get("Content-Length", "") if hasattr(self, "headers") else ""
        if length.isdecimal():
            with suppress(OSError):
                self.rfile.read(min(int(length), _MOST_DRAINED))

    def _send(self, status: HTTPStatus, content: bytes, kind: str, with_body: bool) -> None:
        self.send_response(status)
        self.send_header("Content-Type", f"{kind}; charset=utf-8")
        self.send_header("Content-Length", str(len(content)))
        if status == HTTPStatus.METHOD_NOT_ALLOWED:
            self.send_header("Allow", "GET, HEAD")
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.end_headers()
        if with_body:
            self.wfile.write(content)

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - the base class's name
        """Say nothing: the terminal belongs to the command line."""
