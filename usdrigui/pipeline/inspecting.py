"""inspect(): what the stages before the search find out about an asset."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from usdrigui.character import Control, Rig
from usdrigui.character.joint_tree import Tree
from usdrigui.errors import Issue, of_character
from usdrigui.layout.group.grouping import suggested_groups
from usdrigui.layout.reuse.identity import names_draft
from usdrigui.model import Classification, Motion
from usdrigui.pipeline import animation
from usdrigui.pipeline.configuration import refuse_unsound
from usdrigui.pipeline.joining import issues_of
from usdrigui.pipeline.progress import Clock, ProgressCallback
from usdrigui.pipeline.records import Character, ProblemInputs
from usdrigui.pipeline.reference_layouts import ReferenceLayers, read_references
from usdrigui.pipeline.stages import build_problem, character_of, part_problem
from usdrigui.reader.reader_process import read_rigs_isolated
from usdrigui.report.inspection import CharacterFacts, ControlFacts, Inspection, Likeness, PartFacts
from usdrigui.settings import Settings


def inspect(
    asset: Path,
    settings: Settings,
    *,
    progress: ProgressCallback | None = None,
    animations: Sequence[Path] = (),
    like: Path | None = None,
) -> Inspection:
    """What the stages before the search find out about `asset`; writes nothing.

    `animations` show how its controls are used, `like`, the layout of another character, which
    control is which there.
    """
    clock = Clock(progress)
    with clock.stage("read"):
        source = read_rigs_isolated(asset, settings)
        opening = settings.read
        clips = animation.performances(animations, opening)
        references = read_references(ReferenceLayers(like=like), opening, source)
        refuse_unsound(source, settings, references.like)
    issues: list[Issue] = []
    characters = []
    for rig in source.rigs:
        own_clock = clock.of(rig.path, told=len(source.rigs) > 1)
        character = character_of(rig, settings, references, own_clock)
        parts = [
            part_problem(character, part, (), own_clock.of(part.name)) for part in character.parts
        ]
        issues += issues_of(parts)
        facts = _facts(character, parts)
        if clips:
            whole = parts[0]
            if len(parts) > 1:
                whole = build_problem(rig, settings, references, own_clock)
            uses, odd = animation.animation_facts(whole.face, clips, settings.animation.weight)
            facts = replace(facts, animation=uses)
            issues += of_character(rig.path_in_variants, odd)
        characters.append(facts)
    return Inspection(str(asset), tuple(characters), tuple(issues), clock.seconds)


def _facts(character: Character, parts: Sequence[ProblemInputs]) -> CharacterFacts:
    rig = character.rig
    moving = {
        motion.control: (inputs, motion, said)
        for inputs in parts
        for motion, said in zip(
            inputs.face.trajectories.motions, inputs.measured.classification, strict=True
        )
    }
    still = parts[0], None, Classification()
    flags: dict[str, list[str]] = {}
    for note in dict.fromkeys(
        (*rig.left_off, *(note for inputs in parts for note in inputs.left_off))
    ):
        flags.setdefault(note.control, []).append(note.reason)
    for odd in dict.fromkeys(each for inputs in parts for each in inputs.face.trajectories.issues):
        flags.setdefault(odd.path, []).append(odd.message)
    return CharacterFacts(
        root=rig.path,
        points=len(character.trajectories.surface.points),
        meshes=len(rig.body.meshes),
        joints=len(rig.body.joints),
        symmetric=float((character.symmetry.partner >= 0).mean()),
        controls=tuple(
            _control(control, index, moving.get(index, still), flags.get(control.name, ()))
            for index, control in enumerate(rig.controls)
        ),
        groups=tuple(line for inputs in parts for line in _group_lines(inputs)),
        without=_without_controls(rig),
        likeness=_likeness(parts[0]),
        parts=tuple(
            PartFacts(each.part, len(each.face.trajectories.motions), each.face.handle_width)
            for each in parts
        ),
    )


def _without_controls(rig: Rig) -> dict[str, list[str]]:
    """Names of the joints that are no controls, by the reason."""
    tree = Tree(rig.body.joints, rig.body.meshes)
    still = set(range(len(tree.joints))).difference(*(each.drive.joints for each in rig.controls))
    reasons = {
        "goes along with others; [joints.NAME] makes it a control": still & tree.bearers,
        "no skin hangs on it": still - tree.bearers,
    }
    return {why: [tree.joints[i].name for i in sorted(of)] for why, of in reasons.items() if of}


def _control(
    control: Control,
    index: int,
    found: tuple[ProblemInputs, Motion | None, Classification],
    flags: Sequence[str],
) -> ControlFacts:
    """One control, as the part to which it belongs finds it; without a motion it belongs to none,
    and the first one finds it."""
    inputs, motion, said = found
    symmetry = inputs.face.symmetry
    flags = list(flags)
    if said.category:
        flags.append("on the board by request" if said.category == "requested" else said.category)
    typical = inputs.face.trajectories.typical_length
    return ControlFacts(
        control=control.name,
        kind=control.kind,
        source=control.source,
        minimum=control.minimum,
        default=control.default,
        maximum=control.maximum,
        range_source=control.range_source,
        points=0 if motion is None else len(motion.points),
        coverage=said.coverage,
        peak=0.0 if motion is None else float(motion.arc_length.max()) / typical,
        twin=inputs.twin_names.get(control.name, "self" if symmetry.twins[index] == index else ""),
        twin_source=symmetry.sources[index],
        flags=tuple(flags),
        part="" if motion is None else inputs.part,
    )


def _likeness(inputs: ProblemInputs) -> Likeness | None:
    found = inputs.character.references.matchings.get("like")
    return None if found is None else Likeness(found, names_draft(found))


def _group_lines(inputs: ProblemInputs) -> tuple[str, ...]:
    names = inputs.face.rig.control_names
    return tuple(
        f"{group.kind} {group.name}: {', '.join(names[each] for each in group.controls)}"
        f" ({group.reason})"
        for group in inputs.placement.groups
        if len(group.controls) > 1
    ) + tuple(
        f"suggestion: {', '.join(found)} move the same region; [groups.groups] would make them one"
        " element"
        for found in suggested_groups(inputs.measured, inputs.candidates, inputs.placement.groups)
    )
