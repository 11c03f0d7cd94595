"""What is installed beside usdrigui: no USD where there is one already, and clear words where there is none or two."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import usdrigui
from usdrigui import distributions
from usdrigui.cli import main
from usdrigui.errors import Exit

ROOT = Path(__file__).resolve().parents[2]
OWN_PXR = ("usd-core", "usd-exchange", "bpy")
FOR_DEVELOPERS = {"usd", "test", "clients", "dev"}


def project(folder=""):
    return tomllib.loads((ROOT / folder / "pyproject.toml").read_text())["project"]


def test_the_core_never_installs_a_usd_unless_it_is_asked_to():
    core = project()
    extras = {name: needs for name, needs in core["optional-dependencies"].items() if name not in FOR_DEVELOPERS}
    needed = [*core["dependencies"], *(need for needs in extras.values() for need in needs)]
    assert not [need for need in needed if need.startswith(OWN_PXR)]
    assert [need.partition(">")[0] for need in core["optional-dependencies"]["usd"]] == ["usd-core"]


def test_the_plain_distribution_is_the_core_of_its_version_with_usd():
    core, plain = project(), project("meta")
    version = usdrigui.__version__
    assert plain["version"] == version
    assert plain["dependencies"] == [f"usdrigui-core[usd]=={version}"]
    users = set(core["optional-dependencies"]) - FOR_DEVELOPERS
    assert plain["optional-dependencies"] == {name: [f"usdrigui-core[{name}]=={version}"] for name in users}
    assert plain["requires-python"] == core["requires-python"]


def test_without_usd_a_command_ends_in_one_refusal(tmp_path):
    (tmp_path / "sitecustomize.py").write_text("import sys\nsys.modules['pxr'] = None\n")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])}
    command = [sys.executable, "-m", "usdrigui", "process", str(ROOT / "sample_assets" / "char.usda"), "--dry-run"]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert done.returncode == Exit.USAGE, done.stderr
    assert done.stderr.count("USD_MISSING") == 1
    assert "pip install usd-core" in done.stderr
    assert "Traceback" not in done.stderr


def test_two_packages_that_hold_pxr_are_named_by_every_command(tmp_path, monkeypatch, capsys):
    for name in ("usd-core", "usd-exchange", "numpy"):
        info = tmp_path / f"{name.replace('-', '_')}-1.0.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
        (info / "RECORD").write_text("numpy/__init__.py,,\n" if name == "numpy" else "pxr/Usd/__init__.py,,\n")
    monkeypatch.setattr(distributions, "_places", lambda: [tmp_path])
    assert main(["schema-path"]) == 0
    said = capsys.readouterr().err
    assert "warning: USD_TWICE" in said
    assert "usd-core 1.0 and usd-exchange 1.0" in said
    assert "--force-reinstall" in said


def test_a_folder_of_packages_that_may_not_be_read_says_nothing(tmp_path, monkeypatch):
    def denied(*_):
        raise PermissionError(13, "Permission denied", str(tmp_path))

    monkeypatch.setattr(distributions, "_places", lambda: [tmp_path])
    monkeypatch.setattr(Path, "glob", denied)
    assert distributions.colliding() == ()


def test_one_package_that_holds_pxr_is_fine():
    assert distributions.colliding() == ()


def test_the_schema_distribution_needs_nothing_and_serves_beside_the_core(tmp_path):
    schemas = project("schemas")
    assert schemas["version"] == usdrigui.__version__
    assert not schemas.get("dependencies")
    built = tomllib.loads((ROOT / "schemas" / "pyproject.toml").read_text())["tool"]["hatch"]["build"]
    shutil.copytree(ROOT / "schemas" / "usdrigui_schemas", tmp_path / "usdrigui_schemas")
    for source, target in built["targets"]["wheel"]["force-include"].items():
        shutil.copy(ROOT / "schemas" / source, tmp_path / target)
    alone = (
        "import usdrigui_schemas\n"
        "from pxr import Usd\n"
        "assert Usd.SchemaRegistry().FindAppliedAPIPrimDefinition('RigUIElementAPI')\n"
    )
    beside = alone.replace("from pxr", "from usdrigui.usd import schema\nschema.register()\nfrom pxr")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])}
    for script in (alone, beside):
        done = subprocess.run(
            [sys.executable, "-c", script], capture_output=True, text=True, env=environment, timeout=120, check=False
        )
        assert (done.returncode, done.stdout, "usdRigUI" in done.stderr) == (0, "", False), done.stderr
