"""The parts of a character: which controls are laid out together, at one scale.

A control of a joint is of the part of its joint, every other control of the part whose skin it
moves most.  Tongue and teeth are known by their names.  A rig that is a face alone, or a hand, is
one part.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.character import Control, Flags, Record, Rig
from usdrigui.character.surface import components, mesh_triangles
from usdrigui.conventions import meanings
from usdrigui.layout.control_overrides import controls_named
from usdrigui.layout.parts.joint_regions import (
    BODY,
    EYES,
    FACE,
    FEET,
    HANDS,
    HEAD,
    INTERIOR,
    JointRegions,
    joint_regions,
    owner_of_points,
)
from usdrigui.layout.shares import MOST, NEARLY_ALL
from usdrigui.model import Motion, Trajectories, main_part
from usdrigui.settings import Settings
from usdrigui.ties import first_largest

ORDER = (FACE, INTERIOR, EYES, HEAD, HANDS, FEET)
"""Parts that are laid out first, in this order; the body comes last, for its handles are the
widest."""
_BESIDE = {
    INTERIOR: (FACE, BODY), EYES: (FACE, BODY), HEAD: (FACE,), FACE: (BODY,), HANDS: (BODY,),
    FEET: (BODY,),
}  # fmt: skip
"""What lies beside a part."""
_FEW = 2
"""Joints, or shapes, of a part that joins the one beside it, at most: one or two elements."""


class Part(Record):
    """One part of a character."""

    name: str
    """``face``, ``interior`` (of the mouth), ``eyes``, ``head``, ``hands``, ``feet``, ``body``, or
    as the configuration calls it."""
    controls: frozenset[int]
    """Indices of its controls, and behind these into `Rig.excluded`: of those that count for how
    large the part is."""


def divide(rig: Rig, found: Trajectories, settings: Settings) -> tuple[Part, ...]:
    """The parts of a character in the order in which they are laid out: face, inside of the mouth,
    eyes, head, hands, feet, others, body.

    Every control that moves something is in one part.  Without ``parts.divide`` all are in one, and
    so they are where the skeleton has no parts; controls that the configuration groups or pairs
    stay together.
    """
    regions = joint_regions(rig, found)
    # Where the skeleton has no parts all is the face.
    tell = (lambda *_: FACE) if regions is None else _Names(rig, found, regions).of
    names = {each.control: tell(rig.controls[each.control], each) for each in found.motions}
    # The joints of a face that other controls move are a part of their own where the character
    # has a body: the face is laid out as without them.
    on_face = _named(names, FACE)
    joints = {control for control in on_face if rig.controls[control].kind == "joint"}
    if joints < on_face and BODY in names.values():
        names |= dict.fromkeys(joints, HEAD)
    if settings.candidates.conventions:
        names |= dict.fromkeys(_inside_mouth(rig, found, names), INTERIOR)
    names |= _with_neighbours(rig.controls, names)
    # Ears and hair without a face are no page of a face; two of them stay with what is beside them.
    if regions and not regions.drive_face and joints == on_face and BODY in names.values():
        names |= dict.fromkeys(_named(names, FACE), HEAD)
    if not settings.parts.divide:
        names = dict.fromkeys(names, main_part(sorted(names.values(), key=_rank)))
    index = rig.control_indices
    names |= {
        index[name]: part
        for name, part in settings.parts.controls.items()
        if index.get(name) in names
    }
    names = _together(names, _bound(settings, index))
    known = sorted(set(names.values()), key=_rank)
    for each in found.excluded:
        name = tell(rig.excluded[each.control - len(rig.controls)], each)
        names[each.control] = name if name in known else main_part(known)
    return tuple(Part(name, _named(names, name)) for name in known)


def _with_neighbours(controls: tuple[Control, ...], names: Mapping[int, str]) -> dict[int, str]:
    """The controls of parts too small to be looked at by themselves, in the part beside theirs; a
    face that others than joints move is never too small."""
    found = dict(names)
    moved = {name for i, name in found.items() if controls[i].kind != "joint"}
    for part, neighbours in _BESIDE.items():
        own = _named(found, part)
        near = [n for n in neighbours if n in found.values()]
        few = len({controls[control].source for control in own}) <= _FEW
        if few and near and part not in moved & {FACE}:
            found |= dict.fromkeys(own, near[0])
    return found


def _inside_mouth(rig: Rig, found: Trajectories, names: Mapping[int, str]) -> list[int]:
    """The controls of the face that bear the name of a tongue or of teeth;
    a shape of the piece of surface that most controls move, the skin, is none of them."""
    meant = meanings(rig.control_names)
    named = {
        control
        for control, part in names.items()
        if part == FACE and (own := meant[control]) is not None and own.action.category == INTERIOR
    }
    if not named:
        return []
    pieces = components(mesh_triangles(rig.body.meshes), found.surface.places)
    shares = {
        motion.control: np.bincount(pieces[motion.points], found.surface.swept(motion))
        for motion in found.motions
    }
    skin = Counter(int(share.argmax()) for share in shares.values()).most_common(1)[0][0]
    return [
        control
        for control in sorted(named)
        if rig.controls[control].kind == "joint"
        or 2.0 * shares[control][skin : skin + 1].sum() <= shares[control].sum()
    ]


def _named(names: Mapping[int, str], name: str) -> frozenset[int]:
    return frozenset(control for control, own in names.items() if own == name)


def _rank(name: str) -> tuple[bool, int, str]:
    return name == BODY, ORDER.index(name) if name in ORDER else len(ORDER), name


def _bound(settings: Settings, index: Mapping[str, int]) -> list[list[int]]:
    """Controls that the configuration makes one element, shows in each other's place, or
    mirrors."""
    groups = [*settings.groups.groups.values()]
    groups += [(name, *members) for name, members in settings.levels.members.items()]
    groups += [(name, own.twin, *own.orbit) for name, own in settings.controls.items()]
    return [controls_named(names, settings.groups.groups, index) for names in groups]


def _together(names: dict[int, str], bound: list[list[int]]) -> dict[int, str]:
    """The parts with every bound control in the part of the first of them."""
    for controls in bound:
        present = [control for control in controls if control in names]
        names |= dict.fromkeys(present, names[present[0]]) if present else {}
    return names


class _Names:
    """Tells the part of each control by the regions of the joints."""

    def __init__(self, rig: Rig, found: Trajectories, regions: JointRegions) -> None:
        self.rig, self.found, self.regions = rig, found, regions
        self.known = sorted(set(regions.of_skin) | set(regions.of_joint), key=_rank)
        # What no joint holds is of the first part.
        of_skin = np.array([*map(self.known.index, regions.of_skin), 0])
        self.skin = of_skin[owner_of_points(rig.body.meshes)]
        self.near_face = self._near(np.array(self.known)[self.skin] == FACE)

    def of(self, control: Control, motion: Motion) -> str:
        """The part of a control."""
        if control.kind == "joint":
            driven = control.drive.joints.tolist()
            own: int = next(
                (i for i in driven if self.rig.body.joints[i].path == control.source), driven[0]
            )
            return self.regions.of_joint[own]
        mass = self.found.surface.swept(motion)
        masses = np.bincount(self.skin[motion.points], mass, len(self.known)).astype(np.float64)
        most = self.known[first_largest(masses)]
        near = mass[self.near_face[motion.points]].sum() > NEARLY_ALL * mass.sum()
        # One direction of a gaze moves the lids, another one does not: they stay together.
        return FACE if near or most == EYES else most

    def _near(self, face: Flags) -> Flags:
        """(n,) the points no further from the face than half of the head's extent: a blend shape of
        such skin (the neck) is of the face."""
        if not face.any():
            return face
        base = self.found.surface.points
        extent = float(np.ptp(base[face], axis=0).max())
        apart, _ = cKDTree(base[face]).query(base, distance_upper_bound=MOST * extent)
        return np.asarray(np.isfinite(apart))
