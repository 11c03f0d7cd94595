"""The loopback server of the viewer: one page at one secret address, nothing else."""

from __future__ import annotations

import http.client
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


def test_head_has_no_body_and_post_is_not_served(server):
    assert answer(server, server.path, "HEAD") == (200, b"")
    assert answer(server, server.path, "POST")[0] == 501


def test_serve_announces_and_stops():
    told, stop = [], threading.Event()

    def announce(address):
        told.append(address)
        stop.set()

    serve(PAGE, open_browser=False, announce=announce, stop=stop)
    assert told[0].startswith("http://127.0.0.1:")
