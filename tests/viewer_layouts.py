"""Layouts made by hand for the viewer's tests: every control at the point that it moves furthest."""

import makers
import numpy as np

from usdrigui.character import Clip
from usdrigui.character.deform import deform, knots, posed, sweep
from usdrigui.model import Element

MIRRORS = {f"{name}_{a}": f"{name}_{b}" for name in makers.LEFT_BUMPS for a, b in (("L", "R"), ("R", "L"))}
"""The twins among the controls of `makers.face`."""


def animated(rig, frames=(1.0, 11.0), **weights):
    """The rig with a clip of a value at each of the frames for some channels, in the order of its channels' tokens."""
    tokens = [channel.token for channel in rig.body.channels]
    table = np.zeros((len(frames), len(tokens)))
    for token, values in weights.items():
        table[:, tokens.index(token)] = values
    return makers.changed(rig, clip=Clip(np.array(frames), table, np.zeros((len(frames), 0, 4, 4)), 24.0))


def peak_layout(rig, view=(0.0, 0.0, 1.0), mirrors=None, groups=(), beside=()):
    """One slider per control; `groups` are (name, kind, control names, opposed) that share an element."""
    base = posed(rig)
    names = rig.control_names
    grouped = {name for group in groups for name in group[2]}
    elements = [
        element(rig, base, name, "slider", (name,), (), mirrors, name in beside)
        for name in names
        if name not in grouped
    ]
    elements += [
        element(rig, base, name, kind, members, opposed, mirrors, False) for name, kind, members, opposed in groups
    ]
    spread = np.ptp(deform(rig), axis=0)
    return makers.layout(
        rig,
        *(each for each in elements if each is not None),
        base_values=rig.defaults,
        drawn=makers.frame(0.02 * float(spread.max()), view, (1.0, 0.0, 0.0)),
    )


def element(rig, base, name, kind, members, opposed, mirrors, beside):
    mirrors = mirrors or {}
    index = rig.control_indices
    paths = {member: sweep(rig, base, index[member], knots(rig, index[member])) for member in members}
    points, offsets = paths[members[0]]
    if not len(points):
        return None
    peak = int(np.linalg.norm(np.ptp(offsets, axis=0), axis=1).argmax())
    point = int(points[peak])
    shift = np.array([1.5, 0.0, 0.0]) * float(np.ptp(base.points[:, 0])) * beside
    return Element(
        name=name,
        kind=kind,
        members=tuple(member_at(rig, base, index[one], point, shift) for one in members),
        opposed=tuple(opposed),
        mirror=mirrors.get(name, ""),
        anchor=makers.anchor(rig, point, base.points[point] + shift, on_board=beside),
        label=name,
        side="left" if name.endswith("_L") else "right" if name.endswith("_R") else "middle",
        category="crowded" if beside else "",
    )


def member_at(rig, base, control, point, shift):
    values = knots(rig, control)
    if len(rig.controls[control].drive.joints):
        values = np.linspace(values[0], values[-1], 17)
    moved = sweep(rig, base, control, values)
    return makers.member(rig.controls[control], values, base.points[point] + shift, point, *moved)


def on_track(track, share):
    """Pixel at a share of a straight track."""
    return [a + share * (b - a) for a, b in zip(track[0], track[-1], strict=True)]
