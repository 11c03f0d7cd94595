"""pin() and pins(): a person's decisions about the controls of a layout, as a layer of
corrections; bake(): what an animator keyed on them, as samples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from pathlib import Path
from typing import cast

import numpy as np

from usdrigui.character import Rig
from usdrigui.character.deform import knots, posed, sweep
from usdrigui.errors import check_known, meant, refuse
from usdrigui.layout.reuse.partial_layout import anchored_point
from usdrigui.model import CorrectedPlace, Correction, Element, Layout
from usdrigui.reader.reader_process import (
    read_composed_isolated,
    read_isolated,
    read_layer_isolated,
    read_layouts_isolated,
)
from usdrigui.replacing.transaction import State, check_own, commit, same_file
from usdrigui.settings import ControlSettings, ReadSettings, Settings, literal, load


def pin(
    layer: Path, decisions: Mapping[str, str], output: Path, settings: Settings, reason: str = ""
) -> State:
    """Write decisions about controls of a layout into a layer of corrections over it; those that
    `output` has already stay, unless they are about the same.

    `decisions`: by control, or control and key (``jawOpen.label``), what is decided: ``here``,
    ``board``, ``face``, ``MESH_PATH#POINT`` or ``X,Y,Z`` (at rest, in root space) of a control,
    ``free`` to take back what is decided, there and on record in the layout; its ``group``
    (``NAME,NAME``), and every other key of its configuration.

    Raises CONFIG_UNKNOWN_CONTROL, CONFIG_UNKNOWN_KEY and CONFIG_VALUE, FIXED_IMPOSSIBLE for a point
    that the control does not move, FILE_TARGET for an `output` that is something else, and as
    `read_composed_isolated`.
    """
    from usdrigui.layer.corrections import corrections_text
    from usdrigui.layer.write_layout import relative_asset_path

    found, read = read_composed_isolated(layer, settings)
    layouts = {each.root: each for each in found.layouts}
    made = _existing(output, layer, settings.read)
    unit = float(read.metadata["metersPerUnit"])
    for key, value in decisions.items():
        rig, name, what = _meant(read.rigs, key)
        root, up = rig.path, rig.up.tolist()
        known = made.pop((root, name), Correction(root, name))
        if value != "free":
            known = _decided(known, (what, value), rig, layouts[root])
            why = reason or known.reason
            made[root, name] = replace(known, up=tuple(up), unit=unit, reason=why)
        elif any(each.control == name for each in _recorded(layouts[root])):
            made[root, name] = Correction(root, name, "free", reason=reason)
    sublayer = relative_asset_path(layer, output)
    return commit(corrections_text(made.values(), sublayer, read.metadata), output, read=[layer])


def pins(layer: Path, settings: Settings) -> tuple[Correction, ...]:
    """The corrections that a layer brings, and as such what its layouts have on record."""
    found = read_layouts_isolated(layer, settings.read)
    recorded = (each for layout in found.layouts for each in _recorded(layout))
    told = {(each.root, each.control): each for each in (*recorded, *found.corrections)}
    return tuple(told.values())


def bake(shot: Path, settings: Settings, output: Path | None = None) -> tuple[State, Path]:
    """Write what `usdrigui.layer.baking.bake` makes of a shot, by default to ``SHOT.baked.usda``
    beside it; what became of that file, and which it is.

    Raises FILE_TARGET for an output that is something else, VALUES_MISSING, and as
    `read_rigs_isolated`.
    """
    from usdrigui.layer.baking import BAKED

    target = output or shot.with_name(f"{shot.stem}.baked.usda")
    check_own(target, "what `usdrigui bake` writes", BAKED)
    content = read_isolated("bake", shot, settings.read, str)
    return commit(content, target, read=[shot]), target


def _recorded(layout: Layout) -> list[Correction]:
    return [
        _of_record(layout.root, member.control, element)
        for element in layout.elements
        for member in element.members
        if element.pinned
    ]


def _of_record(root: str, control: str, element: Element) -> Correction:
    pinned, on_board = element.pinned, element.anchor.on_board
    place = "board" if on_board else "point" if "anchor" in pinned else "face"
    placed = cast(CorrectedPlace, place if {"anchor", "place"} & {*pinned} else "")
    reason = f"on record: {', '.join(pinned)}"
    return Correction(root, control, placed, element.pinned_position, reason=reason)


def _existing(
    output: Path, layer: Path, opening: ReadSettings
) -> dict[tuple[str, str], Correction]:
    """What a layer of corrections holds already; raises FILE_TARGET for another file."""
    if same_file(output, layer):
        raise refuse("FILE_TARGET", output, "is the layout itself, which stays as it is")
    if output.suffix != ".usda":
        raise refuse("FILE_TARGET", output, "a layer of corrections ends in .usda")
    if not output.is_file():
        return {}
    held = read_layer_isolated(output, opening).corrections
    if not held:
        raise refuse("FILE_TARGET", output, "exists and is no layer of corrections")
    return {(each.root, each.control): each for each in held}


def _meant(rigs: Sequence[Rig], key: str) -> tuple[Rig, str, str]:
    """The character with a control, the control, and what of it a key is about: ``place`` unless it
    says so.  Raises CONFIG_UNKNOWN_CONTROL, CONFIG_UNKNOWN_KEY."""
    known = {each.name for each in fields(ControlSettings)} | {"group"}
    every = {each for rig in rigs for each in rig.control_names}
    name, _, what = key.rpartition(".")
    if what not in known:
        if name in every and key not in every:
            there = f"there are {', '.join(sorted(known))}{meant(what, known)}"
            raise refuse("CONFIG_UNKNOWN_KEY", key, f"no property is called {what!r}; {there}")
        name, what = key, "place"
    owners = [rig for rig in rigs if name in rig.control_names]
    if len(owners) != 1:
        why = (
            "several characters have this control"
            if owners
            else f"no character has this control{meant(name, every)}"
        )
        raise refuse("CONFIG_UNKNOWN_CONTROL", key, why)
    return owners[0], name, what


def _decided(known: Correction, said: tuple[str, str], rig: Rig, layout: Layout) -> Correction:
    """The correction with one more decision."""
    what, value = said
    if what == "place":
        return _placed(known, value, rig, layout)
    names = value.split(",") if what == "group" else [value] * (what == "twin")
    for name in names:
        check_known(name, rig.control_names, f"{known.control}.{what}")
    if what == "group":
        return replace(known, group=tuple(dict.fromkeys((known.control, *names))))
    settings = {**known.settings, what: literal(value)}
    load({"controls": {known.control: settings}})
    return replace(known, settings=settings)


def _placed(known: Correction, value: str, rig: Rig, layout: Layout) -> Correction:
    """The correction at a place; a point that is named is one that its control moves."""
    asked, start = value, posed(rig, None)
    if value == "here":
        anchors = [e.anchor for e in layout.elements if known.control in e.controls]
        if not anchors:
            raise refuse("CONFIG_VALUE", known.control, "has no element in the layout")
        value = anchors[0].place
    if value in ("board", "face"):
        return replace(known, place=cast(CorrectedPlace, value), mesh="", point=-1)
    rest = start.points
    if "#" in value:
        point = anchored_point(rig, known.control, value)
        subject = rig.control_indices[known.control]
        moved, ways = sweep(rig, start, subject, knots(rig, subject))
        if asked == value and point not in moved[np.ptp(ways, axis=0).any(axis=1)]:
            raise refuse("FIXED_IMPOSSIBLE", known.control, f"does not move the point {value}")
        position = rest[point].reshape(3)
    else:
        try:
            position = np.array([*map(float, value.split(","))]).reshape(3)
        except ValueError:
            what = "neither here, board, face, free, MESH_PATH#POINT nor X,Y,Z"
            raise refuse("CONFIG_VALUE", known.control, f"{value!r} is {what}") from None
        point = int(np.linalg.norm(rest - position, axis=1).argmin())
    mesh, local = rig.body.mesh_of(point)
    x, y, z = position.tolist()
    return replace(known, place="point", position=(x, y, z), mesh=mesh.path, point=local)
