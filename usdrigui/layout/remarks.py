"""What the configuration says about each control, whether it goes by its old name or by its new one."""

from __future__ import annotations

from dataclasses import replace

from usdrigui.model import Rig
from usdrigui.settings import ControlSettings, Settings


def remarks(rig: Rig, settings: Settings) -> tuple[ControlSettings, ...]:
    """(controls,) the configuration's part for every control of `rig`; defaults where it says nothing."""
    renamed = {said.rename: said for said in settings.controls.values() if said.rename}
    plain = ControlSettings()
    said = {c.name: renamed.get(c.name) or settings.controls.get(c.name, plain) for c in rig.controls}
    for members in settings.groups.groups.values():
        anchors = {said[name].anchor for name in members if name in said} - {""}
        if len(anchors) == 1:
            # One element has one anchor: fixing a member fixes the group.
            said |= {name: replace(said[name], anchor=min(anchors)) for name in members if name in said}
    return tuple(said[c.name] for c in rig.controls)


def control_index(rig: Rig, settings: Settings) -> dict[str, int]:
    """Index of every control by its name, and by the name that the configuration replaced."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    for old, said in settings.controls.items():
        if said.rename in index:
            index.setdefault(old, index[said.rename])
    return index
