"""From layouts to the layer that any UsdSkel application can show.

`write_layout` is the whole way to a file, `layer_for` stops at the layer, `stage_metadata` says
what the layer must repeat of its source.  schemas/CONTRACT.md describes the result;
`usdrigui.layer.read_layout` is the way back.
"""

from __future__ import annotations

import functools
import json
import os
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from pxr import Sdf, Tf, UsdGeom

from usdrigui.character import Body, Control, Rig
from usdrigui.errors import refuse
from usdrigui.layer import author
from usdrigui.layer.control_api import author_control_api, author_limits
from usdrigui.layer.drawing import (
    DrawnElement,
    author_drawing,
    drawing_about,
    drawing_name,
    drawings,
)
from usdrigui.layer.drawn import drawn_parts
from usdrigui.layer.skin_binding import SkinBinding
from usdrigui.model import Element, Layout, Member
from usdrigui.model.levels import inner_names
from usdrigui.replacing.transaction import State, commit, file_error
from usdrigui.stages import schema
from usdrigui.version import __version__

SIGNATURE = "usdrigui"
"""Key in the customLayerData of every layout layer that we write."""
_METADATA = (
    "defaultPrim",
    "upAxis",
    "metersPerUnit",
    "kilogramsPerUnit",
    "startTimeCode",
    "endTimeCode",
    "timeCodesPerSecond",
    "framesPerSecond",
    "colorConfiguration",
    "colorManagementSystem",
    "expressionVariables",
)
"""What USD reads from the root layer of a stage only, and a layer over the source must therefore
repeat."""

_ABOUT = "Rig controls on the character; the variant rigUI = none of its SkelRoot hides them."

Laid = Sequence[tuple[Rig, Layout]]


def write_layout(
    laid: Laid,
    source: Path,
    target: Path,
    metadata: Mapping[str, Any],
    *,
    bare: bool = False,
    write: Callable[..., State] = commit,
) -> State:
    """Write the layouts of one asset to `target`, atomically, over its `source`.

    `metadata` is `stage_metadata` of the source's root layer.  The source is sublayered by a
    relative path unless `bare`.  `write` is `commit`, or `stage` of a
    transaction with other files. Raises RigUIError with a FILE_ code or SOURCE_UNREFERABLE.
    """
    layer = layer_for(laid, "" if bare else relative_asset_path(source, target), metadata)
    content = layer_bytes(layer, target.suffix, str(target))
    roots = [layout.path_in_variants for _, layout in laid]
    return write(content, target, verify=functools.partial(holds_layouts, roots))


def layer_for(laid: Laid, source: str, metadata: Mapping[str, Any]) -> Sdf.Layer:
    """An anonymous layer with the layouts of one asset.

    `source` is the asset path to sublayer, taken as it is; where it is empty the layer stands alone
    for others to sublayer.  The same input gives the same bytes.
    """
    layer = Sdf.Layer.CreateAnonymous(".usda")
    with Sdf.ChangeBlock():
        author_metadata(layer, metadata, laid)
        if source:
            layer.subLayerPaths.append(source)
        for rig, layout in laid:
            _author_layout(layer, rig, layout)
    return layer


def stage_metadata(layer: Sdf.Layer) -> dict[str, Any]:
    """What a layer over `layer` must repeat, as plain Python values.

    Up axis and unit are written even where the source leaves them to USD's fallbacks.
    """
    root = layer.pseudoRoot
    found: dict[str, Any] = {
        "upAxis": str(UsdGeom.GetFallbackUpAxis()),
        "metersPerUnit": float(UsdGeom.LinearUnits.centimeters),
    }
    found |= {key: root.GetInfo(key) for key in _METADATA if root.HasInfo(key)}
    for key, value in found.items():
        if isinstance(value, Sdf.AssetPath):
            found[key] = value.path
    return found


def relative_asset_path(source: Path, target: Path) -> str:
    """Asset path by which a layer at `target` refers to the file `source`: relative, with forward
    slashes.

    Raises SOURCE_UNREFERABLE for names that USD cannot refer to.
    """
    # A link keeps its name: what it refers to lies beside it.
    here = source.parent.resolve() / source.name
    path = os.path.relpath(here, target.parent.resolve()).replace(os.sep, "/")
    if ":SDF_FORMAT_ARGS:" in path or "@@@" in path or any(ord(char) < 32 for char in path):
        raise refuse("SOURCE_UNREFERABLE", source, "its name is reserved by USD")
    return path if path.startswith("../") else f"./{path}"


