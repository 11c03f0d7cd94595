"""The use of controls by animation: how much each is used.

The activity of a control in a frame is how far it is from its default, as a share of how far it can
go, from 0 to 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import Control, Floats, Indices, Performance, Record, Rig
from usdrigui.character.clip_reading import turning
from usdrigui.errors import Issue, issue, listed, refuse
from usdrigui.layout.shares import NOTHING, OUTLIER
from usdrigui.settings import ControlSettings


class Activity(Record):
    """What some animations make a character do."""

    controls: tuple[str, ...]
    amounts: Floats
    """(frames, controls) activity; nan for poses."""
    clips: tuple[str, ...]
    """``FILE/PRIM/PATH`` of every animation."""
    issues: tuple[Issue, ...]

    @property
    def use(self) -> Floats:
        """(controls,) mean activity."""
        return np.asarray(self.amounts.mean(axis=0))


def activity(rig: Rig, performances: Iterable[Performance]) -> Activity:
    """The activity of every control over all frames of all animations, which have none of poses.

    Raises CLIP_FOREIGN where they move nothing that the rig has a control for.
    """
    clips = tuple(performances)
    values = np.concatenate([_values(rig, clip) for clip in clips])
    extent = np.array([max(c.maximum - c.default, c.default - c.minimum) for c in rig.controls])
    amounts = np.clip(np.abs(values - rig.defaults) / extent, 0.0, 1.0)
    names = tuple(f"{clip.source}{clip.path}" for clip in clips)
    unknown = sorted({token for clip in clips for token in _moving_tokens(clip)} - _tokens(rig))
    why, issues = "is moved by none of them", tuple[Issue, ...]()
    if unknown:
        what = f"{len(unknown)} of them: {listed(unknown)}"
        issues = (issue("CLIP_UNKNOWN_CONTROL", rig.path, what),)
        why = f"has no control for what they move: {listed(unknown)}"
    if not (amounts.mean(axis=0) > NOTHING).any():
        raise refuse("CLIP_FOREIGN", rig.path, why)
    return Activity(rig.control_names, amounts, names, issues)


def importances(done: Activity, twins: Indices, weight: float) -> dict[str, float]:
    """How much each control matters by its use: 1 for the mean one, 1 - weight for one that is
    never used; `twins` (controls,) are their mirror controls, -1 for none.

    Rounded to hundredths, as in a configuration; poses, for which animations show
    nothing, are left out.
    """
    units = _units(done, twins)
    use = np.array([done.use[list(unit)].mean() for unit in units])
    share = np.minimum(use / use.mean(), OUTLIER)
    return {
        done.controls[i]: round(float(1.0 + weight * (each - 1.0)), 2)
        for unit, each in zip(units, share, strict=True)
        for i in unit
    }


def with_importances(
    controls: tuple[Control, ...], overrides: Sequence[ControlSettings], found: Mapping[str, float]
) -> tuple[ControlSettings, ...]:
    """(controls,) `overrides` with the importance `found` for every control to which the
    configuration gives none."""
    return tuple(
        override
        if override.importance is not None
        else replace(override, importance=found.get(control.name))
        for control, override in zip(controls, overrides, strict=True)
    )


def _units(done: Activity, twins: Indices) -> list[tuple[int, ...]]:
    """Controls that animations can use, a pair as one."""
    units: list[tuple[int, ...]] = []
    taken: set[int] = set()
    for i, twin in enumerate(twins.tolist()):
        if i in taken or not np.isfinite(done.amounts[0, i]):
            continue
        units.append((i,) if twin in (-1, i, *taken) else (i, twin))
        taken.update(units[-1])
    return units


# --- control values -------------------------------------------------------------------------------


def _values(rig: Rig, clip: Performance) -> Floats:
    """(frames, controls) values; the default of controls that the animation does not have."""
    values = np.repeat(rig.defaults[None], len(clip.times), axis=0)
    tokens = {token: column for column, token in enumerate(clip.tokens)}
    for i, control in enumerate(rig.controls):
        if control.kind == "blendShape" and control.source in tokens:
            values[:, i] = clip.weights[:, tokens[control.source]]
        elif control.kind == "pose":
            values[:, i] = np.nan
        elif found := turning(control):
            joint = rig.body.joints[found.joint]
            same = [k for k, path in enumerate(clip.joints) if path == joint.path]
            same = same or [
                k for k, path in enumerate(clip.joints) if f"/{path}".endswith(f"/{joint.name}")
            ]
            if len(same) == 1:
                values[:, i] += found.turned(rig.body, clip.rotations[:, same[0]])
    return values


def _moving_tokens(clip: Performance) -> list[str]:
    moving = np.ptp(clip.weights, axis=0) > 0.0
    return [token for token, moves in zip(clip.tokens, moving.tolist(), strict=True) if moves]


def _tokens(rig: Rig) -> set[str]:
    """Blend shapes that some control sets, and those that became no control for a reason that is
    reported."""
    used = {
        rig.body.channels[int(channel)].token
        for control in rig.controls
        for channel in control.drive.channels
    }
    return used | {left.control for left in rig.left_off}
