"""Why a new layout is asked for: what a person, or a layout that exists, fixes, prefers or leaves
out, by control."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field, replace

from usdrigui.character import Control, Record
from usdrigui.layout.control_overrides import Named, controls_named
from usdrigui.layout.reuse.pinned import Pins
from usdrigui.layout.reuse.prior_layout import NO_PRIOR, PriorLayout
from usdrigui.model import Element, Layout
from usdrigui.settings import ControlSettings


class Requests(Record):
    """What the rigger and earlier layouts ask for; made once for a character."""

    configured: tuple[ControlSettings, ...]
    """(controls,) the configuration of each control."""
    overrides: tuple[ControlSettings, ...]
    """(controls,) with what layouts, decisions and twins fix, and what animation weighs."""
    groups: Named = field(default_factory=dict)
    """The controls that are to share an element, by its name."""
    levels: Named = field(default_factory=dict)
    """The members of coarse elements."""
    prior: PriorLayout = NO_PRIOR
    """An earlier layout that the new one should be like, in the requests of a part."""
    existing: Layout | None = None
    """A layout that stays as it is and to which the new one adds elements."""
    neighbours: tuple[Element, ...] = ()
    """Elements of other parts of the character, from which the new ones keep clear."""
    pins: Pins = Pins()
    """Decisions of a person in the layout that the new one succeeds."""

    @property
    def existing_elements(self) -> tuple[Element, ...]:
        """The elements of the existing layout."""
        return self.existing.elements if self.existing is not None else ()

    @property
    def existing_names(self) -> frozenset[str]:
        """Names of the elements of the existing layout, and of their controls."""
        elements = self.existing_elements
        return frozenset().union(*({each.name, *each.controls} for each in elements))

    def of_axes(self) -> Requests:
        """What holds for the sliders that controls have of their own under a coarse element."""
        overrides = tuple(replace(each, anchor=each.inner_anchor) for each in self.overrides)
        return replace(
            self, overrides=overrides, prior=replace(self.prior, places=self.prior.axis_places)
        )

    def of_part(
        self,
        controls: tuple[Control, ...],
        part: frozenset[int],
        neighbours: Iterable[Element],
        prior: PriorLayout,
    ) -> Requests:
        """Without the groups and levels that only controls of other parts have; `part` are those of
        this one, `neighbours` the elements of the parts that are laid out already, `prior` is the
        earlier layout that this one should be like."""
        index = {control.name: i for i, control in enumerate(controls)}

        def concerns(names: Iterable[str]) -> bool:
            named = controls_named(names, self.groups, index)
            return not named or not part.isdisjoint(named)

        return replace(
            self,
            groups={name: own for name, own in self.groups.items() if concerns(own)},
            levels={name: own for name, own in self.levels.items() if concerns((name, *own))},
            neighbours=tuple(neighbours),
            prior=prior,
        )
