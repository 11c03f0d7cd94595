"""The text of an asset's root layer with a sublayer more or less; all other bytes stay.

Whoever edits a text so has edited its layer by Sdf before, and uses the text only if both mean the
same (`means`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from pxr import Sdf, Tf

_HEAD = "(\n    subLayers = [\n        @{path}@\n    ]\n)\n"
"""What a layer without any metadata gets after its first line."""
_FIELD = "\n    subLayers = [\n        @{path}@\n    ]"
"""What one with metadata but without sublayers gets after the opening bracket."""
_ENTRY = "\n        @{path}@,"
"""What one with sublayers gets before the first of them."""
_TOKEN = re.compile(
    r"""#[^\n]*|'''(?:\\.|[^\\])*?'''|"{3}(?:\\.|[^\\])*?"{3}|"""
    r"""'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*\"|@@@.*?@@@|@[^@\n]*@|"""
    r"(?P<sublayers>\bsubLayers\s*=\s*\[)|[()\[\]{}]",
    re.DOTALL,
)
"""Comments, strings, asset paths and brackets."""


def means(text: str, layer: Sdf.Layer) -> bool:
    """Whether the text holds exactly what the layer holds."""
    parsed = Sdf.Layer.CreateAnonymous(".usda")
    try:
        return (
            bool(parsed.ImportFromString(text))
            and parsed.ExportToString() == layer.ExportToString()
        )
    except (Tf.ErrorException, RuntimeError, UnicodeError):
        return False


def with_sublayer(text: str, path: str) -> str:
    """The text of a layer with one sublayer before all others."""
    metadata, sublayers = _head(text)
    if sublayers is not None:
        return _inserted(text, sublayers, _ENTRY.format(path=path))
    if metadata is not None:
        return _inserted(text, metadata, _FIELD.format(path=path))
    first_line = len(text.partition("\n")[0]) + 1  # it names the format
    return _inserted(text, first_line, _HEAD.format(path=path))


def without_sublayers(text: str, paths: Sequence[str]) -> str:
    """The text without those sublayers, and without what held nothing but them."""
    for path in paths:
        pieces = (form.format(path=path) for form in (_HEAD, _FIELD, _ENTRY))
        text = text.replace(next((piece for piece in pieces if piece in text), ""), "", 1)
    return text


def _inserted(text: str, place: int, piece: str) -> str:
    return text[:place] + piece + text[place:]


# --- tokens ---------------------------------------------------------------------------------------


def _tokens(text: str) -> Iterator[tuple[re.Match[str], int]]:
    """All but comments (the first line is one), each with the brackets that it opens: -1 to 1."""
    for token in _TOKEN.finditer(text):
        if not token[0].startswith("#"):
            yield token, (token[0][-1] in "([{") - (token[0][-1] in ")]}")


def _head(text: str) -> tuple[int | None, int | None]:
    """Where the metadata of a layer begin, and in them the list of sublayers; None without."""
    tokens, depth = _tokens(text), 1
    first, _ = next(tokens, (None, 0))
    if first is None or first[0] != "(":
        return None, None
    for token, opened in tokens:
        if depth == 1 and token["sublayers"]:
            return first.end(), token.end()
        depth += opened
        if not depth:
            break
    return first.end(), None
