"""A folder of small assets for batches: sound ones, a broken one, and one that another layer completes."""

import shutil

import skinned_stages
from pxr import Sdf


def folder_of(path, count=2):
    """`count` characters in folders of their own, and ``broken.usda``."""
    path.mkdir(parents=True, exist_ok=True)
    first = skinned_stages.character(path / "a0" / "char.usda") if _made(path / "a0") else None
    for index in range(1, count):
        shutil.copytree(path / "a0", path / f"a{index}")
    (path / "broken.usda").write_text("#usda 1.0\n(\n")
    return first


def split(path):
    """A root layer over the character of ``a0``, so that an asset has two files."""
    root = Sdf.Layer.CreateNew(str(path / "split.usda"))
    root.defaultPrim = "World"
    root.subLayerPaths.append("./a0/char.usda")
    root.Save()
    return path / "split.usda"


def _made(folder):
    folder.mkdir()
    return True
