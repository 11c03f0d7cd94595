"""The loopback server of the viewer: one page at one secret address, nothing else."""

from __future__ import annotations

import http.client
import re
import socket
import threading

import pytest

from usdrigui.view.web.live import LiveFile
from usdrigui.view.web.serve import page_server, serve

PAGE = "<!DOCTYPE html><title>ä</title>"


@pytest.fixture
def server():
    with page_server(PAGE) as made:
        thread = threading.Thread(target=made.serve_forever, args=(0.02,), daemon=True)
        thread.start()
        yield made
        made.shutdown()
        thread.join()


def answer(server, path, method="GET", host=None):
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=5)
    connection.request(method, path, headers={"Host": host} if host else {})
    response = connection.getresponse()
    content = response.read()
    connection.close()
    return response.status, content


def test_the_page_is_at_its_address(server):
    status, content = answer(server, server.path)
    assert (status, content.decode()) == (200, PAGE)


def test_loopback_only(server):
    assert server.server_address[0] == "127.0.0.1"
    assert server.address.startswith("http://127.0.0.1:")


def test_addresses_differ_and_cannot_be_guessed():
    with page_server(PAGE) as one, page_server(PAGE) as other:
        assert one.path != other.path
        assert len(one.path) > 40


def test_a_page_comes_back_at_its_port_and_another_one_beside_it():
    """Browsers keep what a page stores by its port."""
    with page_server(PAGE, "char.rigui.usda") as first, page_server(PAGE, "char.rigui.usda") as second:
        assert first.server_port != second.server_port
    with page_server(PAGE, "char.rigui.usda") as again:
        assert again.server_port == first.server_port
        assert again.path != first.path


@pytest.mark.parametrize(
    "path", ["/", "/favicon.ico", "/../etc/passwd", "//etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/x" * 40]
)
def test_every_other_path_is_empty(server, path):
    assert answer(server, path) == (404, b"")


def test_path_below_or_beside_the_page_is_empty(server):
    for path in (server.path + "x", server.path[:-1], server.path + "?a=b", server.path + "../"):
        assert answer(server, path) == (404, b"")


def test_another_host_name_is_refused(server):
    assert answer(server, server.path, host=f"evil.example:{server.server_port}") == (404, b"")


def test_head_has_no_body(server):
    assert answer(server, server.path, "HEAD") == (200, b"")


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "OPTIONS", "BREW"])
def test_other_methods_are_told_which_there_are(server, method):
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=5)
    connection.request(method, server.path, body=b"x" * 500_000)
    response = connection.getresponse()
    assert (response.status, response.headers["Allow"]) == (405, "GET, HEAD")
    assert response.read() == b"405 Method Not Allowed\n"
    connection.close()


@pytest.mark.parametrize("line", [b"GET / HTTP/1.1 more", b"GET / HTTP/7", b"GET /" + b"x" * 70_000 + b" HTTP/1.1"])
def test_what_is_no_request_gets_one_line(server, line):
    with socket.create_connection(("127.0.0.1", server.server_port), timeout=5) as sent:
        sent.sendall(line + b"\r\n\r\n")
        content = sent.makefile("rb").read().rpartition(b"\r\n\r\n")[2]
    assert re.fullmatch(rb"[45]\d\d [\w -]+\n", content)


def test_serve_announces_and_stops():
    told, stop = [], threading.Event()

    def announce(address):
        told.append(address)
        stop.set()

    serve(PAGE, open_browser=False, announce=announce, stop=stop)
    assert told[0].startswith("http://127.0.0.1:")


# --- the file of a live link -------------------------------------------------------------------------

EDIT = b'#usda 1.0\n(\n    customLayerData = { dictionary usdrigui = { string work = "{}" } }\n)\n'


@pytest.fixture
def live(tmp_path):
    with page_server(PAGE, live=LiveFile(tmp_path / "edit.usda", ())) as made:
        thread = threading.Thread(target=made.serve_forever, args=(0.02,), daemon=True)
        thread.start()
        yield made
        made.shutdown()
        thread.join()


def ask(server, method, body=None, path=None, **headers):
    """Status and revision; `origin` and `host` are the page's own unless given."""
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=5)
    given = {"Host": server.host, "Origin": f"http://{server.host}", **headers}
    connection.request(method, path or f"{server.path}edit", body=body, headers={k: v for k, v in given.items() if v})
    response = connection.getresponse()
    content = response.read()
    connection.close()
    return response.status, response.headers["ETag"], content


def test_a_live_file_is_replaced_by_who_knows_what_it_holds(live):
    assert ask(live, "GET") == (200, '"absent"', b"")
    status, first, _ = ask(live, "PUT", EDIT, **{"If-Match": '"absent"'})
    assert (status, live.live.path.read_bytes()) == (200, EDIT)
    assert ask(live, "GET") == (200, first, EDIT)
    assert ask(live, "GET", **{"If-None-Match": first})[0] == 304
    other = EDIT + b"# two\n"
    for known in ('"absent"', "", '"0"'):
        assert ask(live, "PUT", other, **{"If-Match": known})[0] == 412
    assert live.live.path.read_bytes() == EDIT
    assert ask(live, "PUT", other, **{"If-Match": first})[0] == 200
    assert ask(live, "GET")[1] != first


@pytest.mark.parametrize(
    ("status", "change"),
    [
        (403, {"Origin": "http://evil.example"}),
        (403, {"Origin": "null"}),
        (403, {"Origin": ""}),
        (404, {"Host": "evil.example"}),
        (404, {"path": "/edit"}),
        (400, {"body": b"#usda 1.0\n"}),
        (400, {"body": b"work"}),
        (413, {"body": EDIT + b"#" * 1000}),
    ],
)
def test_others_write_nothing(live, monkeypatch, status, change):
    monkeypatch.setattr("usdrigui.view.web.serve._MOST_WRITTEN", 1000)
    asked = {"body": EDIT, "If-Match": '"absent"', **change}
    assert ask(live, "PUT", **asked)[0] == status
    assert not live.live.path.exists()


def test_a_disk_that_refuses_is_told_to_the_page(live):
    live.live.path.mkdir()
    status, _, words = ask(live, "GET")
    assert (status, words.split()[0]) == (507, b"FILE_TARGET")


def test_without_a_live_file_nothing_is_written(server):
    assert ask(server, "PUT", EDIT)[0] == 405


def test_nothing_is_written_after_the_end(live):
    live.live.close()
    assert ask(live, "PUT", EDIT, **{"If-Match": '"absent"'})[0] == 412
