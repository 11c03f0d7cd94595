"""The file of a live link: what pages save is put into it, each with the revision that it means to
replace.

A revision is the digest of the content, so that a change by any program is seen, and one page
never replaces what another has written without having seen it (docs/decisions/079).
"""

from __future__ import annotations

import hashlib
import re
import threading
from collections.abc import Iterable
from pathlib import Path

from usdrigui.errors import refuse
from usdrigui.isolation.foreign_file import whole_content
from usdrigui.reader.reader_process import shared_isolated
from usdrigui.replacing.transaction import check_not_read, check_own, commit, file_error
from usdrigui.settings import ReadSettings

_STRING = r'"(?:[^"\\\x00-\x1f\x7f\ud800-\udfff]|\\["\\n])*"'
_STRINGS = rf"\[(?:{_STRING}(?:, {_STRING})*)?\]"
_NUMBERS = r"[-+.,e\d ()\[\]]+"
"""Numbers, tuples and arrays of them, and what USD reads as none."""
_LINE = re.compile(
    rf"(?:#usda 1\.0|\(| *(?:[{{}})]?|defaultPrim = {_STRING}"
    rf"|(?:startTimeCode|endTimeCode|timeCodesPerSecond|framesPerSecond) = {_NUMBERS}"
    rf"|customLayerData = {{|dictionary usdrigui = {{|string work = {_STRING}"
    rf"|(?:string\[\] own|uniform token\[\] (?:blendShapes|joints)) = {_STRINGS}"
    rf"|(?:over|def SkelAnimation) {_STRING}(?: \()?"
    r'|prepend apiSchemas = \["SkelBindingAPI"\]|rel skel:animationSource = <(?:/\w+)+>'
    r"|(?:float\[\] blendShapeWeights|quatf\[\] rotations|half3\[\] scales|float3\[\] translations"
    r"|double rigUI:control:\w+:value)"
    rf"(?: = {_NUMBERS}|\.timeSamples = {{)|{_NUMBERS}: {_NUMBERS}))"
)
"""Lines that viewer/src/animation_layer.js writes: overs, SkelAnimations, their bindings and
samples.  No layer, asset or plug-in can be named in them."""


class LiveFile:
    """One file that pages and programs share.  `read` are the files that the run has read, none of
    which is ever replaced."""

    def __init__(self, path: Path, read: Iterable[Path | str], opening: ReadSettings) -> None:
        """Raises FILE_TARGET for a file that was read, is not named .usda, or is no animation layer
        of the viewer."""
        self.path, self._read, self._opening = path, tuple(read), opening
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

    def told(self, content: bytes) -> str:
        """What a page needs of the content, by `usdrigui.layer.shared_animation.told`; nothing of
        none.  Raises RigUIError with a FILE_ or SOURCE_ code."""
        return shared_isolated("told", self.path, self._opening, content) if content else ""

    def replace(self, part: bytes, known: str) -> str:
        """Put what a page saves into the file if its revision is `known`, and return the new one;
        nothing where it is not.

        Raises RigUIError with a FILE_ or SOURCE_ code, FILE_NOT_USD where `part` is no animation;
        what the file held is untouched then.
        """
        with self._lock:
            held = self.content()
            if self._closed or revision(held) != known:
                return ""
            # In whatever order: USD reads them afterwards.
            lines = part.decode(errors="surrogateescape").split("\n")
            if b" own = " not in part or not all(map(_LINE.fullmatch, lines)):
                raise refuse("FILE_NOT_USD", self.path, "is to get what is no animation layer")
            made = shared_isolated("merged", self.path, self._opening, held, part).encode()
            if self.content() != held:
                return ""
            commit(made, self.path, read=self._read)
            return revision(made)

    def close(self) -> None:
        """Let a replacement that has begun end, and none begin."""
        with self._lock:
            self._closed = True


def revision(content: bytes) -> str:
    """Digest of what the file holds, as HTTP has it."""
    return f'"{hashlib.sha256(content).hexdigest()}"'
