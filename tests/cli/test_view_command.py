"""`usdrigui view`: a page from a layer; what is wrong is said before anything opens."""

import threading
import urllib.request

from pxr import Usd, UsdGeom

from usdrigui.cli import main
from usdrigui.view import serve


def test_writes_one_page(layer, tmp_path):
    assert main(["view", str(layer), "--html", str(tmp_path / "page.html")]) == 0
    assert (tmp_path / "page.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_serves_and_says_where(layer, monkeypatch, capsys):
    real, stop = serve.serve, threading.Event()

    def once(html, open_browser, announce, name):
        def told(address):
            announce(address)
            assert urllib.request.urlopen(address, timeout=10).status == 200
            stop.set()

        real(
            html,
            open_browser=open_browser,
            announce=lambda address: threading.Thread(target=told, args=[address]).start(),
            stop=stop,
            name=name,
        )

    monkeypatch.setattr(serve, "serve", once)
    assert main(["view", str(layer), "--no-browser"]) == 0
    assert "http://127.0.0.1:" in capsys.readouterr().out


def lose_a_face(source):
    stage = Usd.Stage.Open(str(source))
    mesh = next(UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh))
    counts, indices = list(mesh.GetFaceVertexCountsAttr().Get()), list(mesh.GetFaceVertexIndicesAttr().Get())
    mesh.GetFaceVertexCountsAttr().Set(counts[1:])
    mesh.GetFaceVertexIndicesAttr().Set(indices[counts[0] :])
    stage.GetRootLayer().Save()


def test_a_stale_layer_is_refused(layer, tmp_path, capsys):
    lose_a_face(layer.with_name("char.usda"))
    assert main(["view", str(layer), "--html", str(tmp_path / "page.html")]) == 1
    assert "LAYOUT_STALE" in capsys.readouterr().err
    assert not (tmp_path / "page.html").exists()


def test_a_missing_source_is_refused(layer, tmp_path, capsys):
    layer.with_name("char.usda").unlink()
    assert main(["view", str(layer), "--html", str(tmp_path / "page.html")]) != 0
    assert "char.usda" in capsys.readouterr().err


def test_a_layer_without_layout_is_refused(layer, capsys):
    assert main(["view", str(layer.with_name("char.usda"))]) == 1
    assert "LAYOUT_MISSING" in capsys.readouterr().err


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
