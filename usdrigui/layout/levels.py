"""Two levels: which groups are coarse, which are their members, and which of them are visible together.

A coarse group is shown first, and its members in its place when it is opened (`usdrigui.levels`).  What is said
of one side of the character holds for the other, since a group stands for both.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from usdrigui.errors import meant, refuse
from usdrigui.layout.terms import Context
from usdrigui.model import Element, Group
from usdrigui.settings import LevelSettings, Settings


def levelled(context: Context, groups: tuple[Group, ...]) -> tuple[Group, ...]:
    """The groups on their levels, and a group of its own for every axis of those that `levels.groups` opens.

    Raises CONFIG_UNKNOWN_CONTROL for a name that nothing bears, CONFIG_VALUE for a coarse element without
    members or one that is a member itself.
    """
    said = context.settings.levels
    if said == LevelSettings():
        return groups
    parts = {group.name: tuple(_parts(context, group)) for group in groups if said.groups and _has_axes(group)}
    inner = {name: {part.name for part in made} for name, made in parts.items()}
    inner |= _of_poses(context, groups) if said.poses else {}
    told = _told(context, groups)
    inner = {name: members for name, members in inner.items() if name not in told} | told
    everything = (*groups, *(part for name, made in parts.items() if name not in told for part in made))
    _check(inner, told)
    return tuple(sorted(_with_states(everything, inner), key=lambda group: group.name))


def of_parts(settings: Settings) -> Settings:
    """What holds for the slider that a control has of its own under a coarse element: its anchor is another."""
    controls = {
        name: replace(said, anchor=said.inner_anchor) if said.anchor or said.inner_anchor else said
        for name, said in settings.controls.items()
    }
    return replace(settings, controls=controls)


def with_inner(elements: Iterable[Element], groups: tuple[Group, ...], context: Context) -> tuple[Element, ...]:
    """The elements of all groups, the coarse ones with the names of their members on their own side."""
    names = [control.name for control in context.rig.controls]
    made = tuple(elements)
    by_controls: dict[frozenset[str], list[str]] = {}
    for element in made:
        by_controls.setdefault(frozenset(member.control for member in element.members), []).append(element.name)
    inner: dict[str, list[str]] = {}
    by_name = {group.name: group for group in groups}
    for group in groups:
        members = [by_name[name] for name in group.inner]
        copies = _elements_of(group, names, by_controls)
        for copy, name in enumerate(copies):
            for member in members:
                theirs = _elements_of(member, names, by_controls)
                own = theirs[copy : copy + 1] if len(theirs) == len(copies) else theirs
                inner.setdefault(name, []).extend(own)
    return tuple(replace(each, inner=tuple(sorted(inner.get(each.name, ())))) for each in made)


def _elements_of(group: Group, names: list[str], by_controls: dict[frozenset[str], list[str]]) -> list[str]:
    """Names of the elements of a group, one per copy."""
    found: list[str] = []
    for controls in (group.controls, *group.images):
        same = by_controls.get(frozenset(names[control] for control in controls), [])
        found += [name for name in same if name not in found][: 1 if len(same) > 1 else None]
    return found


# --- which are coarse --------------------------------------------------------------------------------


def _has_axes(group: Group) -> bool:
    return len(group.axes) > 1 and not group.beside


def _parts(context: Context, group: Group) -> Iterator[Group]:
    """One group per axis."""
    for axis in group.axes:
        images = tuple(tuple(copy[i] for i in axis) for copy in group.images)
        yield Group(
            name="_".join(context.rig.controls[group.controls[i]].name for i in axis),
            kind="slider",
            controls=tuple(group.controls[i] for i in axis),
            opposed=((0, 1),) if len(axis) == 2 else (),
            mirror=images[0] if group.mirror else (),
            reason=f"one axis of {group.name}",
            images=images,
            image_names=("",) * len(images),
            part=True,
        )


def _of_poses(context: Context, groups: tuple[Group, ...]) -> dict[str, set[str]]:
    """Members of every pose: the groups of the other controls that set what it sets."""
    controls = context.rig.controls
    found: dict[str, set[str]] = {}
    for group in groups:
        poses = [controls[i] for i in group.controls if controls[i].kind == "pose"]
        sets = {("weight", int(c)) for pose in poses for c in pose.drive.channels}
        sets |= {("joint", int(j)) for pose in poses for j in pose.drive.joints}
        members = {
            other.name
            for other in groups
            if other is not group
            for copy in (other.controls, *other.images)
            for i in copy
            if controls[i].kind != "pose"
            and sets & {*(("weight", int(c)) for c in controls[i].drive.channels), *_joints(controls[i].drive.joints)}
        }
        if members:
            found[group.name] = members
    return found


def _joints(joints: Iterable[int]) -> Iterator[tuple[str, int]]:
    return (("joint", int(joint)) for joint in joints)


def _told(context: Context, groups: tuple[Group, ...]) -> dict[str, set[str]]:
    """Members as the configuration names them."""
    found: dict[str, set[str]] = {}
    for name, members in context.settings.levels.members.items():
        where = f'levels.members."{name}"'
        coarse = _named(context, groups, name, where)
        if coarse is None and _stands(context, name):
            continue
        if coarse is None:
            raise refuse("CONFIG_VALUE", where, f"{name} has no element")
        inner = {group.name for each in members for group in [_named(context, groups, each, where)] if group}
        if not inner:
            raise refuse("CONFIG_VALUE", where, "none of its members has an element")
        found.setdefault(coarse.name, set()).update(inner)
    return found


def _named(context: Context, groups: tuple[Group, ...], name: str, where: str) -> Group | None:
    """The group of that name or with the control of that name; None for a control that has no element."""
    for group in groups:
        if name in (group.name, *group.image_names):
            return group
    index = next((i for i, control in enumerate(context.rig.controls) if control.name == name), -1)
    if index < 0:
        lost = name in {left.control for left in context.rig.left_off}
        if lost:
            return None
        known = (*(group.name for group in groups if group.name), *(each.name for each in context.rig.controls))
        what = f"{context.rig.root} has no control or element {name!r}{meant(name, known)}"
        raise refuse("CONFIG_UNKNOWN_CONTROL", where, what)
    return next((group for group in groups if any(index in copy for copy in (group.controls, *group.images))), None)


def _stands(context: Context, name: str) -> bool:
    """Whether an element or control of that name is part of the layout that a shot's stands over."""
    elements = context.standing.elements if context.standing is not None else ()
    return any(name in (element.name, *(member.control for member in element.members)) for element in elements)


