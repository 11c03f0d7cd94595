"""From layouts to the layer that any UsdSkel application can show.

`write_layout` is the whole way to a file, `layer_for` stops at the layer, `stage_metadata` says what the
layer must repeat of its source.  schemas/CONTRACT.md describes the result; `usdrigui.usd.read_layout` is
the way back.
"""

from __future__ import annotations

import functools
import os
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pxr import Sdf, Tf, UsdGeom

from usdrigui.errors import refuse
from usdrigui.levels import inner_names
from usdrigui.model import Element, Layout, Rig
from usdrigui.settings import OutputSettings
from usdrigui.usd import author, schema
from usdrigui.usd.carry import Carriage
from usdrigui.usd.control_api import author_control_api, author_limits
from usdrigui.usd.drawn import Drawn, drawn_parts
from usdrigui.usd.element_prims import author_part
from usdrigui.usd.safe_write import State, commit, file_error
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
"""What USD reads from the root layer of a stage only, and a layer over the source must therefore repeat."""

Laid = Sequence[tuple[Rig, Layout]]


def write_layout(
    laid: Laid,
    source: Path,
    target: Path,
    settings: OutputSettings,
    metadata: Mapping[str, Any],
    *,
    write: Callable[..., State] = commit,
) -> State:
    """Write the layouts of one asset to `target`, atomically, over its `source`.

    `metadata` is `stage_metadata` of the source's root layer.  The source is sublayered by a relative
    path unless `settings.bare`.  `write` is `safe_write.commit`, or `stage` of a transaction with other files.
    Raises RigUIError with a FILE_ code or SOURCE_UNREFERABLE.
    """
    reference = "" if settings.bare else relative_asset_path(source, target)
    layer = layer_for(laid, reference, settings, metadata)
    content = layer_bytes(layer, target.suffix, str(target))
    roots = [layout.root for _, layout in laid]
    return write(content, target, verify=functools.partial(holds_layouts, roots))


def layer_for(laid: Laid, source: str, settings: OutputSettings, metadata: Mapping[str, Any]) -> Sdf.Layer:
    """An anonymous layer with the layouts of one asset.

    `source` is the asset path to sublayer, taken as it is; empty, or ignored with `settings.bare`, the
    layer stands alone for others to sublayer.  The same input gives the same bytes.
    """
    layer = Sdf.Layer.CreateAnonymous(".usda")
    with Sdf.ChangeBlock():
        author_metadata(layer, metadata, laid)
        if source and not settings.bare:
            layer.subLayerPaths.append(source)
        for rig, layout in laid:
            _author_layout(layer, rig, layout)
            author_limits(layer, rig)
    return layer


def stage_metadata(layer: Sdf.Layer) -> dict[str, Any]:
    """What a layer over `layer` must repeat, as plain Python values.

    Up axis and unit are said even where the source leaves them to USD's fallbacks.
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
    """Asset path by which a layer at `target` refers to the file `source`: relative, with forward slashes.

    Raises SOURCE_UNREFERABLE for names that USD cannot refer to.
    """
    here = source.parent.resolve() / source.name  # a link keeps its name: what it refers to lies beside it
    path = os.path.relpath(here, target.parent.resolve()).replace(os.sep, "/")
    if ":SDF_FORMAT_ARGS:" in path or "@@@" in path or any(ord(char) < 32 for char in path):
        raise refuse("SOURCE_UNREFERABLE", str(source), "its name has a meaning of its own in USD")
    return path if path.startswith("../") else f"./{path}"


def layer_bytes(layer: Sdf.Layer, suffix: str, name: str = "") -> bytes:
    """The content of a layer as a file of that suffix: ``.usda`` as text, ``.usdc`` and ``.usd`` as crate.

    A refusal calls the file by its ``name``.

    Raises FILE_TARGET for any other suffix, and another FILE_ code when there is no room for a temporary.
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
        raise refuse("FILE_WRITE", tempfile.gettempdir(), "USD cannot write a temporary crate") from None


def holds_layouts(roots: Sequence[str], path: Path) -> bool:
    """Whether the file is a layer with a layout below each of the SkelRoots."""
    layer = Sdf.Layer.OpenAsAnonymous(str(path))
    return all(layer.GetPrimAtPath(Sdf.Path(root).AppendChild(schema.SCOPE)) for root in roots)


# --- the layer ---------------------------------------------------------------------------------------


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
            number = isinstance(value, (int, float)) and not isinstance(value, bool)
            root.SetInfo(key, float(value) if number else value)
    root.SetInfo("customLayerData", {SIGNATURE: {"version": __version__}})


def _author_layout(layer: Sdf.Layer, rig: Rig, layout: Layout) -> None:
    """The Scope of one character with all its elements."""
    root = Sdf.CreatePrimInLayer(layer, layout.root)
    scope = author.prim(root, schema.SCOPE, "Scope", (schema.LAYOUT, schema.SOLUTION))
    author.put(scope, "purpose", "token", "guide", uniform=True)
    author.declare(scope, schema.LAYOUT, _frame(rig, layout) | account(rig, layout))
    author.declare(scope, schema.SOLUTION, solution(layout))
    carriage = Carriage(rig, layout)
    taken: set[str] = set()
    names = {element.name: author.identifier(element.name, taken) for element in layout.elements}
    for element in layout.elements:
        author_element(scope, rig, layout, carriage, element, names)


