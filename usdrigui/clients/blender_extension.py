"""The Blender extension as one file to install.

Its sources lie in ``blender/usdrigui_controls``; the rules of drags, tracks, areas, rotations and
levels and the colours are usdrigui's own files, which need numpy only and go in as they are.  The
package itself goes in as a wheel, which the extension installs in a Python beside Blender.  The
extension is under GPL-3.0-or-later, as Blender's Python interface asks; what goes in as it is stays
under Apache-2.0.
"""

from __future__ import annotations

import importlib.metadata
import io
import tomllib
import zipfile
from collections.abc import Mapping
from pathlib import Path

import usdrigui
from usdrigui.pipeline import write_file
from usdrigui.stages.schema import schema_path, shipped
from usdrigui.version import __version__

NAME = "usdrigui_controls"
"""Folder in the archive, and the extension's id."""
_SHARED = (
    "pose/drag.py",
    "pose/handle_track.py",
    "character/palette.py",
    "character/rotation.py",
    "model/neighbours.py",
    "model/visible.py",
)
_EPOCH = (1980, 1, 1, 0, 0, 0)


def extension_files() -> Mapping[str, bytes]:
    """All files of the extension by their path in it.  Raises EXTENSION_MISSING where its sources
    are not."""
    sources = _sources()
    found = {
        path.relative_to(sources).as_posix(): path.read_bytes()
        for path in sorted(sources.rglob("*"))
        if path.suffix in (".py", ".toml") or path.name == "LICENSE"
    }
    package = Path(usdrigui.__file__).parent
    for name in _SHARED:
        found[f"maths/{Path(name).name}"] = (package / name).read_bytes()
    found[f"package/usdrigui-{__version__}-py3-none-any.whl"] = _archive(_wheel_files())
    return found


def write_extension(target: Path) -> None:
    """Write the archive that Blender installs, the same bytes every time.

    Raises EXTENSION_MISSING, FILE_TARGET for the name of a USD file, and FILE_ codes of writing as
    every output does.
    """
    files = {f"{NAME}/{name}": content for name, content in extension_files().items()}
    write_file(_archive(files), target, sorted(_sources().iterdir()))


def _archive(files: Mapping[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(files.items()):
            archive.writestr(zipfile.ZipInfo(name, _EPOCH), content, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def _wheel_files() -> dict[str, bytes]:
    """This package as a wheel holds it, with the schema, without sample and extension."""
    package = Path(usdrigui.__file__).parent
    left_out = {"__pycache__", "blender", "sample_assets", "schemas"}
    found = {
        f"usdrigui/{path.relative_to(package).as_posix()}": path.read_bytes()
        for path in package.rglob("*")
        if path.is_file() and left_out.isdisjoint(path.relative_to(package).parts)
    }
    for name in ("plugInfo.json", "generatedSchema.usda", "schema.usda"):
        found[f"usdrigui/schemas/{name}"] = (schema_path() / name).read_bytes()
    about = f"usdrigui-{__version__}.dist-info"
    found[f"{about}/METADATA"] = "\n".join(
        [
            "Metadata-Version: 2.1",
            "Name: usdrigui",
            f"Version: {__version__}",
            *(f"Requires-Dist: {each}" for each in _requirements()),
            "",
        ]
    ).encode()
    found[f"{about}/WHEEL"] = b"Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    found[f"{about}/RECORD"] = "".join(f"{name},,\n" for name in sorted(found)).encode()
    return found


def _requirements() -> list[str]:
    """What the package needs, USD among it: as its distribution says, or in a source tree its
    project file."""
    project = Path(usdrigui.__file__).parent.parent / "pyproject.toml"
    if project.is_file():
        needed: list[str] = tomllib.loads(project.read_text("utf-8"))["project"]["dependencies"]
        return needed
    told = importlib.metadata.requires("usdrigui") or []
    return [each for each in told if "extra ==" not in each]


def _sources() -> Path:
    return shipped(f"blender/{NAME}", "blender_manifest.toml", "EXTENSION_MISSING")
