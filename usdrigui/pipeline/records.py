"""What the stages hand to each other, from a character to the layouts of its parts."""

from __future__ import annotations

from usdrigui.character import Floats, LeftOff, Record, Rig
from usdrigui.errors import Issue, of_character
from usdrigui.layout.face import Face
from usdrigui.layout.measured import Measured
from usdrigui.layout.place.problem import PlacementProblem
from usdrigui.layout.reuse.identity import matching_issues
from usdrigui.layout.reuse.prior_layout import NO_PRIOR, PriorLayout
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import Assignment, Candidates, Layout, Symmetry, Trajectories
from usdrigui.pipeline.reference_layouts import OwnReferences
from usdrigui.settings import Settings


class CharacterPart(Record):
    """One part of a character, with what is found out about it by itself."""

    name: str
    trajectories: Trajectories
    symmetry: Symmetry
    prior: PriorLayout = NO_PRIOR
    """An earlier layout that its new one should be like."""

    @property
    def controls(self) -> frozenset[int]:
        """Indices of its controls."""
        return frozenset(motion.control for motion in self.trajectories.motions)


class Character(Record):
    """A character with its parts, ready to be laid out one part after the other."""

    rig: Rig
    settings: Settings
    base_values: Floats
    """(controls,) the base pose."""
    trajectories: Trajectories
    symmetry: Symmetry
    """Of the character as a whole."""
    parts: tuple[CharacterPart, ...]
    """In the order in which they are laid out."""
    references: OwnReferences
    requests: Requests


class ProblemInputs(Record):
    """The layout problem of one part of a character, and what it was built from."""

    character: Character
    part: str
    """Name of the part."""
    measured: Measured
    candidates: Candidates
    placement: PlacementProblem

    @property
    def face(self) -> Face:
        """The part as measured."""
        return self.measured.face

    @property
    def requests(self) -> Requests:
        """What holds for this part."""
        return self.measured.requests

    @property
    def settings(self) -> Settings:
        """Those of the run."""
        return self.character.settings

    @property
    def issues(self) -> tuple[Issue, ...]:
        """Findings about the rig and its controls."""
        renamed = (
            told
            for which, matching in self.character.references.matchings.items()
            for told in matching_issues(which, matching)
        )
        rig, odd = self.face.rig, self.face.trajectories.issues
        told = (*odd, *renamed, *self.requests.pins.issues)
        return (*rig.issues, *of_character(rig.path_in_variants, told))

    @property
    def explained_by(self) -> dict[str, dict[str, float]]:
        """Names of the controls that others explain, to those and how far each of them goes."""
        names = self.face.names
        named = zip(names, self.measured.classification, strict=True)
        return {name: {names[i]: amount for i, amount in each.explained_by} for name, each in named}

    @property
    def left_off(self) -> tuple[LeftOff, ...]:
        """Controls that the stages after reading left off, and why."""
        return (*self.face.trajectories.left_off, *self.candidates.left_off)

    @property
    def twin_names(self) -> dict[str, str]:
        """Names of the controls that have a twin other than themselves, to its name."""
        names, twins = self.face.rig.control_names, self.face.symmetry.twins.tolist()
        return {names[i]: names[twin] for i, twin in enumerate(twins) if twin not in (-1, i)}


class LaidPart(Record):
    """One part of a character, laid out."""

    inputs: ProblemInputs
    layout: Layout
    assignment: Assignment
