"""Damaged files: the command ends with a documented exit and issue code, every time, and changes nothing.

80 per format here; the long run and its last figures are in docs/reliability.md.
"""

import json
import sys
import zlib
from pathlib import Path

import pytest
from mutations import mutant, package
from programs import figures
from skel_stages import head

from usdrigui.cli import main
from usdrigui.errors import RigUIError
from usdrigui.reader.reader_process import read_rigs_isolated
from usdrigui.settings import Settings

HERE = Path(__file__).parent
FOUND = sorted((HERE / "found").glob("*.usd*"))
"""Files that once broke something, by this fuzzer or otherwise, with what they must end in."""
ENDS = {
    "broken_deflate_stream": (1, ["FILE_CORRUPT"]),
    "indices_of_unknown_type": (0, []),  # One shape is left off with a warning.
    "names_of_unknown_type": (1, ["ARRAY_TYPE"]),
    "no_faces": (0, []),
    "singular_skeleton": (1, ["SKELETON_INVALID"]),
}

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="readers are forked, which needs Linux")


@pytest.mark.slow
@pytest.mark.parametrize("form", ["usda", "usdc", "usdz"])
def test_every_damaged_file_has_a_documented_end(form, tmp_path):
    found = figures(HERE / "fuzz.py", "--format", form, "--count", 80, "--keep", tmp_path)
    assert found["faults"] == []
    assert sum(found["ends"].values()) == 80
    assert len(found["ends"]) > 5, "the damage has become too gentle or too rough to tell anything"
    assert found["ends"].get("0", 0) < 64


@pytest.mark.parametrize("path", FOUND, ids=lambda path: path.stem)
def test_what_was_found_once(path, tmp_path, capfd):
    """By the command as it is, in a copy so that nothing is written here."""
    copy = tmp_path / f"char{path.suffix}"
    copy.write_bytes(path.read_bytes())
    exit_code = main(["process", str(copy), "--json"])
    printed = capfd.readouterr()
    codes = [each["code"] for each in json.loads(printed.out)["issues"]]
    assert (exit_code, codes[:1] if exit_code else []) == ENDS[path.stem]
    assert "Traceback" not in printed.err
    assert copy.read_bytes() == path.read_bytes()


def test_a_mutant_is_the_same_every_time(tmp_path):
    stock = {"head.usda": head(tmp_path / "head.usda").read_bytes()}
    first = [mutant(form, stock, number) for form in ("usda", "usdz") for number in range(30)]
    assert first == [mutant(form, stock, number) for form in ("usda", "usdz") for number in range(30)]
    assert len(set(first)) > 50


def test_a_package_is_read_and_a_wrong_checksum_is_not(tmp_path):
    content = head(tmp_path / "head.usda").read_bytes()
    path = tmp_path / "char.usdz"
    path.write_bytes(package("head.usda", content))
    assert read_rigs_isolated(path, Settings()).rigs
    path.write_bytes(package("head.usda", content, zlib.crc32(content) ^ 1))
    with pytest.raises(RigUIError, match="FILE_CORRUPT"):
        read_rigs_isolated(path, Settings())
