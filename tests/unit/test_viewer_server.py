"""The loopback server of the viewer: one page at one secret address, nothing else."""

import http.client
import json
import re
import socket
import threading
import urllib.parse
from pathlib import Path

import pytest
from page_in_node import serving
from pxr import Sdf

from usdrigui.settings import ReadSettings
from usdrigui.view.web.live import LiveFile, revision
from usdrigui.view.web.serve import page_server, serve

PAGE = "<!DOCTYPE html><title>ä</title>"
ABSENT = revision(b"")


@pytest.fixture
def server():
    with serving(PAGE) as made:
        yield made


def ask(server, method, path, body=None, **headers):
    """The response and its content; `origin` and `host` are the page's own unless given, what is known is no file."""
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=5)
    given = {"Host": server.host, "Origin": f"http://{server.host}", "If-Match": ABSENT, **headers}
    connection.request(method, path, body=body, headers={k: v for k, v in given.items() if v})
    response = connection.getresponse()
    content = response.read()
    connection.close()
    return response, content


def get(server, path, **headers):
    response, content = ask(server, "GET", path, **headers)
    return response.status, content


def test_the_page_is_at_its_address(server):
    assert get(server, server.path) == (200, PAGE.encode())


def test_loopback_only(server):
    assert server.server_address[0] == "127.0.0.1"


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


def test_every_other_path_is_empty(server):
    below_or_beside = (server.path + "x", server.path[:-1], server.path + "?a=b", server.path + "../")
    others = ("/", "/favicon.ico", "/../etc/passwd", "//etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/x" * 40)
    for path in below_or_beside + others:
        assert get(server, path) == (404, b""), path


def test_another_host_name_is_refused(server):
    assert get(server, server.path, Host=f"evil.example:{server.server_port}") == (404, b"")


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "OPTIONS", "BREW"])
def test_other_methods_are_told_which_there_are(server, method):
    response, content = ask(server, method, server.path, b"x" * 500_000)
    assert (response.status, response.headers["Allow"]) == (405, "GET")
    assert content == b"405 Method Not Allowed\n"


@pytest.mark.parametrize("line", [b"GET / HTTP/1.1 more", b"GET / HTTP/7", b"GET /" + b"x" * 70_000 + b" HTTP/1.1"])
def test_what_is_no_request_gets_one_line(server, line):
    with socket.create_connection(("127.0.0.1", server.server_port), timeout=5) as sent:
        sent.sendall(line + b"\r\n\r\n")
        content = sent.makefile("rb").read().rpartition(b"\r\n\r\n")[2]
    assert re.fullmatch(rb"[45]\d\d [\w -]+\n", content)


# --- the file of a live link -------------------------------------------------------------------------

EDIT = b"""#usda 1.0
(
    defaultPrim = "Char"
    startTimeCode = 1
    endTimeCode = 24
    timeCodesPerSecond = 24
    framesPerSecond = 24
    customLayerData = {
        dictionary usdrigui = {
            string work = "{\\"root\\":\\"/Char\\",\\"keys\\":{}}"
            string[] own = ["/Char/"]
        }
    }
)

over "Char"
{
    over "Skel" (
        prepend apiSchemas = ["SkelBindingAPI"]
    )
    {
        rel skel:animationSource = </Char/Skel/usdrigui_animation>
        def SkelAnimation "usdrigui_animation"
        {
            uniform token[] blendShapes = ["smile", "a \\"b\\" \\\\"]
            float[] blendShapeWeights.timeSamples = {
                1: [0, -0.25],
                24: [1e-7, 1],
            }
            uniform token[] joints = ["Head"]
            quatf[] rotations.timeSamples = {
                1: [(1, 0, 0, 0)],
            }
            half3[] scales.timeSamples = {
                1: [(1, 1, 1)],
            }
        }
    }
}
"""


@pytest.fixture
def live(tmp_path):
    with serving(PAGE, LiveFile(tmp_path / "edit.usda", (), ReadSettings())) as made:
        yield made


def edited(server, method, body=None, path="edit", **headers):
    """Status, revision and content."""
    response, content = ask(server, method, server.path + path, body, **headers)
    return response.status, response.headers["ETag"], content


def test_a_live_file_is_replaced_by_who_knows_what_it_holds(live):
    assert edited(live, "GET") == (200, ABSENT, b"")
    first = edited(live, "PUT", EDIT)[1]
    held = live.live.path.read_bytes()
    status, again, told = edited(live, "GET")
    assert (status, again) == (200, first)
    said = json.loads(told)
    assert (json.loads(said["work"]), said["changed"]) == ({"root": "/Char", "keys": {}}, {})
    assert edited(live, "GET", **{"If-None-Match": first})[0] == 304
    other = EDIT.replace(b"0.25", b"0.5")
    for known in (ABSENT, "", '"0"'):
        assert edited(live, "PUT", other, **{"If-Match": known})[0] == 412
    assert live.live.path.read_bytes() == held
    assert edited(live, "PUT", other, **{"If-Match": first})[0] == 200
    assert edited(live, "GET")[1] != first