def _frame(rig: Rig, layout: Layout) -> dict[str, Any]:
    """RigUILayoutAPI: where and how large the elements are."""
    return {
        "version": schema.VERSION,
        "skeleton": [skeleton.path for skeleton in rig.skeletons],
        "space": layout.space,
        "viewDirection": layout.view,
        "planeOrigin": layout.plane_origin,
        "planeNormal": layout.plane_normal,
        "handleWidth": layout.handle_width,
        "parts": [part.name for part in layout.parts],
        "partHandleWidths": [part.handle_width for part in layout.parts],
        "partViewDirections": [part.view for part in layout.parts],
    }


def account(rig: Rig, layout: Layout) -> dict[str, Any]:
    """RigUILayoutAPI: every control of the character, the base pose, and what was left off."""
    return {
        "baseControls": [control.name for control in rig.controls],
        "baseValues": layout.base_values,
        "leftOffControls": [left.control for left in layout.left_off],
        "leftOffStages": [left.stage for left in layout.left_off],
        "leftOffReasons": [left.reason for left in layout.left_off],
    }


def solution(layout: Layout) -> dict[str, Any]:
    """RigUISolutionAPI."""
    return {
        "solver": layout.method,
        "status": layout.status,
        "cost": layout.cost,
        "bound": layout.bound,
        "inPlay": layout.in_play,
        "partStatuses": [part.status for part in layout.parts],
        "partCosts": [part.cost for part in layout.parts],
        "partBounds": [part.bound for part in layout.parts],
        "weightNames": [name for name, _ in layout.weights],
        "weightValues": [value for _, value in layout.weights],
    }


def author_element(
    scope: Sdf.PrimSpec, rig: Rig, layout: Layout, carriage: Carriage, element: Element, names: Mapping[str, str]
) -> None:
    """One element: its Xform, what it says about itself, and what is drawn of it."""
    instances = instances_of(element)
    applied = [f"{schema.CONTROL}:{instance}" for instance in instances.values()]
    apis = (schema.ELEMENT, schema.ANCHOR, *applied, "AccessibilityAPI:default")
    xform = author.prim(scope, names[element.name], "Xform", apis)
    xform.SetInfo("displayName", element.label)
    author.put(xform, "accessibility:default:label", "string", element.label)
    if element.name in inner_names(layout.elements):
        # Applications that know nothing of levels show the first one.
        author.put(xform, "visibility", "token", "invisible")
    _author_element_api(xform, element, instances, names)
    _author_anchor_api(xform, element)
    parts = _part_names(drawn_parts(carriage, element, layout.handle_width_of(element)), instances)
    for member in element.members:
        control = carriage.control(member.control)
        track = next(name for name, part in parts if part.role == "track" and part.controls == (member.control,))
        figures = {"arcLength": member.arc_length, "gain": member.gain, "track": [xform.path.AppendChild(track)]}
        author_control_api(xform, rig, control, instances[member.control], figures)
    for name, part in parts:
        author_part(xform, name, part, rig, element, instances, layout.handle_width_of(element))


def instances_of(element: Element) -> dict[str, str]:
    """RigUIControlAPI instance of each control; none may be called like a property of the schema."""
    taken = set(author.properties(schema.CONTROL))
    return {member.control: author.identifier(member.control, taken) for member in element.members}


def _part_names(parts: Iterable[Drawn], instances: Mapping[str, str]) -> list[tuple[str, Drawn]]:
    """``track``, ``area`` and ``handle``; the tracks of several controls are told apart by their instances."""
    several = len(instances) > 1
    return [
        (f"track_{instances[part.controls[0]]}" if several and part.role == "track" else part.role, part)
        for part in parts
    ]


def _author_element_api(
    xform: Sdf.PrimSpec, element: Element, instances: Mapping[str, str], names: Mapping[str, str]
) -> None:
    mirror = names.get(element.mirror)
    author.declare(
        xform,
        schema.ELEMENT,
        {
            "name": "" if element.name == xform.name else element.name,
            "elementType": element.kind,
            "controls": list(instances.values()),
            "opposed": element.opposed,
            "side": element.side,
            "reversed": list(element.reversed),
            "mirror": [xform.path.GetParentPath().AppendChild(mirror)] if mirror else [],
            "members": [xform.path.GetParentPath().AppendChild(names[name]) for name in element.inner],
            "family": element.category,
            "part": element.part,
            "pinned": element.pinned,
            "pinnedPosition": element.pinned_position,
            "reason": element.reason,
        },
    )


def _author_anchor_api(xform: Sdf.PrimSpec, element: Element) -> None:
    anchor = element.anchor
    author.declare(
        xform,
        schema.ANCHOR,
        {
            "carrier" if anchor.on_board else "prim": [anchor.mesh],
            "pointIndex": anchor.point,
            "pointCount": anchor.point_count,
            "topologyHash": anchor.topology_hash,
            "position": anchor.position,
            "normal": anchor.normal,
        },
    )
