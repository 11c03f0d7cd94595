"""What the configuration sets for each control, whether it goes by its old name or by its new
one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from usdrigui.model import Rig
from usdrigui.settings import ControlSettings


def control_overrides(
    rig: Rig,
    controls: Mapping[str, ControlSettings],
    groups: Mapping[str, Sequence[str]] | None = None,
) -> tuple[ControlSettings, ...]:
    """(controls,) the configuration's `controls` for every control of `rig`, and its
    `groups` of their anchors; defaults where it sets nothing."""
    renamed = {each.rename: each for each in controls.values() if each.rename}
    plain = ControlSettings()
    found = {c.name: renamed.get(c.name) or controls.get(c.name, plain) for c in rig.controls}
    for members in (groups or {}).values():
        anchors = {found[name].anchor for name in members if name in found} - {""}
        if len(anchors) == 1:
            # One element has one anchor: fixing a member fixes the group.
            (anchor,) = anchors
            found |= {
                name: replace(found[name], anchor=anchor) for name in members if name in found
            }
    return tuple(found[c.name] for c in rig.controls)


def control_index(rig: Rig, controls: Mapping[str, ControlSettings]) -> dict[str, int]:
    """Index of every control by its name, and by the name that `controls`, of the configuration,
    replaced."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    for old, override in controls.items():
        if override.rename in index:
            index.setdefault(old, index[override.rename])
    return index