def layer_bytes(layer: Sdf.Layer, suffix: str, name: str = "") -> bytes:
    """The content of a layer as a file of that suffix: ``.usda`` as text, ``.usdc`` and ``.usd`` as
    crate.

    A refusal calls the file by its ``name``.

    Raises FILE_TARGET for any other suffix, and another FILE_ code when there is no room for a
    temporary.
    """
    if suffix == ".usda":
        return str(layer.ExportToString()).encode()
    if suffix not in (".usd", ".usdc"):
        raise refuse("FILE_TARGET", name or suffix, "a layout layer ends in .usda, .usdc or .usd")
    try:
        # USD writes crates to files only, and must never write to the final one.
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "layout.usdc"
            layer.Export(str(path))
            return path.read_bytes()
    except OSError as error:
        raise file_error(Path(tempfile.gettempdir()), error) from error
    except Tf.ErrorException:
        raise refuse(
            "FILE_WRITE", tempfile.gettempdir(), "USD cannot write a temporary crate"
        ) from None


def holds_layouts(roots: Sequence[str], path: Path) -> bool:
    """Whether the file is a layer with a layout below each of the SkelRoots."""
    layer = Sdf.Layer.OpenAsAnonymous(str(path))
    return all(
        any(
            layer.GetPrimAtPath(path.AppendChild(schema.SCOPE))
            for path in (_inside(Sdf.Path(root)), Sdf.Path(root))
        )
        for root in roots
    )


def author_variant(layer: Sdf.Layer, root: str) -> Sdf.PrimSpec:
    """The variant of a SkelRoot that holds its layout: whoever selects the other one is not
    troubled by it.

    `root` may hold variants of the asset's own, inside which it then is; which of these is selected
    the asset decides.
    """
    spec = Sdf.CreatePrimInLayer(layer, root)
    if schema.VARIANTS not in spec.variantSets:
        for name in (schema.WITHOUT, schema.WITH):
            Sdf.CreateVariantInLayer(layer, spec.path, schema.VARIANTS, name)
        spec.variantSelections[schema.VARIANTS] = schema.WITH
    return layer.GetPrimAtPath(_inside(spec.path))


def _inside(root: Sdf.Path) -> Sdf.Path:
    return root.AppendVariantSelection(schema.VARIANTS, schema.WITH)


# --- the layer ------------------------------------------------------------------------------------


def author_metadata(layer: Sdf.Layer, metadata: Mapping[str, Any], laid: Laid) -> None:
    """What USD reads from the root layer only, and our own version."""
    root = layer.pseudoRoot
    if laid:
        # A source may do without; whoever references the layer then still gets the character.
        root.SetInfo("defaultPrim", Sdf.Path(laid[0][1].root).GetPrefixes()[0].name)
    for key in _METADATA:
        if key in metadata:
            value = metadata[key]
            # Some exporters write metersPerUnit as float, which USD's own API then refuses to read.
            root.SetInfo(key, float(value) if isinstance(value, (int, float)) else value)
    root.SetInfo("customLayerData", {SIGNATURE: {"version": __version__}})


def _author_layout(layer: Sdf.Layer, rig: Rig, layout: Layout) -> None:
    """The Scope of one character with all its elements."""
    root = author_variant(layer, layout.path_in_variants)
    author_limits(root, rig)
    taken: set[str] = set()
    parts = {author.identifier(each.name, taken): each for each in layout.frame.parts}
    applied = (schema.LAYOUT, *(f"{schema.PART}:{instance}" for instance in parts))
    scope = author.prim(root, schema.SCOPE, "Scope", applied)
    scope.SetInfo("documentation", _ABOUT)
    author.put(scope, "purpose", "token", "guide", uniform=True)
    frame = layout.frame
    # RigUILayoutAPI: where and how large the elements are.
    whole = {
        "skeleton": [skeleton.path for skeleton in rig.body.skeletons],
        "space": frame.space,
        "viewDirection": frame.view,
        "planeOrigin": frame.plane.origin,
        "planeNormal": frame.plane.normal,
        "handleWidth": min([frame.handle_width, *(part.handle_width for part in frame.parts)]),
    }
    author.declare(scope, schema.LAYOUT, whole | account(rig, layout))
    for instance, part in parts.items():
        name = "" if part.name == instance else part.name
        own = {"name": name, "handleWidth": part.handle_width, "viewDirection": part.view}
        author.declare(scope, schema.PART, own, instance)
    author.note(scope, record(layout))
    subsets = author_elements(scope, rig, layout, layout.elements)
    paths = [_plain(child.path) for mesh in scope.nameChildren for child in mesh.nameChildren]
    if subsets != [each for each in paths if each in subsets]:
        author.declare(scope, schema.LAYOUT, {"elements": subsets})


def _plain(path: Sdf.Path) -> Sdf.Path:
    return path.StripAllVariantSelections()


def account(rig: Rig, layout: Layout) -> dict[str, Any]:
    """RigUILayoutAPI: every control of the character, and the base pose."""
    return {
        "baseControls": list(rig.control_names),
        "baseValues": layout.base_values if np.any(layout.base_values) else (),
    }


