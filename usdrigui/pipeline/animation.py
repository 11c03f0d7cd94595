"""The use of a character's controls by animations: which they use, and how often.

`weighted` turns that into importances for the objective, `animation_facts` into what `usdrigui
inspect` prints, configuration lines included.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from usdrigui.character import Indices, Performance, Rig
from usdrigui.errors import Issue
from usdrigui.layout.face import Face
from usdrigui.layout.motion.activity import (
    activity,
    importances,
    with_importances,
)
from usdrigui.reader.reader_process import read_isolated
from usdrigui.report.inspection import AnimationFacts, UseFacts
from usdrigui.settings import ControlSettings, ReadSettings

_ACTIVE = 0.05
"""Activity from which a control is active in a frame."""


def performances(paths: Sequence[Path], opening: ReadSettings) -> tuple[Performance, ...]:
    """Every animation of some files.  Raises ANIMATION_MISSING and everything that reading an asset
    can raise."""
    kind = tuple[Performance, ...]
    return tuple(each for path in paths for each in read_isolated("clips", path, opening, kind))


def weighted(
    rig: Rig,
    twins: Indices,
    used: tuple[tuple[ControlSettings, ...], tuple[Performance, ...]],
    weight: float,
) -> tuple[ControlSettings, ...]:
    """(controls,) the overrides with the importance that its use in animations gives to every
    control; `used` are the overrides and the animations.

    A configured importance is stronger; `weight` is that of use.  Raises CLIP_FOREIGN where no clip
    is of this character.
    """
    overrides, clips = used
    found = importances(activity(rig, clips), twins, weight)
    return with_importances(rig.controls, overrides, found)


def animation_facts(
    face: Face, clips: tuple[Performance, ...], weight: float
) -> tuple[AnimationFacts, tuple[Issue, ...]]:
    """The use of a character's controls by the animations, with warnings; raises as `weighted`."""
    done = activity(face.rig, clips)
    worth = importances(done, face.symmetry.twins, weight)
    active = (done.amounts >= _ACTIVE).mean(axis=0)
    uses = [
        UseFacts(name, float(done.use[i]), float(active[i]), worth[name])
        for i, name in enumerate(done.controls)
        if name in worth
    ]
    uses.sort(key=lambda each: (-round(each.use, 9), each.control))
    lines = (
        f"[controls.{json.dumps(each.control)}]\nimportance = {each.importance:g}"
        for each in uses
        if each.importance != 1.0
    )
    return AnimationFacts(done.clips, len(done.amounts), tuple(uses), "\n".join(lines)), done.issues