@pytest.mark.parametrize(
    ("status", "change"),
    [
        (403, {"Origin": "http://evil.example"}),
        (403, {"Origin": "null"}),
        (403, {"Origin": ""}),
        (404, {"Host": "evil.example"}),
        (404, {"path": "x/edit"}),
        (507, {"body": b"#usda 1.0\n"}),
        (507, {"body": b"work"}),
        (507, {"body": b""}),
        (413, {"body": EDIT + b"#" * 2000}),
    ],
)
def test_others_write_nothing(live, monkeypatch, status, change):
    monkeypatch.setattr("usdrigui.view.web.serve._MOST_WRITTEN", 2000)
    assert edited(live, "PUT", **{"body": EDIT, **change})[0] == status
    assert not live.live.path.exists()


FOREIGN = {
    "a sublayer": (b"    defaultPrim", b"    subLayers = [@/etc/passwd@]\n    defaultPrim"),
    "a reference": (b'prepend apiSchemas = ["SkelBindingAPI"]', b"references = @/etc/passwd@"),
    "another schema": (b"SkelBindingAPI", b"CollectionAPI:x"),
    "another type": (b"def SkelAnimation", b"def Mesh"),
    "another property": (b"blendShapeWeights", b"points"),
    "an asset": (b'"Head"', b"@/etc/passwd@"),
    "a string that ends early": (b'a \\"b', b'a "b'),
    "a comment": (b'uniform token[] joints = ["Head"]', b"# joints"),
    "no number": (b"-0.25", b"None"),
    "a relationship": (b"rel skel:animationSource", b"rel skel:skeleton"),
    "metadata of a property": (b'["Head"]', b'["Head"] (doc = "x")'),
    "other work": (b"string work", b"asset more = @/etc/passwd@\n            string work"),
    "a brace too few": (b"}\n}\n", b"}\n"),
    "a variant": (b'over "Skel" (', b'variantSet "x" = {'),
    "bytes that are no text": (b"smile", b"smil\xff"),
}


@pytest.mark.parametrize("what", FOREIGN)
def test_nothing_but_an_animation_is_saved(live, what):
    old, new = FOREIGN[what]
    assert old in EDIT
    assert edited(live, "PUT", EDIT.replace(old, new))[0] == 507
    assert not live.live.path.exists()


def test_what_a_page_saves_replaces_what_pages_wrote_of_its_characters(live):
    """Also what a program has put in place of it; what is said of the same properties and of other characters stays."""
    edited(live, "PUT", EDIT)
    edit = Sdf.Layer.FindOrOpen(str(live.live.path))
    weights = edit.GetAttributeAtPath("/Char/Skel/usdrigui_animation.blendShapeWeights")
    weights.SetInfo("documentation", "mine")
    edit.SetTimeSample(weights.path, 12.0, [0.5, 0.25])
    edit.Save()
    _, second, told = edited(live, "GET")
    assert json.loads(told)["changed"] == {str(weights.path): weights.GetAsText()}
    third = edited(live, "PUT", EDIT.replace(b"Char", b"Char2"), **{"If-Match": second})[1]
    edit.Reload()
    assert len(edit.ListTimeSamplesForPath(weights.path)) == 3
    assert edited(live, "PUT", EDIT[: EDIT.index(b"over")], **{"If-Match": third})[0] == 200
    edit.Reload()
    assert not edit.ListTimeSamplesForPath(weights.path)
    assert edit.GetAttributeAtPath(weights.path).GetInfo("documentation") == "mine"
    assert not edit.GetAttributeAtPath("/Char/Skel/usdrigui_animation.rotations")
    assert edit.GetAttributeAtPath("/Char2/Skel/usdrigui_animation.rotations")


def test_a_file_that_is_no_usd_for_now_is_told_and_not_replaced(live):
    """As an editor leaves it amid a line."""
    for text in (EDIT[:-2], EDIT.replace(b"smile", b"smil\xff")):
        live.live.path.write_bytes(text)
        for method, body in (("GET", None), ("PUT", EDIT)):
            status, _, words = edited(live, method, body, **{"If-Match": revision(text)})
            assert (status, words[:12]) == (507, b"FILE_NOT_USD")
        assert live.live.path.read_bytes() == text


def test_the_command_line_of_the_browser_does_not_have_the_address(monkeypatch):
    """Every user of the machine can read it."""
    stop, told, opened = threading.Event(), [], []

    def open_browser(url):
        page = Path(urllib.parse.unquote(urllib.parse.urlsplit(url).path))
        opened.append((url, page.read_text(), page.parent.stat().st_mode & 0o777))
        stop.set()

    monkeypatch.setattr("webbrowser.open", open_browser)
    monkeypatch.setattr("usdrigui.isolation.worker.stop_requested", stop.is_set)
    serve("page", announce=told.append)
    [(url, page, mode)] = opened
    assert told[0] not in url
    assert told[0].split("/")[-2] not in url
    assert f"url={told[0]}" in page
    assert mode == 0o700
    assert not Path(urllib.parse.urlsplit(url).path).exists()


def test_a_disk_that_refuses_is_told_to_the_page(live):
    live.live.path.mkdir()
    status, _, words = edited(live, "GET")
    assert (status, words.split()[0]) == (507, b"FILE_TARGET")


def test_without_a_live_file_nothing_is_written(server):
    assert edited(server, "PUT", EDIT)[0] == 405


def test_nothing_is_written_after_the_end(live):
    live.live.close()
    assert edited(live, "PUT", EDIT)[0] == 412
