"""A layout as a payload of its asset, in the variant ``rigUI = ui``: a shot that selects ``none``
opens no file of it.

Here is the edit of the asset's root layer, both of its specs and of its text, as
`usdrigui.usd.attach` needs it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from pxr import Sdf

from usdrigui.errors import refuse
from usdrigui.usd import schema
from usdrigui.usd.variant_paths import asset_selections

_SELECTION = """\
{indent}    variants = {{
{indent}        string rigUI = "ui"
{indent}    }}
{indent}    prepend variantSets = "rigUI\""""
"""What the metadata of the SkelRoot get."""
_VARIANTS = """\
{indent}    variantSet "rigUI" = {{
{indent}        "none" {{
{indent}        }}
{indent}        "ui" (
{indent}            prepend payload = @{path}@<{root}>
{indent}        ) {{
{indent}        }}
{indent}    }}"""
"""The first lines of its body."""
_TOKEN = re.compile(
    r"""#[^\n]*|'''(?:\\.|[^\\])*?'''|"{3}(?:\\.|[^\\])*?"{3}|"""
    r"""'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*\""""
    r"|@@@.*?@@@|@[^@\n]*@|\w+|[=()\[\]{}]",
    re.DOTALL,
)
"""Comments, strings, asset paths, words and brackets of a text layer."""


@dataclass(frozen=True)
class PayloadOf:
    """A payload in the variant ``rigUI = ui`` of a SkelRoot."""

    root: str
    path: str
    """The payload as text of the asset's root layer."""


def tokens(text: str) -> Iterator[re.Match[str]]:
    """Strings, asset paths, words and brackets of a text layer; no comments, as its first line is
    one."""
    return (found for found in _TOKEN.finditer(text) if not found[0].startswith("#"))


def payloads_of(asset: Sdf.Layer, leads: Callable[[str], bool]) -> tuple[PayloadOf, ...]:
    """The payloads in variants ``rigUI = ui`` of the layer whose asset path `leads` to a layout."""
    found: list[PayloadOf] = []

    def look(path: Sdf.Path) -> None:
        if not path.IsPrimVariantSelectionPath():
            return
        if path.GetVariantSelection() == (schema.VARIANTS, schema.WITH):
            found.extend(
                PayloadOf(str(path.StripAllVariantSelections()), each.assetPath)
                for each in asset.GetPrimAtPath(path).payloadList.GetAddedOrExplicitItems()
                if leads(each.assetPath)
            )

    asset.Traverse(Sdf.Path.absoluteRootPath, look)
    return tuple(found)


def check_reachable(layer: Path, opened: Sdf.Layer, variant_path: str, root: str) -> None:
    """Refuse with ATTACH_OUTSIDE a layout that a payload of its SkelRoot would bring in without the
    prims and variants that it refers to."""
    above = Sdf.Path(variant_path or root)
    if asset_selections(str(above.GetPrimPath().GetParentPath())):
        raise refuse("ATTACH_OUTSIDE", str(layer), f"is authored in a variant above {root}")

    def look(path: Sdf.Path) -> None:
        if path.IsTargetPath() and not path.targetPath.HasPrefix(Sdf.Path(root)):
            raise refuse("ATTACH_OUTSIDE", str(layer), f"refers to {path.targetPath}")

    opened.Traverse(Sdf.Path(root), look)


# --- of specs -------------------------------------------------------------------------------------


def add(asset: Sdf.Layer, payloads: Sequence[PayloadOf]) -> None:
    """Author the payloads, with the variants that hold them, the first selected."""
    for each in payloads:
        prim = Sdf.CreatePrimInLayer(asset, each.root)
        prim.variantSelections[schema.VARIANTS] = schema.WITH
        if schema.VARIANTS not in prim.variantSetNameList.GetAddedOrExplicitItems():
            prim.variantSetNameList.Prepend(schema.VARIANTS)
        if schema.VARIANTS not in prim.variantSets:
            Sdf.VariantSetSpec(prim, schema.VARIANTS)
        own = prim.variantSets[schema.VARIANTS]
        for name in (schema.WITHOUT, schema.WITH):
            if name not in own.variants:
                Sdf.VariantSpec(own, name)
        own.variants[schema.WITH].primSpec.payloadList.Prepend(Sdf.Payload(each.path, each.root))


def remove(asset: Sdf.Layer, payloads: Sequence[PayloadOf]) -> None:
    """Take the payloads out, with the variants and the overs that are empty then."""
    for each in payloads:
        prim = asset.GetPrimAtPath(each.root)
        variants = prim.variantSets[schema.VARIANTS].variants
        listed = variants[schema.WITH].primSpec.payloadList
        for item in listed.GetAddedOrExplicitItems():
            if item.assetPath == each.path:
                listed.RemoveItemEdits(item)
        if all(_empty(variant.primSpec) for variant in variants):
            del prim.variantSets[schema.VARIANTS]
            prim.variantSetNameList.RemoveItemEdits(schema.VARIANTS)
            del prim.variantSelections[schema.VARIANTS]
        while prim.path != Sdf.Path.absoluteRootPath and _empty(prim):
            parent = asset.GetPrimAtPath(prim.path.GetParentPath())
            del parent.nameChildren[prim.name]
            prim = parent


