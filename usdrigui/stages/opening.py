"""Opening a stage for reading, with every way in which that fails named."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType

from pxr import Ar, Pcp, Sdf, Tf, Usd, UsdUtils

from usdrigui.errors import Issue, RigUIError, issue, refuse
from usdrigui.stages.variants import select

_ADDRESS = re.compile("0x[0-9a-fA-F]{6,}")
"""Differs from run to run."""
_NAMED = re.compile(
    r"Could not (?:open asset|load sublayer) @(@@)?(?P<path>.+?)@\1? (?:for|of) ", re.DOTALL
)
"""Which layer an error of composition is about; Pcp gives Python only its text."""
_MISSING = (
    Pcp.ErrorInvalidSublayerPath,
    Pcp.ErrorInvalidAssetPath,
)


def open_stage(path: Path, variants: Mapping[str, str] = MappingProxyType({})) -> Usd.Stage:
    """The composed stage of a file, payloads loaded, with `variants` selected (`read.variants`).

    Raises RigUIError FILE_NOT_FOUND, FILE_NAME, FILE_NOT_USD, FILE_CORRUPT (a usdz whose checksums
    are wrong), LAYER_MISSING or LAYER_UNREADABLE (a sublayer of the root layer stack),
    VARIANT_UNKNOWN.
    """
    _check_file(path)
    try:
        stage = Usd.Stage.Open(str(path), Usd.Stage.LoadAll)
    except (Tf.ErrorException, RuntimeError) as error:
        raise refuse("FILE_NOT_USD", path, usd_message(error)) from None
    for fault in stage.GetCompositionErrors():
        if isinstance(fault, Pcp.ErrorInvalidSublayerPath):
            raise _without_layer(str(path), _described(fault))
    select(stage, variants)
    return stage


def open_layer(path: Path) -> Sdf.Layer:
    """The file as it is now, as a layer that nobody else holds.  Raises RigUIError FILE_NOT_USD."""
    try:
        layer = Sdf.Layer.OpenAsAnonymous(str(path))
    except (Tf.ErrorException, RuntimeError) as error:
        raise refuse("FILE_NOT_USD", path, usd_message(error)) from None
    if layer is None:
        raise refuse("FILE_NOT_USD", path, "is not a USD layer")
    return layer


def spec_paths(layer: Sdf.Layer, top: str = "/") -> list[Sdf.Path]:
    """Of all that a layer itself says at a path and below it, variants among it."""
    found: list[Sdf.Path] = []
    layer.Traverse(Sdf.Path(top), found.append)
    return found


def composition_issues(stage: Usd.Stage, roots: tuple[Usd.Prim, ...]) -> tuple[Issue, ...]:
    """What USD could not compose; what is muted need not be there.

    Raises LAYER_MISSING or LAYER_UNREADABLE where a reference or payload on, above or below one of
    `roots` (on any prim if there are none) leads to no layer: the character would be read without a
    part of it.
    """
    found = []
    for error in stage.GetCompositionErrors():
        site, described = _site(error), _described(error)
        layer = _NAMED.search(described)
        if layer is not None and stage.IsLayerMuted(layer.group("path")):
            continue
        near = [
            root
            for root in roots
            if site.HasPrefix(root.GetPath()) or root.GetPath().HasPrefix(site)
        ]
        if isinstance(error, _MISSING) and (near or not roots):
            raise _without_layer(str(site), described)
        found.append(issue("COMPOSITION_ERROR", site, described))
    return tuple(found)


@contextmanager
def listening() -> Iterator[list[str]]:
    """Keep what USD would print while the block runs; the list holds the distinct texts
    afterwards."""
    messages: list[str] = []
    delegate = UsdUtils.CoalescingDiagnosticDelegate()
    try:
        yield messages
    finally:
        for each in delegate.TakeUncoalescedDiagnostics():
            try:
                text = _one_line(each.commentary)
            except UnicodeDecodeError:
                text = "a message that is not UTF-8"
            if text not in messages:
                messages.append(text)
        del delegate


def _check_file(path: Path) -> None:
    if not path.is_file():
        raise refuse("FILE_NOT_FOUND", path, "is not a file" if path.exists() else "does not exist")
    try:
        with path.open("rb") as stream:
            empty = not stream.read(1)
    except OSError as error:
        raise refuse("FILE_NOT_FOUND", path, f"cannot be read: {error.strerror}") from error
    if empty:
        raise refuse("FILE_NOT_USD", path, "the file is empty")
    if ":SDF_FORMAT_ARGS:" in str(path):
        raise refuse(
            "FILE_NAME", path, "USD would read the text after ':SDF_FORMAT_ARGS:' as arguments"
        )
    extension = path.suffix.removeprefix(".")
    if not extension or not Sdf.FileFormat.FindByExtension(extension):
        raise refuse("FILE_NOT_USD", path, f"USD has no reader for the extension {path.suffix!r}")
    if path.suffix.lower() == ".usdz":
        check_archive(path)


def check_archive(path: Path) -> None:
    """Refuse (FILE_CORRUPT) a usdz whose checksums are wrong, which USD itself ignores; nothing is
    extracted."""
    try:
        with zipfile.ZipFile(path) as archive:
            damaged = archive.testzip()
    except MemoryError:
        raise
    # Whatever zipfile, zlib, lzma or struct make of headers that contradict each other.
    except Exception as error:
        raise refuse("FILE_CORRUPT", path, f"is not a valid archive: {error}") from error
    if damaged:
        raise refuse("FILE_CORRUPT", path, f"the checksum of {damaged} is wrong")


def usd_message(error: Exception) -> str:
    """Text of a USD exception, whose own str() may fail."""
    try:
        return "; ".join(_one_line(each.commentary) for each in error.args)
    except (AttributeError, UnicodeDecodeError):
        pass
    try:
        return _one_line(str(error))
    except UnicodeDecodeError:
        return "USD raised an error whose text is not UTF-8"


def _without_layer(site: str, described: str) -> RigUIError:
    """The refusal for a layer that is not composed: it is not there, or USD cannot read it."""
    named = _NAMED.search(described)
    there = named is not None and bool(Ar.GetResolver().Resolve(named.group("path")))
    return refuse("LAYER_UNREADABLE" if there else "LAYER_MISSING", site, described)


def _described(error: Pcp.ErrorBase) -> str:
    try:
        return _one_line(str(error))
    except UnicodeDecodeError:
        return str(error.errorType)


def _one_line(text: str) -> str:
    """What USD says, as one line, without the addresses of its objects."""
    return _ADDRESS.sub("#", " ".join(text.split()))


def _site(error: Pcp.ErrorBase) -> Sdf.Path:
    try:
        return Sdf.Path(str(error.rootSite.path))
    except (AttributeError, TypeError, Tf.ErrorException):
        return Sdf.Path.absoluteRootPath
