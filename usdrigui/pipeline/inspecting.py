"""inspect(): what the stages before the search find out about an asset."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from usdrigui import animation
from usdrigui.examples import ExampleLayers, read_examples
from usdrigui.inspection import CharacterFacts, ControlFacts, Inspection, Likeness
from usdrigui.layout.group.grouping import suggested_groups
from usdrigui.layout.reuse.identity import names_draft
from usdrigui.pipeline.progress import Clock, Watch
from usdrigui.pipeline.stages import ProblemInputs, build_problem
from usdrigui.settings import Settings
from usdrigui.usd.reader_process import read_rigs_isolated


def inspect(
    asset: Path,
    settings: Settings,
    *,
    progress: Watch | None = None,
    animations: Sequence[Path] = (),
    like: Path | None = None,
) -> Inspection:
    """What the stages before the search find out about `asset`; writes nothing.

    `animations` tell how its controls are used, `like`, the layout of another character, which control is which there.
    """
    clock = Clock(progress)
    with clock.stage("read"):
        source = read_rigs_isolated(asset, settings)
        clips = animation.performances(animations, settings)
        examples = read_examples(ExampleLayers(like=like), settings)
    found = [build_problem(rig, settings, clock, source.cameras, examples) for rig in source.rigs]
    issues = [each for inputs in found for each in inputs.issues]
    characters = []
    for inputs in found:
        facts = _facts(inputs)
        if clips:
            uses, odd = animation.animation_facts(
                inputs.face, inputs.candidates, inputs.similarity, inputs.requests, inputs.settings, clips
            )
            facts = replace(facts, animation=uses)
            issues += odd
        characters.append(facts)
    return Inspection(str(asset), tuple(characters), tuple(issues), clock.seconds)


def _facts(inputs: ProblemInputs) -> CharacterFacts:
    rig, trajectories, symmetry = inputs.face.rig, inputs.face.trajectories, inputs.face.symmetry
    sets = {trajectories.motions[each.motion].control: each for each in inputs.candidates.sets}
    motions = {each.control: each for each in trajectories.motions}
    twins = inputs.twin_names
    remarks: dict[str, list[str]] = {}
    for note in (*rig.left_off, *inputs.left_off):
        remarks.setdefault(note.control, []).append(note.reason)
    for found in trajectories.issues:
        remarks.setdefault(found.path, []).append(found.message)
    rows = []
    for index, control in enumerate(rig.controls):
        chosen, motion = sets.get(index), motions.get(index)
        flags = list(remarks.get(control.name, ()))
        if chosen is not None and chosen.category:
            flags.append("on the board by request" if chosen.category == "requested" else chosen.category)
        rows.append(
            ControlFacts(
                control=control.name,
                kind=control.kind,
                source=control.source,
                minimum=control.minimum,
                default=control.default,
                maximum=control.maximum,
                range_source=control.range_source,
                points=0 if motion is None else len(motion.points),
                coverage=0.0 if chosen is None else chosen.coverage,
                peak=0.0 if motion is None else float(motion.arc_length.max()) / trajectories.typical_length,
                twin=twins.get(control.name, "self" if symmetry.twins[index] == index else ""),
                twin_source=symmetry.sources[index],
                flags=tuple(flags),
            )
        )
    return CharacterFacts(
        root=rig.root,
        points=len(trajectories.base),
        meshes=len(rig.meshes),
        joints=len(rig.joints),
        symmetric=float((symmetry.partner >= 0).mean()),
        controls=tuple(rows),
        groups=_group_lines(inputs),
        likeness=_likeness(inputs),
    )


def _likeness(inputs: ProblemInputs) -> Likeness | None:
    found = inputs.matchings.get("like")
    return None if found is None else Likeness(found, names_draft(found))


def _group_lines(inputs: ProblemInputs) -> tuple[str, ...]:
    names = [control.name for control in inputs.face.rig.controls]
    return tuple(
        f"{group.kind} {group.name}: {', '.join(names[each] for each in group.controls)} ({group.reason})"
        for group in inputs.placement.groups
        if len(group.controls) > 1
    ) + tuple(
        f"suggestion: {', '.join(found)} move the same region; [groups.groups] would make them one element"
        for found in suggested_groups(
            inputs.face, inputs.candidates, inputs.similarity, inputs.requests, inputs.settings
        )
    )
