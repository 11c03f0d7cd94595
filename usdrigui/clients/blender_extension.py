"""The Blender extension as one file to install.

Its sources lie in ``blender/usdrigui_controls``; the mathematics of drags and rotations are usdrigui's own
modules, copied in here with their imports made relative, so that there is one source of each.
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
_COPIED = ("pose/drag.py", "pose/fit.py", "rotation.py")
_IMPORTS = (
    ("from usdrigui.model import", "from .arrays import"),
    ("from usdrigui.pose.fit import", "from .fit import"),
)
_EPOCH = (1980, 1, 1, 0, 0, 0)


def extension_files() -> Mapping[str, bytes]:
    """All files of the extension by their path in it.  Raises EXTENSION_MISSING where its sources are not."""
    sources = _sources()
    found = {
        path.relative_to(sources).as_posix(): path.read_bytes()
        for path in sorted(sources.rglob("*"))
        if path.suffix in (".py", ".toml")
    }
    package = Path(usdrigui.__file__).parent
    for name in _COPIED:
        found[f"maths/{Path(name).name}"] = _localised((package / name).read_text(encoding="utf-8")).encode()
    return found


def write_extension(target: Path) -> None:
    """Write the archive that Blender installs, the same bytes every time.

    Raises EXTENSION_MISSING, FILE_TARGET for the name of a USD file, and FILE_ codes of writing as every output does.
    """
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(extension_files().items()):
            archive.writestr(zipfile.ZipInfo(f"{NAME}/{name}", _EPOCH), content, zipfile.ZIP_DEFLATED)
    write_file(buffer.getvalue(), target)


def _sources() -> Path:
    """In an installed package inside it, in a source tree beside it."""
    package = Path(usdrigui.__file__).resolve().parent
    for folder in (package / "blender" / NAME, package.parent / "blender" / NAME):
        if (folder / "blender_manifest.toml").is_file():
            return folder
    raise refuse("EXTENSION_MISSING", str(package / "blender"), "the Blender extension is not there")


def _localised(text: str) -> str:
    for before, after in _IMPORTS:
        text = text.replace(before, after)
    if "usdrigui." in "".join(line for line in text.splitlines() if "import" in line):
        raise refuse("BUG", NAME, "a copied module imports what the extension does not have")
    return text
