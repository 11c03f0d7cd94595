"""What is known of a part of a character before its elements are placed."""

from __future__ import annotations

from usdrigui.character import Record
from usdrigui.layout.face import Face
from usdrigui.layout.motion.similarity import Similarity
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import Classification
from usdrigui.settings import CandidateSettings, Settings


class Measured(Record):
    """What the stages of grouping and placing read."""

    face: Face
    similarity: Similarity
    requests: Requests
    classification: tuple[Classification, ...]
    """(motions,)."""
    settings: Settings

    @property
    def pruning(self) -> CandidateSettings:
        """The settings of the candidates."""
        return self.settings.candidates
