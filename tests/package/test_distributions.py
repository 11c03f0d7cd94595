"""What is installed beside usdrigui: no USD where there is one already, and clear words where there is none or two."""

import os
import shutil
import sys
import tomllib
from pathlib import Path

from programs import ran

from usdrigui.cli import distributions, main
from usdrigui.errors import Exit

ROOT = Path(__file__).resolve().parents[2]


def pyproject(folder=""):
    return tomllib.loads((ROOT / folder / "pyproject.toml").read_text())


def test_what_everyone_installs_brings_usd():
    assert [need for need in pyproject()["project"]["dependencies"] if need.startswith("usd-core>=")]


def test_the_variant_for_pythons_with_their_own_usd_differs_in_that_need_only():
    plain, variant = pyproject(), pyproject("meta")
    needs = [need for need in plain["project"]["dependencies"] if not need.startswith("usd-core")]
    assert variant["project"]["dependencies"] == needs
    for name in ("requires-python", "scripts", "entry-points", "license", "authors"):
        assert variant["project"][name] == plain["project"][name]


def test_the_variant_holds_the_same_files():
    plain, variant = (each["tool"]["hatch"]["build"]["targets"]["wheel"] for each in (pyproject(), pyproject("meta")))
    included = {**{name: name for name in plain["packages"]}, **plain["force-include"]}
    assert variant["force-include"] == {f"../{source}": target for source, target in included.items()}


def test_without_usd_a_command_ends_in_one_refusal(tmp_path):
    (tmp_path / "sitecustomize.py").write_text("import sys\nsys.modules['pxr'] = None\n")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])}
    command = ("-m", "usdrigui", "process", ROOT / "sample_assets" / "char.usda", "--dry-run")
    done = ran(*command, env=environment)
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


def test_the_schema_distribution_needs_nothing_and_serves_beside_the_package(tmp_path):
    schemas = pyproject("schemas")["project"]
    contract = (ROOT / "schemas" / "CONTRACT.md").read_text().partition("\n")[0]
    assert contract.endswith(f"version {schemas['version']}")
    assert (ROOT / "schemas" / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()
    assert schemas["license-files"] == ["LICENSE"]
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
    beside = alone.replace("from pxr", "from usdrigui.stages import schema\nschema.register()\nfrom pxr")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])}
    for script in (alone, beside):
        done = ran("-c", script, env=environment)
        assert (done.returncode, done.stdout, "usdRigUI" in done.stderr) == (0, "", False), done.stderr
