"""The controls of a layout as its own layer has them: what each drives on the character."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from pxr import Usd

from usdrigui.character import (
    Body,
    Control,
    Drive,
    Floats,
    Indices,
    Rig,
)
from usdrigui.errors import Issue, issue
from usdrigui.layer.properties import control_instances, value_of
from usdrigui.reading.blend_shape import legible_tokens
from usdrigui.reading.mesh import drawable
from usdrigui.stages import schema


def read_controls(
    scope: Usd.Prim, prims: tuple[Usd.Prim, ...], body: Body, found: list[Issue]
) -> Rig:
    """The character with those controls of the elements `prims` of a layout that it has; its base
    weights are those where all are at their defaults.

    `found` takes what it lacks, and controls that two elements have in two ways.
    """
    controls: dict[str, Control] = {}
    authored: dict[str, list[Any]] = {}
    weights, shaped = body.base_weights.copy(), set[str]()
    for mesh in drawable(scope.GetParent()):
        shaped.update(legible_tokens(mesh))
    tokens = shaped | {channel.token for channel in body.channels}
    for prim in prims:
        for instance in control_instances(prim):
            read = _Reader(prim, instance, body)
            faults = list(read.faults(tokens))
            found += (invalid_at(prim, f"rigUI:control:{instance}:{what}") for what in faults)
            control = read.control(weights)
            if not faults and read.complete(control.drive, shaped):
                controls[control.name] = control
            said = [np.array(read.get(name)).tolist() for name in _DRIVEN]
            if authored.setdefault(control.name, said) != said:
                what = f"its control {control.name!r} is another one in another element"
                found.append(invalid_at(prim, what))
    return Rig(
        str(scope.GetParent().GetPath()),
        np.zeros(3),
        1.0,
        replace(body, base_weights=weights),
        tuple(controls.values()),
    )


@dataclass(frozen=True)
class _Reader:
    """One control of an element, held against the character."""

    prim: Usd.Prim
    instance: str
    body: Body

    def get(self, name: str) -> Any:
        return value_of(self.prim, schema.CONTROL, name, self.instance)

    def faults(self, tokens: set[str]) -> Iterator[str]:
        """What keeps it from driving anything; `tokens` are the shapes of the character."""
        shapes, joints = {*self.get("blendShapes")}, {*self.get("joints")}
        if not shapes and not joints:
            yield "blendShapes and joints are missing: the control drives nothing"
        elif not len(self.get("keys")) and (len(shapes) != 1 or joints):
            yield "keys are missing: without, it is one blend shape"
        # Of its own shape the rig shows that it is gone.
        own = [self.get("source"), self.get("name"), self.instance]
        for token in sorted(shapes.difference(tokens, own)):
            yield f"blendShapes names {token!r}, which no mesh has"
        there = {joint.path for joint in self.body.joints}
        for token in sorted(joints - there) if there else ():
            yield f"joints names {token!r}, which its Skeleton lacks"
        known = {"blendShape": shapes, "joint": joints.union(own[1:])}.get(self.get("kind"), own)
        if next(filter(None, own)) not in known:
            yield "source, or its name, is not one of its blendShapes or joints"
        if joints and not self.get("skeleton"):
            yield "skeleton is missing: it moves joints"
        if (self.get("unit") == "degrees") != (self.get("kind") == "joint"):
            yield "unit is not that of its kind"

    def complete(self, drive: Drive, shaped: set[str]) -> bool:
        """Whether the character has all joints that it drives and one of the shapes, `shaped` being
        those of its meshes; what it lacks, a check of the rig says."""
        moved = len(drive.joints) > 0 or not shaped.isdisjoint(self.get("blendShapes"))
        return moved and len(drive.joints) == len(self.get("joints"))

    def control(self, weights: Floats) -> Control:
        """The control as far as the character has what it drives; `weights` (channels,) take that
        of its default."""
        keys, ends = self.get("keys"), [*map(self.get, _ENDS)]
        body = self.body
        columns, channels = self._places(
            "blendShapes", "animation", [(each.token, each.animation) for each in body.channels]
        )
        moved, joints = self._places(
            "joints",
            "skeleton",
            [(each.path, body.skeletons[each.skeleton].path) for each in body.joints],
        )
        if len(keys):
            table = self.get("blendShapeWeights").reshape(len(keys), -1)[:, columns]
        else:
            keys = np.array([ends[0], ends[2]])
            table = np.repeat((keys - ends[1])[:, None], len(channels), axis=1)
            weights[channels] = ends[1]

        def moves(name: str, still: float = 0.0) -> Floats:
            rows = self.get(name).reshape(len(keys), -1, 3)
            return rows[:, moved] if rows.size else np.full((len(keys), len(joints), 3), still)

        parts = (
            np.radians(moves("jointRotationVectors")),
            moves("jointTranslations"),
            np.log(moves("jointScaleFactors", 1.0)),
        )
        drive = Drive(keys, channels, table, joints, np.stack(parts, axis=1))
        name, (low, rest, high) = self.get("name") or self.instance, ends
        return Control(name, "", self.get("kind"), "", low, rest, high, "limits", drive)

    def _places(
        self, tokens: str, owners: str, known: list[tuple[str, str]]
    ) -> tuple[Indices, Indices]:
        """(n,) columns of the tokens that the character has, and the place of each in what is
        `known` by token and owner; of a token without a named owner, all places."""
        targets, which = self.get(owners), self.get(f"{tokens[:-1]}{owners.title()}s")
        table = [
            (column, place)
            for column, token in enumerate(self.get(tokens))
            for place, (name, owner) in enumerate(known)
            if name == token
            and (not targets or owner == targets[which[column] if len(which) else 0])
        ]
        columns, places = np.array(table, dtype=np.int64).reshape(-1, 2).T
        return columns, places


_ENDS = ("minimum", "default", "maximum")
_DRIVEN = (*_ENDS, "keys", "blendShapes", "blendShapeWeights", "joints", "jointRotationVectors")
"""Of a control with several elements, alike in all."""


def doubtful_at(prim: Usd.Prim, message: str) -> Issue:
    """LAYOUT_INVALID of a prim, as a warning."""
    return replace(invalid_at(prim, message), severity="warning")


def invalid_at(prim: Usd.Prim, message: str) -> Issue:
    """LAYOUT_INVALID of a prim."""
    return issue("LAYOUT_INVALID", prim.GetPath(), message)
