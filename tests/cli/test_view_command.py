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

    def once(html, open_browser, announce):
        def told(address):
            announce(address)
            assert urllib.request.urlopen(address, timeout=10).status == 200
            stop.set()

        real(
            html,
            open_browser=open_browser,
            announce=lambda address: threading.Thread(target=told, args=[address]).start(),
            stop=stop,
        )

    monkeypatch.setattr(serve, "serve", once)
    assert main(["view", str(layer), "--no-browser"]) == 0
    assert "http://127.0.0.1:" in capsys.readouterr().out


def test_a_stale_layer_is_refused(layer, tmp_path, capsys):
    stage = Usd.Stage.Open(str(layer.with_name("char.usda")))
    mesh = next(UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh))
    counts, indices = list(mesh.GetFaceVertexCountsAttr().Get()), list(mesh.GetFaceVertexIndicesAttr().Get())
    mesh.GetFaceVertexCountsAttr().Set(counts[1:])
    mesh.GetFaceVertexIndicesAttr().Set(indices[counts[0] :])
    stage.GetRootLayer().Save()
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