def record(layout: Layout) -> str:
    """What only usdrigui itself asks of a layout, as JSON: how it was found, and what was left
    off."""
    parts = [(part.status, part.cost, part.bound) for part in layout.frame.parts]
    found = {
        "proof": layout.proof,
        "parts": parts,
        "leftOff": layout.left_off,
        "matches": layout.matches,
    }

    def short(text: str) -> float:
        return float(f"{float(text):.7g}")  # the last digits depend on the processor

    told = json.dumps(msgspec.to_builtins(found))
    return json.dumps(json.loads(told, parse_float=short))


def author_elements(
    scope: Sdf.PrimSpec,
    rig: Rig,
    layout: Layout,
    elements: Sequence[Element],
    taken: Iterable[str] = (),
) -> list[Sdf.Path]:
    """Some elements of a layout and the meshes that draw them; returns their paths.  `taken` are
    other names."""
    skin = SkinBinding(rig, layout)
    used = set(taken)
    names = [author.identifier(element.name, used) for element in elements]
    inner = inner_names(layout.elements)
    drawn = [
        DrawnElement(each, each.name in inner, drawn_parts(skin, each, layout.frame))
        for each in elements
    ]
    subsets: dict[int, Sdf.PrimSpec] = {}
    needed = drawings(drawn)
    for drawing in needed:
        name = author.identifier(drawing_name(drawing, needed), used)
        mesh = author.prim(scope, name, "Mesh", (schema.DRAWING, "SkelBindingAPI"))
        mesh.SetInfo("documentation", drawing_about(drawing))
        author.declare(mesh, schema.DRAWING, {"part": drawing.part})
        if drawing.inner:
            # Applications that know nothing of levels show the first one.
            author.put(mesh, "visibility", "token", "invisible")
        subsets |= author_drawing(mesh, rig.body, drawing, drawn, names)
    paths = {element.name: _plain(subsets[i].path) for i, element in enumerate(elements)}
    for i, element in enumerate(elements):
        _author_element(subsets[i], rig.body, skin, element, paths)
    return list(paths.values())


def _author_element(
    subset: Sdf.PrimSpec,
    body: Body,
    skin: SkinBinding,
    element: Element,
    paths: Mapping[str, Sdf.Path],
) -> None:
    """The properties of one element."""
    instances = instances_of(element.members)
    applied = [f"{schema.CONTROL}:{instance}" for instance in instances.values()]
    author.apply(subset, (schema.ELEMENT, *applied))
    if element.label != subset.name:
        subset.SetInfo("displayName", element.label)
    if element.reason:
        subset.SetInfo("documentation", element.reason)
    anchor, glyph = element.anchor, element.glyph
    handle: dict[str, Any] = {"adapt": element.adapt}
    if glyph is not None:
        handle |= {
            "glyph": glyph.name,
            "glyphType": glyph.form,
            "glyphOffsets": glyph.points,
            "glyphCounts": glyph.counts,
            "glyphIndices": glyph.indices if glyph.form == "mesh" else (),
        }
    identity: dict[str, Any] = {
        "name": "" if element.name == subset.name else element.name,
        "elementType": element.kind,
        "controls": list(instances.values()) if len(instances) > 1 else (),
        "side": element.side,
        "mirror": [paths[element.mirror]] if element.mirror in paths else [],
        "members": [paths[name] for name in element.inner],
        "category": element.category,
        "pinned": element.pinned,
        "pinnedPosition": element.pinned_position,
    }
    place: dict[str, Any] = {
        "carrier" if anchor.on_board else "prim": [anchor.mesh],
        "pointIndex": anchor.point,
        "pointCount": anchor.point_count,
        "topologyHash": anchor.topology_hash,
        "position": anchor.position,
        "normal": anchor.normal,
    }
    author.declare(subset, schema.ELEMENT, identity)
    author.declare(subset, schema.ANCHOR, place)
    author.declare(subset, schema.HANDLE, handle)
    opposes = {
        element.members[b].control: instances[element.members[a].control]
        for a, b in element.opposed
    }
    for position, member in enumerate(element.members):
        control = skin.control(member.control)
        figures = {
            "opposes": opposes.get(member.control, ""),
            "mirrorReversed": position in element.reversed,
            **_track(member, control),
        }
        author_control_api(subset, body, control, instances[member.control], figures)


def _track(member: Member, control: Control) -> dict[str, Any]:
    even = np.linspace(control.minimum, control.maximum, len(member.values))
    plain = np.allclose(
        member.values, even, rtol=0.0, atol=1e-7 * max(1.0, float(np.abs(even).max()))
    )
    return {
        "trackPoints": member.track,
        "trackValues": () if plain else member.values,
        "arcLength": member.arc_length,
        "magnification": member.magnification,
        "peak": member.peak,
    }


def instances_of(members: tuple[Member, ...]) -> dict[str, str]:
    """RigUIControlAPI instance of each control; none may be called like a property of the
    schema."""
    taken = set(author.properties(schema.CONTROL))
    return {member.control: author.identifier(member.control, taken) for member in members}
