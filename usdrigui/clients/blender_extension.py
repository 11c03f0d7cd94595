"""The Blender extension as one file to install.

Its sources lie in ``blender/usdrigui_controls``; the rules of drags, tracks, rotations and
levels and the colours are usdrigui's own files, which need numpy only and go in as they are.
"""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path

import usdrigui
from usdrigui.errors import refuse
from usdrigui.pipeline import write_file

NAME = "usdrigui_controls"
"""Folder in the archive, and the extension's id."""
_SHARED = (
    "pose/drag.py",
    "pose/handle_track.py",
    "character/palette.py",
    "character/rotation.py",
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
        if path.suffix in (".py", ".toml")
    }
    package = Path(usdrigui.__file__).parent
    for name in _SHARED:
        found[f"maths/{Path(name).name}"] = (package / name).read_bytes()
    return found


def write_extension(target: Path) -> None:
    """Write the archive that Blender installs, the same bytes every time.

    Raises EXTENSION_MISSING, FILE_TARGET for the name of a USD file, and FILE_ codes of writing as
    every output does.
    """
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(extension_files().items()):
            archive.writestr(
                zipfile.ZipInfo(f"{NAME}/{name}", _EPOCH), content, zipfile.ZIP_DEFLATED
            )
    write_file(buffer.getvalue(), target, sorted(_sources().iterdir()))


def _sources() -> Path:
    """In an installed package inside it, in a source tree beside it."""
    package = Path(usdrigui.__file__).resolve().parent
    for folder in (package / "blender" / NAME, package.parent / "blender" / NAME):
        if (folder / "blender_manifest.toml").is_file():
            return folder
    raise refuse(
        "EXTENSION_MISSING", str(package / "blender"), "the package holds no Blender extension"
    )
