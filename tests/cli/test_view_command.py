"""`usdrigui view`: a page from a layer; what is wrong is said before anything opens."""

import os
import signal
import subprocess
import sys
import threading
import urllib.request

import pytest
from pxr import Sdf, Usd, UsdGeom

from usdrigui.cli import main
from usdrigui.isolation import worker
from usdrigui.view.web import serve
from usdrigui.view.web.live import revision


def test_a_review_goes_into_the_page_as_text_that_ends_no_element(layer, tmp_path):
    notes = tmp_path / "notes.usda"
    notes.write_text('#usda 1.0\n# string note = "</script><b>"\n')
    page = tmp_path / "page.html"
    assert main(["view", str(layer), "--html", str(page), "--review", str(notes)]) == 0
    assert '"#usda 1.0\\n# string note = \\"\\u003c/script>\\u003cb>\\"\\n"' in page.read_text(encoding="utf-8")
    assert main(["view", str(layer), "--html", str(notes), "--review", str(notes)]) == 3
    assert notes.read_text().startswith("#usda")


@pytest.mark.parametrize(
    ("option", "content", "told"),
    [
        ("--review", b"#usda 1.0\n", "REVIEW_LAYER"),
        ("--review", b'string note = "', "REVIEW_LAYER"),
        ("--review", b'#usda 1.0\n\xff string note = "', "REVIEW_LAYER"),
        ("--targets", b"#usda 1.0\n" + 12 * b'string pose = ""\n', "CONFIG_VALUE --targets: has 12 of the 13 poses"),
    ],
)
def test_what_is_no_review_or_too_small_a_shelf_is_refused(layer, tmp_path, option, content, told, capsys):
    (tmp_path / "notes.usda").write_bytes(content)
    assert main(["view", str(layer), "--html", str(tmp_path / "page.html"), option, str(tmp_path / "notes.usda")]) > 1
    assert told in capsys.readouterr().err
    assert not (tmp_path / "page.html").exists()


def test_serves_says_where_and_stops_when_asked(layer, monkeypatch, capsys):
    stop, tell = threading.Event(), worker.print_now

    def told(address):
        tell(address)
        assert urllib.request.urlopen(address, timeout=10).status == 200
        stop.set()

    monkeypatch.setattr(worker, "print_now", told)
    monkeypatch.setattr(worker, "stop_requested", stop.is_set)
    assert main(["view", str(layer), "--no-browser"]) == 0
    assert "http://127.0.0.1:" in capsys.readouterr().out


def lose_a_face(source):
    stage = Usd.Stage.Open(str(source))
    mesh = next(UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh))
    counts, indices = list(mesh.GetFaceVertexCountsAttr().Get()), list(mesh.GetFaceVertexIndicesAttr().Get())
    mesh.GetFaceVertexCountsAttr().Set(counts[1:])
    mesh.GetFaceVertexIndicesAttr().Set(indices[counts[0] :])
    stage.GetRootLayer().Save()


def test_the_study_is_offered_when_asked_for(layer, tmp_path):
    for options, offered in (([], False), (["--study"], True)):
        assert main(["view", str(layer), "--html", str(tmp_path / "page.html"), *options]) == 0
        assert ("<body data-study>" in (tmp_path / "page.html").read_text(encoding="utf-8")) == offered


def test_nothing_is_served_or_opened_for_a_layer_that_is_refused(layer, monkeypatch, capsys):
    """The three ways in which a layer cannot be shown, without --html: said in the terminal, and that is all."""

    def opened(*_, **__):
        raise AssertionError("a page was served")

    monkeypatch.setattr(serve, "serve", opened)
    monkeypatch.setattr("webbrowser.open", opened)
    source = layer.with_name("char.usda")
    assert main(["view", str(source)]) == 1
    lose_a_face(source)
    assert main(["view", str(layer)]) == 1
    source.unlink()
    assert main(["view", str(layer)]) == 1
    said = capsys.readouterr().err
    assert [code in said for code in ("LAYOUT_MISSING", "LAYOUT_STALE", "LAYER_MISSING")] == [True, True, True]
    assert said.count("repair: ") == 3


EDIT = b"""#usda 1.0
(
    defaultPrim = "Char"
    startTimeCode = 1
    endTimeCode = 24
    timeCodesPerSecond = 24
    framesPerSecond = 24
    customLayerData = {
        dictionary usdrigui = {
            string work = "{}"
            string[] own = ["/Char/"]
        }
    }
)

over "Char"
{
    float[] blendShapeWeights.timeSamples = {
        1: [%b],
    }
}
"""


def test_a_live_file_is_none_that_was_read_and_none_of_anybody_else(layer, tmp_path, monkeypatch, capsys):
    """The layout, its source, a layer below a shot by a link, a file of other work; nothing is served then."""
    monkeypatch.setattr(serve, "serve", lambda *_, **__: pytest.fail("a page was served"))
    source = layer.with_name("char.usda")
    os.link(source, tmp_path / "edit.usda")
    (tmp_path / "work.usda").write_text("#usda 1.0\n")
    before = {path: path.read_bytes() for path in (layer, source, tmp_path / "work.usda")}
    others = [tmp_path / name for name in ("edit.usda", "work.usda", "edit.json")]
    for target in (layer, source, *others):
        assert main(["view", str(layer), "--live", str(target)]) == 3, target
        assert "FILE_TARGET" in capsys.readouterr().err
    assert main(["view", str(layer), "--live", str(tmp_path / "e.usda"), "--html", str(tmp_path / "e.html")]) == 2
    assert {path: path.read_bytes() for path in before} == before


@pytest.mark.slow
def test_a_live_link_ends_with_ctrl_c_and_leaves_a_whole_file(layer, tmp_path):
    """Amid writes, as fast as they come; with exit code 0 and no temporary file."""
    edit = tmp_path / "live" / "edit.usda"
    edit.parent.mkdir()
    command = [sys.executable, "-u", "-m", "usdrigui", "view", str(layer), "--no-browser", "--live", str(edit)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    address = process.stdout.readline().strip()
    origin, stop, writes = "/".join(address.split("/")[:3]), threading.Event(), []

    def write():
        known = revision(b"")
        while not stop.is_set():
            text = EDIT % (b"0, " * 50_000 + b"%d" % len(writes))
            asked = urllib.request.Request(f"{address}edit", text, {"If-Match": known, "Origin": origin}, method="PUT")
            try:
                with urllib.request.urlopen(asked, timeout=10) as answer:
                    known = answer.headers["ETag"]
            except OSError:
                return
            writes.append(text)
            if len(writes) == 5:
                process.send_signal(signal.SIGINT)

    writer = threading.Thread(target=write)
    writer.start()
    out, err = process.communicate(timeout=60)
    stop.set()
    writer.join(timeout=30)
    assert (process.returncode, "Traceback" in out + err) == (0, False), err
    assert "usdrigui: showed" in out
    assert [path.name for path in edit.parent.iterdir()] == ["edit.usda"]
    held = Sdf.Layer.OpenAsAnonymous(str(edit))
    assert len(held.QueryTimeSample("/Char.blendShapeWeights", 1.0)) == 50_001