def _check(inner: dict[str, set[str]], told: dict[str, set[str]]) -> None:
    """Two levels: what the configuration names contradicts itself, what is derived gives way."""
    for name, members in inner.items():
        if name in members:
            raise refuse("CONFIG_VALUE", f'levels.members."{name}"', f"{name} is a member of itself")
    for name in sorted(inner):
        holders = sorted(other for other, members in inner.items() if name in members)
        if not holders:
            continue
        if name in told and any(other in told for other in holders):
            raise refuse(
                "CONFIG_VALUE", f'levels.members."{name}"', f"is a member of {holders[0]}; there are two levels only"
            )
        if name in told:
            for other in holders:
                inner[other].discard(name)
        else:
            inner[name].clear()


def _with_states(groups: Iterable[Group], inner: dict[str, set[str]]) -> Iterator[Group]:
    """The groups with their members and the states in which they are visible: none opened, each one, all of them."""
    coarse = sorted(name for name, members in inner.items() if members)
    holders: dict[str, set[int]] = {}
    for state, name in enumerate(coarse, start=1):
        for member in inner[name]:
            holders.setdefault(member, set()).add(state)
    all_open = len(coarse) + 1
    every = frozenset(range(all_open + 1))
    for group in groups:
        members = tuple(sorted(inner.get(group.name, ())))
        own = every - {coarse.index(group.name) + 1, all_open} if members else every
        if group.part and group.name not in holders:
            continue
        inside = frozenset({*holders.get(group.name, ()), all_open})
        yield replace(group, inner=members, states=inside if group.name in holders else own)
