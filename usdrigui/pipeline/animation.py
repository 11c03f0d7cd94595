"""The use of a character's controls by animations: which they use, how often, and which together.

`weighted` turns that into importances for the objective, `animation_facts` into what `usdrigui
inspect` prints, configuration lines included.
"""

from __future__ import annotations

import functools
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from usdrigui.character import Control, Indices, Performance, Rig
from usdrigui.errors import Issue
from usdrigui.layout.group.grouping import share_a_place
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.activity import (
    Activity,
    activity,
    importances,
    together,
    with_importances,
)
from usdrigui.model import Candidates
from usdrigui.reader.reader_process import read_performances_isolated
from usdrigui.reader.reader_records import Opening
from usdrigui.report.inspection import AnimationFacts, TogetherFacts, UseFacts
from usdrigui.settings import ControlSettings

_ACTIVE = 0.05
"""Activity from which a control is active in a frame."""
_NAMED = 3
"""Controls of a set whose names make the name of its element."""


def performances(paths: Sequence[Path], opening: Opening) -> tuple[Performance, ...]:
    """Every animation of some files.  Raises ANIMATION_MISSING and everything that reading an asset
    can raise."""
    return tuple(each for path in paths for each in read_performances_isolated(path, opening))


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
    found = importances(activity(rig, clips), _twins(rig.controls, twins), weight)
    return with_importances(rig.controls, overrides, found)


def animation_facts(
    known: Measured, candidates: Candidates, clips: tuple[Performance, ...]
) -> tuple[AnimationFacts, tuple[Issue, ...]]:
    """The use of a character's controls by the animations, with warnings; raises as `weighted`."""
    rig, settings = known.face.rig, known.settings.character.animation
    done, twins = activity(rig, clips), _twins(rig.controls, known.face.symmetry.twins)
    worth = importances(done, twins, settings.weight)
    active = (done.amounts >= _ACTIVE).mean(axis=0)
    uses = [
        UseFacts(name, float(done.use[i]), float(active[i]), worth[name])
        for i, name in enumerate(done.controls)
        if name in worth
    ]
    uses.sort(key=lambda each: (-round(each.use, 9), each.control))
    one_place = functools.partial(share_a_place, known, candidates)
    sets = [
        _suggestion(rig.controls, controls, agreement, twins, one_place)
        for controls, agreement in together(done, twins, settings.together)
    ]
    text = "\n".join(
        [
            *_group_lines(sets, twins),
            *_pose_lines(sets, done, rig.controls),
            *_importance_lines(uses),
        ]
    )
    return AnimationFacts(done.clips, len(done.values), tuple(uses), tuple(sets), text), done.issues


def _twins(controls: tuple[Control, ...], twins: Indices) -> dict[str, str]:
    names = [control.name for control in controls]
    return {names[i]: names[twin] for i, twin in enumerate(twins.tolist()) if twin >= 0}


def _sides(controls: Sequence[str], twins: Mapping[str, str]) -> list[tuple[str, ...]]:
    """The set itself, or the one of either side where all its members come in pairs."""
    first: list[str] = []
    for name in controls:
        if twins.get(name, "") not in first:
            first.append(name)
    other = [twins.get(name, "") for name in first]
    paired = all(name and name not in first for name in other)
    return [tuple(first), tuple(other)] if paired else [tuple(controls)]


def _suggestion(
    every: tuple[Control, ...],
    controls: tuple[str, ...],
    agreement: float,
    twins: Mapping[str, str],
    one_place: Callable[[Sequence[str]], bool],
) -> TogetherFacts:
    sides = _sides(controls, twins)
    if all(len(side) > 1 and one_place(side) for side in sides):
        return TogetherFacts(controls, agreement, "group")
    shapes = [each for each in every if each.name in controls and each.kind == "blendShape"]
    return TogetherFacts(controls, agreement, "pose" if len(shapes) > 1 else "")


# --- configuration lines --------------------------------------------------------------------------


def _group_lines(sets: Sequence[TogetherFacts], twins: Mapping[str, str]) -> Iterator[str]:
    groups = [each for each in sets if each.suggestion == "group"]
    if groups:
        yield "[groups.groups]"
    for each in groups:
        for side in _sides(each.controls, twins):
            yield (
                f"{_quoted(_name(side))} = [{', '.join(map(_quoted, side))}]  # together"
                f" {each.agreement:.2f}"
            )
    if groups:
        yield ""


def _pose_lines(
    sets: Sequence[TogetherFacts], done: Activity, controls: tuple[Control, ...]
) -> Iterator[str]:
    """A pose for each set, as in the frame in which it moves most, and its controls as the
    members."""
    poses = [each for each in sets if each.suggestion == "pose"]
    shapes = {control.name: control.source for control in controls if control.kind == "blendShape"}
    for each in poses:
        columns = {name: done.controls.index(name) for name in each.controls if name in shapes}
        frame = int(done.amounts[:, list(columns.values())].sum(axis=1).argmax())
        weights = ", ".join(
            f"{_quoted(shapes[n])} = {done.values[frame, i]:.3g}" for n, i in columns.items()
        )
        yield f"[poses.{_quoted(_name(each.controls))}]  # together {each.agreement:.2f}"
        yield f"weights = {{ {weights} }}"
        yield ""
    if poses:
        yield "[levels.members]"
        for each in poses:
            yield f"{_quoted(_name(each.controls))} = [{', '.join(map(_quoted, each.controls))}]"
        yield ""


def _importance_lines(uses: Sequence[UseFacts]) -> Iterator[str]:
    for each in uses:
        if each.importance != 1.0:
            yield f"[controls.{_quoted(each.control)}]"
            yield f"importance = {each.importance:g}"


def _name(controls: Sequence[str]) -> str:
    """Name of an element of these controls that no control has."""
    named = "_".join(controls[:_NAMED])
    return named if len(controls) <= _NAMED else f"{named}_and_{len(controls) - _NAMED}_more"


def _quoted(text: str) -> str:
    """A TOML basic string: JSON's, which escapes what TOML wants escaped."""
    return json.dumps(text, ensure_ascii=True)
