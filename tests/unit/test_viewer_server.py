"""The loopback server of the viewer: one page at one secret address, nothing else."""

from __future__ import annotations

import http.client
import re
import socket
import threading

import pytest

from usdrigui.view.serve import page_server, serve

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
