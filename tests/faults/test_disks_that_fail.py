"""Full disks, read-only folders, missing permission: exit 3 with a code, the old layer byte for byte, no temporary.

Real file systems where the machine lets us mount them or change the user, `os` functions that fail elsewhere.
"""

import os
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import pytest
from skel_stages import head

from usdrigui.cli import main
from usdrigui.isolation.foreign_file import hashed
from usdrigui.pipeline import laying_out
from usdrigui.reader.reader_process import read_rigs_isolated
from usdrigui.settings import Settings

ROOT = sys.platform == "linux" and os.geteuid() == 0


@pytest.fixture(scope="module")
def character(tmp_path_factory):
    """A character, what reading it gives, and its layer."""
    source = head(tmp_path_factory.mktemp("character") / "char.usda")
    assert main(["process", str(source), "--quiet"]) == 0
    return source, read_rigs_isolated(source, Settings()), source.with_name("char.rigui.usda").read_bytes()


OLD = b"""#usda 1.0
(
    customLayerData = {
        dictionary usdrigui = {
        }
    }
)
over "Char"
{
    def Scope "RigUI" (
        prepend apiSchemas = ["RigUILayoutAPI"]
    )
    {
    }
}
"""


@pytest.fixture
def laid_out(tmp_path, character, monkeypatch):
    """A character and an older layer of it; it is read already, for all this is about writing."""
    source, found, _ = character
    copy = tmp_path / source.name
    copy.write_bytes(source.read_bytes())
    target = tmp_path / "char.rigui.usda"
    target.write_bytes(OLD)
    there = replace(found, sources=(hashed(copy),))
    monkeypatch.setattr(laying_out, "read_rigs_isolated", lambda *_: there)
    return copy, target


@pytest.fixture
def small_disk(tmp_path):
    """Mounts a file system of some KiB."""
    places = []

    def mount(options):
        place = tmp_path / f"disk{len(places)}"
        place.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "none", str(place)], check=False)
        if done.returncode:
            pytest.skip("no file system can be mounted here")
        places.append(place)
        return place

    yield mount
    for place in places:
        subprocess.run(["umount", str(place)], check=True)


def kept(target, before, left):
    return target.read_bytes() == before and sorted(each.name for each in target.parent.iterdir()) == sorted(left)


@pytest.mark.skipif(not ROOT, reason="mounting needs root")
@pytest.mark.parametrize("missing", [1, 2])
def test_a_full_disk(missing, laid_out, character, small_disk, capfd):
    """Some pages too few for the new layer, the old one there or not."""
    source, old = laid_out
    size = len(character[2])
    place = small_disk(f"size={4 * (size // 4096 + 2 - missing)}k")
    target = place / "char.rigui.usda"
    target.write_bytes(old.read_bytes())
    before = target.read_bytes()
    assert main(["process", str(source), "-o", str(target)]) == 3
    assert "FILE_FULL" in capfd.readouterr().err
    assert kept(target, before, [target.name])
    target.unlink()
    if missing > 1:
        assert main(["process", str(source), "-o", str(target)]) == 3
        assert list(place.iterdir()) == []


@pytest.mark.skipif(not ROOT, reason="mounting needs root")
def test_a_read_only_disk(laid_out, small_disk, capfd):
    source, old = laid_out
    place = small_disk("size=1m")
    target = place / "char.rigui.usda"
    target.write_bytes(old.read_bytes())
    subprocess.run(["mount", "-o", "remount,ro", str(place)], check=True)
    assert main(["process", str(source), "-o", str(target)]) == 3
    assert "FILE_READ_ONLY" in capfd.readouterr().err
    assert kept(target, old.read_bytes(), [target.name])


@pytest.mark.skipif(not ROOT, reason="mounting needs root")
def test_a_source_on_a_read_only_disk(character, tmp_path, small_disk):
    """No file of the asset is ever opened for writing."""
    place = small_disk("size=1m")
    source, target = place / "char.usda", tmp_path / "out.usda"
    (place / "geo.usda").write_bytes(character[0].read_bytes())
    source.write_text("#usda 1.0\n(\n    subLayers = [@./geo.usda@]\n)\n")
    subprocess.run(["mount", "-o", "remount,ro", str(place)], check=True)
    assert main(["process", str(source), "-o", str(target), "--quiet"]) == 0
    assert target.is_file()


@pytest.mark.skipif(not ROOT, reason="changing the user needs root")
@pytest.mark.parametrize("what", ["folder", "file", "source"])
def test_a_missing_permission(what, laid_out):
    """As a user who is not root, in a process of its own."""
    content = laid_out[0].read_bytes()
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        source, target = folder / "char.usda", folder / "char.rigui.usda"
        source.write_bytes(content)
        target.write_bytes(b"#usda 1.0\n")
        folder.chmod(0o777 if what == "file" else 0o755)
        target.chmod(0o444 if what == "file" else 0o666)
        source.chmod(0o000 if what == "source" else 0o644)
        there = replace(laying_out.read_rigs_isolated(), sources=())
        exit_code = _as_nobody(source, None if what == "source" else there)
        assert exit_code == 3
        said = (folder / "said").read_text() if what == "file" else ""
        assert what != "file" or "FILE_PERMISSION" in said
        assert target.read_bytes() == b"#usda 1.0\n"
        assert {each.name for each in folder.iterdir()} - {"said"} == {source.name, target.name}


def _as_nobody(source, found):
    """Exit code of the command in a forked process of another user; `found` stands in for what was read."""
    if pid := os.fork():
        return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
    code = 99
    try:
        os.setgroups([])
        os.setgid(65534)
        os.setuid(65534)
        laying_out.read_rigs_isolated = read_rigs_isolated if found is None else lambda *_: found
        writable = os.access(source.parent, os.W_OK)
        with (source.parent / "said" if writable else Path(os.devnull)).open("w") as said:
            sys.stderr = said
            code = main(["process", str(source)])
    finally:
        os._exit(code)


def test_a_source_that_changes_meanwhile(laid_out, monkeypatch, capfd):
    source, target = laid_out
    before = target.read_bytes()
    lay_out = laying_out._lay_out

    def meddling(*arguments, **named):
        source.write_bytes(source.read_bytes() + b"\n")
        return lay_out(*arguments, **named)

    monkeypatch.setattr(laying_out, "_lay_out", meddling)
    assert main(["process", str(source)]) == 3
    assert "SOURCE_CHANGED" in capfd.readouterr().err
    assert kept(target, before, [source.name, target.name])
