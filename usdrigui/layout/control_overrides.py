"""What the configuration sets for each control, whether it goes by its old name or by its new
one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from usdrigui.character import Rig
from usdrigui.settings import ControlSettings

Named = Mapping[str, Sequence[str]]
"""By the name of an element, names of controls."""


def control_overrides(
    rig: Rig, controls: Mapping[str, ControlSettings]
) -> tuple[ControlSettings, ...]:
    """(controls,) the configuration's `controls` for every control of `rig`; defaults where it sets
    nothing."""
    renamed = {each.rename: each for each in controls.values() if each.rename}
    plain = ControlSettings()
    return tuple(
        renamed.get(control.name) or controls.get(control.name, plain) for control in rig.controls
    )


def with_anchors_of_groups(
    rig: Rig, overrides: Sequence[ControlSettings], groups: Named
) -> tuple[ControlSettings, ...]:
    """(controls,) the overrides with one anchor for all controls of each group: one element has
    one, so that fixing a member fixes the group."""
    found = list(overrides)
    index = rig.control_indices
    for names in groups.values():
        members = [index[name] for name in names if name in index]
        anchors = {found[i].anchor for i in members} - {""}
        if len(anchors) == 1:
            (anchor,) = anchors
            for i in members:
                found[i] = replace(found[i], anchor=anchor)
    return tuple(found)


def control_index(rig: Rig, controls: Mapping[str, ControlSettings]) -> dict[str, int]:
    """Index of every control by its name, and by the name that `controls`, of the configuration,
    replaced."""
    index = dict(rig.control_indices)
    for old, override in controls.items():
        if override.rename in index:
            index.setdefault(old, index[override.rename])
    return index


def controls_named(names: Iterable[str], groups: Named, index: Mapping[str, int]) -> list[int]:
    """The controls that bear some names, and those of the elements that do."""
    found = []
    for name in names:
        members = groups.get(name, (name,))
        found += [index[member] for member in members if member in index]
        if name not in index and name not in groups:
            found += [i for control, i in index.items() if name.startswith(f"{control}_")]
    return found
