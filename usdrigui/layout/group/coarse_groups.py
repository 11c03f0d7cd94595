"""Two levels: which groups are coarse, which are their members, and which of them are visible
together.

A coarse group is shown first, and its members in its place when it is opened
(`usdrigui.model.levels`).
A level configured for one side of the character holds for the other, since a group represents both.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import chain

from usdrigui.character import Control, Rig
from usdrigui.errors import Faults, check_known, refuse
from usdrigui.layout.names import element_name
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import Group
from usdrigui.model.levels import states_of
from usdrigui.settings import LevelSettings

Inner = dict[str, set[str]]
"""Names of the members of each coarse group, by its name."""


def with_levels(
    rig: Rig,
    groups: tuple[Group, ...],
    settings: LevelSettings,
    requests: Requests,
    regions: Inner,
) -> tuple[Group, ...]:
    """The groups on their levels, and a group of its own for every axis of those that
    `levels.groups` opens; where nobody asks for levels, those of crowded `regions`.

    Raises CONFIG_UNKNOWN_CONTROL for a name that nothing bears, CONFIG_VALUE for a coarse element
    without members or one that is a member itself.
    """
    if not (requests.levels or settings.poses or settings.groups):
        return tuple(_with_states(groups, {} if requests.existing else regions))
    parts = {
        group.name: tuple(_parts(rig, group))
        for group in groups
        if settings.groups and len(group.axes) > 1 and not group.category
    }
    inner = {name: {part.name for part in made} for name, made in parts.items()}
    inner |= _of_poses(rig, groups) if settings.poses else {}
    configured = _configured(rig, groups, requests)
    inner |= configured
    derived = (made for name, made in parts.items() if name not in configured)
    everything = (*groups, *chain.from_iterable(derived))
    _check(inner, configured)
    return tuple(sorted(_with_states(everything, inner), key=lambda group: group.name))


# --- which are coarse -----------------------------------------------------------------------------


def _parts(rig: Rig, group: Group) -> Iterator[Group]:
    """One group per axis."""
    for axis in group.axes:
        images = tuple(tuple(copy[i] for i in axis) for copy in group.images)
        yield Group(
            name=element_name(
                [rig.control_names[group.controls[i]] for i in axis], rig.control_names
            ),
            kind="slider",
            controls=tuple(group.controls[i] for i in axis),
            opposed=((0, 1),) if len(axis) == 2 else (),
            mirror=images[0] if group.mirror else (),
            reason=f"one axis of {group.name}",
            images=images,
            image_names=("",) * len(images),
            part=True,
        )


def _of_poses(rig: Rig, groups: tuple[Group, ...]) -> Inner:
    """Members of every pose: the groups of the other controls that set what it sets."""
    found: Inner = {}
    driven = {
        group.name: _driven(rig.controls, group.all_controls, poses=False) for group in groups
    }
    for group in groups:
        posed = _driven(rig.controls, frozenset(group.controls), poses=True)
        members = {
            other.name for other in groups if other is not group and posed & driven[other.name]
        }
        if members:
            found[group.name] = members
    return found


def _driven(
    controls: tuple[Control, ...], members: frozenset[int], *, poses: bool
) -> frozenset[tuple[str, int]]:
    """Channels and joints that the poses among some controls set, or that the others set."""
    some = [controls[i] for i in sorted(members)]
    drives = [control.drive for control in some if (control.kind == "pose") == poses]
    channels = {("weight", int(channel)) for drive in drives for channel in drive.channels}
    return frozenset(
        channels | {("joint", int(joint)) for drive in drives for joint in drive.joints}
    )


def _configured(rig: Rig, groups: tuple[Group, ...], requests: Requests) -> Inner:
    """Members as the configuration names them; what a layout has to which this one adds may be
    named, and has no group here."""
    found: Inner = {}
    faults = Faults()
    for name, members in requests.levels.items():
        with faults.collected():
            where = f'levels.members."{name}"'
            coarse = _named(rig, groups, name, where)
            if coarse is None and name in requests.existing_names:
                continue
            if coarse is None:
                raise refuse("CONFIG_VALUE", where, f"{name} has no element")
            inner = [_named(rig, groups, each, where) for each in members]
            if not any(inner):
                raise refuse("CONFIG_VALUE", where, "none of its members has an element")
            found.setdefault(coarse.name, set()).update(each.name for each in inner if each)
    faults.raise_all()
    return found


def _named(rig: Rig, groups: tuple[Group, ...], name: str, where: str) -> Group | None:
    """The group of that name or with the control of that name; None for a control that has no
    element."""
    for group in groups:
        if name in (group.name, *group.image_names):
            return group
    index = rig.control_indices.get(name, -1)
    if index < 0:
        if name in {left.control for left in rig.left_off}:
            return None
        known = (*(group.name for group in groups), *rig.control_names)
        check_known(name, known, where, f"{rig.path} has no control or element")
    return next((group for group in groups if index in group.all_controls), None)


def _check(inner: Inner, configured: Inner) -> None:
    """Two levels: what the configuration names contradicts itself, what is derived gives way."""
    for name, members in inner.items():
        if name in members:
            raise refuse(
                "CONFIG_VALUE", f'levels.members."{name}"', f"{name} is a member of itself"
            )
    for name in sorted(inner):
        holders = sorted(other for other, members in inner.items() if name in members)
        if not holders:
            continue
        if name in configured and any(other in configured for other in holders):
            raise refuse(
                "CONFIG_VALUE",
                f'levels.members."{name}"',
                f"is a member of {holders[0]}; there are two levels only",
            )
        if name in configured:
            for other in holders:
                inner[other].discard(name)
        else:
            inner[name].clear()


def _with_states(groups: Iterable[Group], inner: Inner) -> Iterator[Group]:
    """The groups with their members and the states in which they are visible: none opened, each
    one."""
    members = {name: tuple(sorted(inner[name])) for name in sorted(inner) if inner[name]}
    held = frozenset(chain.from_iterable(members.values()))
    kept = {group.name: group for group in groups if not group.part or group.name in held}
    for name, states in states_of(kept, members, {}).items():
        yield replace(kept[name], inner=members.get(name, ()), states=states)
