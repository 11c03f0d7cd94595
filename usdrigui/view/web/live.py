"""The file of a live link: pages read it and replace it whole, each with the revision that it means
to replace.

A revision is the digest of the content, so that a change by any program is seen, and one page
never replaces what another has written without having seen it (docs/decisions/079).
"""

from __future__ import annotations

import hashlib
import re
import threading
from collections.abc import Iterable
from pathlib import Path

from usdrigui.isolation.foreign_file import whole_content
from usdrigui.replacing.transaction import check_not_read, check_own, commit, file_error

_STRING = r'"(?:[^"\\\x00-\x1f\x7f]|\\["\\n])*"'
_NUMBER = r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?"
_ITEM = rf"(?:{_NUMBER}|\({_NUMBER}(?:, {_NUMBER}){{2,3}}\))"
_HEADER = re.compile(
    rf"""#usda 1\.0
\(
    defaultPrim = {_STRING}
    startTimeCode = {_NUMBER}
    endTimeCode = {_NUMBER}
    timeCodesPerSecond = {_NUMBER}
    framesPerSecond = {_NUMBER}
    customLayerData = {{
        dictionary usdrigui = {{
            string work = {_STRING}
        }}
    }}
\)

"""
)
_CONTROL = r"double rigUI:control:\w+:value"
_PRIM = re.compile(rf"(?:over|def SkelAnimation) {_STRING}( \()?")
_BINDING = 'prepend apiSchemas = ["SkelBindingAPI"]'
_PROPERTY = re.compile(
    rf"uniform token\[\] (?:blendShapes|joints) = \[(?:{_STRING}(?:, {_STRING})*)?\]"
    r"|rel skel:animationSource = <(?:/\w+)+>"
    rf"|{_CONTROL} = {_NUMBER}"
)
_SAMPLED = re.compile(
    r"(?:float\[\] blendShapeWeights|quatf\[\] rotations|half3\[\] scales|float3\[\] translations"
    rf"|{_CONTROL})\.timeSamples = \{{"
)
_SAMPLE = re.compile(rf"{_NUMBER}: (?:{_NUMBER}|\[{_ITEM}(?:, {_ITEM})*\]),")


class LiveFile:
    """One file that pages share.  `read` are the files that the run has read, none of which is ever
    replaced."""

    def __init__(self, path: Path, read: Iterable[Path | str]) -> None:
        """Raises FILE_TARGET for a file that was read, is not named .usda, or is no animation layer
        of the viewer."""
        self.path, self._read = path, tuple(read)
        self._lock = threading.Lock()
        self._closed = False
        check_not_read([path], self._read)
        check_own(path, "an animation layer of the viewer", "string work = ")

    def content(self) -> bytes:
        """What the file holds; of none that is there, nothing.  Raises RigUIError with a FILE_
        code."""
        try:
            return whole_content(self.path, 256)
        except FileNotFoundError:
            return b""
        except OSError as error:
            raise file_error(self.path, error) from error

    def replace(self, text: bytes, known: str) -> str:
        """Let the file hold `text` if its revision is `known`, and return the new one; nothing
        where it is not.

        Raises RigUIError with a FILE_ code; what the file held is untouched then.
        """
        with self._lock:
            if self._closed or revision(self.content()) != known:
                return ""
            commit(text, self.path, read=self._read)
            return revision(text)

    def close(self) -> None:
        """Let a replacement that has begun end, and none begin."""
        with self._lock:
            self._closed = True


def revision(content: bytes) -> str:
    """Digest of what the file holds, as HTTP has it."""
    return f'"{hashlib.sha256(content).hexdigest()}"'


def animation(content: bytes) -> bytes | None:
    """The animation layer that a page saves, written anew from the lines in which it was read; None
    for anything else.

    Those are the lines that viewer/src/animation_layer.js writes: overs, SkelAnimations, their
    bindings and samples.  No layer, asset or plug-in can be named in them.
    """
    try:
        text = content.decode()
    except UnicodeDecodeError:
        return None
    header = _HEADER.match(text)
    if header is None or not text.endswith("\n"):
        return None
    lines = text[header.end() :].split("\n")[:-1]
    return "\n".join([header.group()[:-1], *lines, ""]).encode() if _are_prims(lines) else None


def _are_prims(lines: Iterable[str]) -> bool:
    """Whether the lines are prims of an animation, each below the one that it belongs to."""
    depth, rest = 0, iter(lines)
    for line in rest:
        margin = "    " * depth
        words = line.removeprefix(margin)
        prim = _PRIM.fullmatch(words)
        if prim is not None:
            metadata = [f"{margin}    {_BINDING}", f"{margin})"] if prim.group(1) else []
            if [next(rest, "") for _ in metadata] != metadata or next(rest, "") != f"{margin}{{":
                return False
            depth += 1
        elif depth and line == "    " * (depth - 1) + "}":
            depth -= 1
        elif depth and _SAMPLED.fullmatch(words):
            row = next(rest, "")
            while _SAMPLE.fullmatch(row.removeprefix(f"{margin}    ")):
                row = next(rest, "")
            if row != f"{margin}}}":
                return False
        elif not depth or not _PROPERTY.fullmatch(words):
            return False
    return depth == 0
