"""The text of an asset's root layer with a sublayer or references more or less; all other bytes
stay.

Whoever edits a text so has edited its layer by Sdf before, and uses the text only if both mean the
same (`means`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from pxr import Sdf, Tf

_HEAD = "(\n    subLayers = [\n        @{path}@\n    ]\n)\n"
"""What a layer without any metadata gets after its first line."""
_FIELD = "\n    subLayers = [\n        @{path}@\n    ]"
"""What one with metadata but without sublayers gets after the opening bracket."""
_ENTRY = "\n        @{path}@,"
"""What one with sublayers gets before the first of them."""
_SELECTION = """
{indent}    variants = {{
{indent}        string rigUI = "none"
{indent}    }}
{indent}    prepend variantSets = "rigUI\""""
"""What the metadata of a SkelRoot with a reference get."""
_VARIANTS = """
{indent}    variantSet "rigUI" = {{
{indent}        "none" {{
{indent}        }}
{indent}        "ui" (
{indent}            prepend references = @{path}@<{root}>
{indent}        ) {{
{indent}        }}
{indent}    }}"""
"""The first lines of its body."""
_TOKEN = re.compile(
    r"""#[^\n]*|'''(?:\\.|[^\\])*?'''|"{3}(?:\\.|[^\\])*?"{3}|"""
    r"""'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*\"|@@@.*?@@@|@[^@\n]*@|"""
    r"""\b(?:def|over|class)\b(?:\s+\w+)?\s*"(?P<prim>\w+)"|"""
    r"(?P<sublayers>\bsubLayers\s*=\s*\[)|[()\[\]{}]",
    re.DOTALL,
)
"""Comments, strings, asset paths, the heads of prims, and brackets."""


@dataclass(frozen=True)
class ReferenceOf:
    """A reference in the variant ``rigUI = ui`` of a SkelRoot."""

    root: str
    path: str
    """The reference as text of the asset's root layer."""

    @property
    def names(self) -> list[str]:
        """Of its SkelRoot and the prims above it, the topmost first."""
        return self.root.lstrip("/").split("/")


@dataclass(frozen=True)
class _Span:
    """Where the text of a prim is, in characters."""

    name_end: int
    metadata: int | None
    """After its opening bracket; None where it has none."""
    body: int


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


def with_references(text: str, references: Sequence[ReferenceOf]) -> str:
    """The text of a layer with the references, as `references.add` authors them."""
    for reference in references:
        spans, end = _spans(text, reference.names)
        if len(spans) < len(reference.names):
            end = len(text[:end].rstrip(" ")) if spans else end
            text = _inserted(text, end, _overs(reference, len(spans)))
            continue
        for place, piece in _pieces(text, spans[-1], reference, added=True):
            text = _inserted(text, place, piece)
    return text


def without_references(text: str, references: Sequence[ReferenceOf]) -> str:
    """The text without what `with_references` added."""
    for reference in references:
        overs = (_overs(reference, known) for known in range(len(reference.names)))
        text = text.replace(next((piece for piece in overs if piece in text), ""), "", 1)
        spans, _ = _spans(text, reference.names)
        if len(spans) == len(reference.names):
            for place, piece in _pieces(text, spans[-1], reference, added=False):
                text = text[:place] + text[place:].removeprefix(piece)
    return text


def _inserted(text: str, place: int, piece: str) -> str:
    return text[:place] + piece + text[place:]


def _pieces(
    text: str, span: _Span, reference: ReferenceOf, *, added: bool
) -> Iterator[tuple[int, str]]:
    """What the text of a SkelRoot gets, or has `added`, and where; the last first."""
    selection, bracketed, variants = _opinions(reference)
    yield span.body, variants
    alone = added or text.startswith(bracketed, span.name_end)
    if span.metadata is None or (not added and alone):
        yield span.name_end, bracketed
    else:
        yield span.metadata, selection


def _opinions(reference: ReferenceOf) -> tuple[str, str, str]:
    """What a SkelRoot gets: in metadata that it has, as its metadata, and in its body."""
    indent = "    " * (len(reference.names) - 1)
    selection = _SELECTION.format(indent=indent)
    variants = _VARIANTS.format(indent=indent, path=reference.path, root=reference.root)
    return selection, f" ({selection}\n{indent})", variants


def _overs(reference: ReferenceOf, known: int) -> str:
    """An over of the SkelRoot, in overs of all above it but the first `known`."""
    _, bracketed, variants = _opinions(reference)
    indent = "    " * (len(reference.names) - 1)
    overs = f'\n{indent}over "{reference.names[-1]}"{bracketed}\n{indent}{{{variants}\n{indent}}}\n'
    for level in reversed(range(known, len(reference.names) - 1)):
        indent = "    " * level
        overs = f'\n{indent}over "{reference.names[level]}"\n{indent}{{{overs}{indent}}}\n'
    return overs


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


def _spans(text: str, names: Sequence[str]) -> tuple[list[_Span], int]:
    """Where a prim and those above it are, the topmost first, as far as the text has them; and the
    end of the body of the last (of the text if there is none)."""
    spans: list[_Span] = []
    depth, name, name_end, metadata = 0, "", 0, None
    for token, opened in _tokens(text):
        if not depth and token["prim"]:
            name, name_end, metadata = token["prim"], token.end(), None
        elif not depth and token[0] == "(":
            metadata = token.end()
        elif not depth and token[0] == "{" and name == names[len(spans)]:
            spans.append(_Span(name_end, metadata, token.end()))
            if len(spans) == len(names):
                return spans, -1
            name, opened = "", 0
        depth += opened
        if depth < 0:
            return spans, token.start()
    return spans, len(text)
