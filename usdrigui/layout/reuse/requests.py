"""What a new layout is asked for: the configuration of its controls, and the layouts that exist."""

from __future__ import annotations

from dataclasses import dataclass, replace

from usdrigui.conventions import Meaning
from usdrigui.layout.canonical_face import Expectation
from usdrigui.layout.reuse.prior_layout import NO_PRIOR, PriorLayout
from usdrigui.model import Element, Layout
from usdrigui.settings import ControlSettings


@dataclass(frozen=True)
class Names:
    """The meanings of controls' names by the conventions of the field."""

    meanings: tuple[Meaning | None, ...] = ()
    """(controls,) how each is read; None where it means nothing or is not read."""
    expected: tuple[Expectation | None, ...] = ()
    """(controls,) where each is expected; empty before the face is known."""


NO_NAMES = Names()


@dataclass(frozen=True, eq=False)
class Requests:
    """What the rigger and earlier layouts ask for."""

    overrides: tuple[ControlSettings, ...]
    """(controls,) the configuration of each control."""
    prior: PriorLayout = NO_PRIOR
    """An earlier layout that the new one should be like."""
    existing: Layout | None = None
    """A layout that stays as it is and to which the new one adds elements."""
    neighbours: tuple[Element, ...] = ()
    """Elements of other parts of the character, from which the new ones keep clear."""
    names: Names = NO_NAMES
    """The meanings of the controls' names."""

    def meaning(self, control: int) -> Meaning | None:
        """How the name of a control is read; None where it means nothing or is not read."""
        return self.names.meanings[control] if self.names.meanings else None

    def expectation(self, control: int) -> Expectation | None:
        """Where a control is expected; None where its name means nothing."""
        return self.names.expected[control] if self.names.expected else None

    @property
    def fixed_elements(self) -> tuple[Element, ...]:
        """The elements that stay where they are: of the existing layout, and of other parts."""
        return (*(self.existing.elements if self.existing is not None else ()), *self.neighbours)

    @property
    def existing_names(self) -> frozenset[str]:
        """Names of the elements of the existing layout, and of their controls."""
        if self.existing is None:
            return frozenset()
        return self.existing.controls | {element.name for element in self.existing.elements}

    def of_axes(self) -> Requests:
        """What holds for the sliders that controls have of their own under a coarse element."""
        overrides = tuple(replace(each, anchor=each.inner_anchor) for each in self.overrides)
        return replace(
            self, overrides=overrides, prior=replace(self.prior, places=self.prior.axis_places)
        )