def _empty(prim: Sdf.PrimSpec) -> bool:
    return bool(prim.specifier == Sdf.SpecifierOver and prim.isInert)


# --- of the text ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Found:
    """Where the text of a prim is, in characters."""

    name_end: int
    metadata: int | None
    """After its opening bracket; None where it has none."""
    body: int


def with_payloads(text: str, payloads: Sequence[PayloadOf]) -> str:
    """The text of a layer with the payloads, as `add` authors them; other text stays as it is."""
    for each in payloads:
        text = _with_payload(text, each)
    return text


def without_payloads(text: str, payloads: Sequence[PayloadOf]) -> str:
    """The text without what `with_payloads` added."""
    for each in payloads:
        text = _without_payload(text, each)
    return text


def _with_payload(text: str, payload: PayloadOf) -> str:
    names = _names(payload)
    found, end = _find(text, names)
    if len(found) < len(names):
        end = len(text[:end].rstrip(" ")) if found else end
        return text[:end] + _overs(payload, len(found)) + text[end:]
    variants, bracketed, selection = _pieces(payload)
    at = found[-1]
    text = text[: at.body] + variants + text[at.body :]
    if at.metadata is None:
        return text[: at.name_end] + bracketed + text[at.name_end :]
    return text[: at.metadata] + selection + text[at.metadata :]


def _without_payload(text: str, payload: PayloadOf) -> str:
    names = _names(payload)
    overs = (_overs(payload, known) for known in range(len(names)))
    if piece := next((piece for piece in overs if piece in text), None):
        return text.replace(piece, "")
    found, _ = _find(text, names)
    if len(found) < len(names):
        return text
    variants, bracketed, selection = _pieces(payload)
    at = found[-1]
    text = text[: at.body] + text[at.body :].removeprefix(variants)
    if at.metadata is None or text.startswith(bracketed, at.name_end):
        return text[: at.name_end] + text[at.name_end :].removeprefix(bracketed)
    return text[: at.metadata] + text[at.metadata :].removeprefix(selection)


def _names(payload: PayloadOf) -> list[str]:
    """Of its SkelRoot and the prims above it, the topmost first."""
    return payload.root.lstrip("/").split("/")


def _pieces(payload: PayloadOf) -> tuple[str, str, str]:
    """What the text of a SkelRoot gets: in its body, as its metadata, and in those that it has."""
    indent = "    " * (payload.root.count("/") - 1)
    selection = "\n" + _SELECTION.format(indent=indent)
    variants = "\n" + _VARIANTS.format(indent=indent, path=payload.path, root=payload.root)
    return variants, f" ({selection}\n{indent})", selection


def _overs(payload: PayloadOf, known: int) -> str:
    """An over of the SkelRoot, in overs of all above it but the first `known`."""
    names = _names(payload)
    indents = ["    " * level for level in range(len(names))]
    variants, bracketed, _ = _pieces(payload)
    above = range(known, len(names) - 1)
    opened = "".join(f'\n{indents[i]}over "{names[i]}"\n{indents[i]}{{' for i in above)
    closed = "".join(f"{indents[i]}}}\n" for i in reversed(above))
    last = indents[-1]
    own = f'\n{last}over "{names[-1]}"{bracketed}\n{last}{{{variants}\n{last}}}\n'
    return opened + own + closed


def _find(text: str, names: Sequence[str]) -> tuple[list[_Found], int]:
    """The specs of a prim and of those above it, the topmost first, as far as the text has them;
    and the end of the body of the last (of the text if there is none)."""
    found: list[_Found] = []
    depth, header, name, metadata = 0, 0, (-1, ""), None
    for token in tokens(text):
        word = token[0]
        if not depth and word in ("def", "over", "class"):
            header, name, metadata = 1, (-1, ""), None
        elif not depth and header and name[0] < 0 and word[0] in "\"'":
            name = (token.end(), word[1:-1])
        elif not depth and header and name[0] < 0:
            header = (header + 1) % 3 if word.isidentifier() else 0  # one word is the type
        elif not depth and header and word == "{" and name[1] == names[len(found)]:
            found.append(_Found(name[0], metadata, token.end()))
            header = 0
            if len(found) == len(names):
                return found, -1
            continue
        elif not depth and header and word == "(":
            metadata = token.end()
        depth += (word in "([{") - (word in ")]}")
        if depth < 0:
            return found, token.start()
        header = 0 if word == "}" and not depth else header
    return found, len(text)
