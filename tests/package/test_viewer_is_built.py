"""The committed script of the viewer is built from the committed sources; told without Node.js."""

import hashlib
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
VIEWER = REPOSITORY / "viewer"
BUILT = REPOSITORY / "usdrigui" / "view" / "assets" / "viewer.js"


def digest(folder):
    """As viewer/build.mjs computes it."""
    names = [*(f"src/{path.name}" for path in sorted((folder / "src").iterdir())), "build.mjs", "package-lock.json"]
    found = hashlib.sha256()
    for name in names:
        found.update(name.encode() + b"\0" + (folder / name).read_bytes() + b"\0")
    return found.hexdigest()


def recorded(script):
    return script.rstrip().rpartition("// sources ")[2]


def test_the_built_script_is_that_of_the_sources():
    built = BUILT.read_text(encoding="utf-8")
    assert recorded(built) == digest(VIEWER), "run `npm ci && npm run build` in viewer/"


def test_a_changed_source_is_noticed(tmp_path):
    shutil.copytree(VIEWER, tmp_path / "viewer", ignore=shutil.ignore_patterns("node_modules"))
    before = digest(tmp_path / "viewer")
    source = tmp_path / "viewer" / "src" / "main.js"
    source.write_text(source.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert digest(tmp_path / "viewer") != before


def test_the_bundled_three_is_the_pinned_one():
    pinned = json.loads((VIEWER / "package.json").read_text())["dependencies"]["three"]
    locked = json.loads((VIEWER / "package-lock.json").read_text())["packages"]["node_modules/three"]["version"]
    assert pinned == locked
    assert f'"{pinned.split(".")[1]}"' in BUILT.read_text(encoding="utf-8")


def test_the_scripts_own_tests_pass():
    if shutil.which("npm") is None:
        pytest.skip("npm is not there")
    done = subprocess.run(["npm", "run", "unit"], cwd=VIEWER, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stdout[-3000:]
    assert int(re.search(r"pass (\d+)", done.stdout)[1]) >= 60


def test_a_build_gives_the_same_bytes():
    if shutil.which("npm") is None or not (VIEWER / "node_modules" / "esbuild").exists():
        pytest.skip("npm, or what `npm ci` installs in viewer/, is not there")
    done = subprocess.run(["npm", "run", "check"], cwd=VIEWER, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
