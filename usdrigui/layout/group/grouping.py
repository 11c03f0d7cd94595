"""Which controls share one element (paper sections 3.2 and 4.2, multi-parameter grouping).

Groups come from the user, from opposed controls (the two ends of one axis become one bipolar
slider), from axes that share a region (two of them become a joystick), and, where asked for, from
the Jaccard index of the controls' candidates as in the paper.  Whatever is merged on one side of
the character is merged on the other.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, combinations, product
from typing import Any

import numpy as np

from usdrigui.character import Flags
from usdrigui.conventions.sides import has_side
from usdrigui.errors import Faults, check_known, refuse
from usdrigui.layout.control_overrides import control_index
from usdrigui.layout.group.evidence import Evidence
from usdrigui.layout.group.own_places import has_own_place
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.similarity import bidirectional
from usdrigui.layout.names import element_name
from usdrigui.layout.symmetry.lobes import ASIDE, two_lobed
from usdrigui.layout.symmetry.orbits import configured_orbits
from usdrigui.model import Candidates, ElementKind, Group
from usdrigui.model.candidates import axes_of


@dataclass(frozen=True)
class _Merged:
    """Motions that share an element."""

    axes: tuple[tuple[int, ...], ...]
    """The motion of each axis, or the negative and the positive end of a signed one."""
    reason: str = ""
    name: str = ""
    doubled: bool = False
    """Whether the layout given has it on either side of the middle."""

    @property
    def motions(self) -> tuple[int, ...]:
        """All, in the order of the element."""
        return tuple(chain.from_iterable(self.axes))

    @property
    def kind(self) -> ElementKind:
        """By the number of axes."""
        return ("slider", "patch", "fan")[min(len(self.axes), 3) - 1]


_Proposal = tuple[Any, list[_Merged]]
"""By what it is ranked, and an element with its mirror image."""


def find_groups(known: Measured, candidates: Candidates) -> tuple[Group, ...]:
    """One group per element, by name; every control that has candidates is in exactly one.

    Of two elements that mirror each other only the one on the character's left becomes a group, and
    the other is its image.  Raises CONFIG_UNKNOWN_CONTROL and CONFIG_VALUE for groups of the
    configuration.
    """
    grouping, face = _Grouping(known, candidates), known.face
    names = control_index(face.rig, known.settings.controls)
    orbits = configured_orbits(
        face.rig.controls, face.trajectories, known.requests.overrides, names
    )
    merged = grouping.of_the_user()
    merged += [_Merged(((i,),)) for i in sorted(set().union(*orbits))]
    ways: list[Callable[[set[int]], list[_Merged]]] = [grouping.of_the_prior_layout]
    if grouping.settings.opposed:
        ways.append(grouping.sliders_and_joysticks)
    if grouping.settings.patches:
        ways.append(grouping.patches)
    for way in (*ways, grouping.alone):
        merged += way(set(grouping.sets) - _motions_of(merged))
    return grouping.folded(merged, orbits)


def check_groups(groups: Mapping[str, Sequence[str]], known: Collection[str]) -> None:
    """Raise CONFIG_UNKNOWN_CONTROL for all members of groups that are not `known`, CONFIG_VALUE for
    those of two groups."""
    faults, taken = Faults(), set[str]()
    for name, members in groups.items():
        where = f'groups.groups."{name}"'
        for member in members:
            with faults.collected():
                check_known(member, known, where)
                if member in taken:
                    what = f"{member} is listed twice: a control can be in one group only"
                    raise refuse("CONFIG_VALUE", where, what)
                taken.add(member)
    faults.raise_all()


def suggested_groups(
    known: Measured, candidates: Candidates, groups: Sequence[Group]
) -> tuple[tuple[str, ...], ...]:
    """Names of controls that the paper's Jaccard criterion would group and `groups`, as
    `find_groups` made them, leave apart."""
    grouping = _Grouping(known, candidates)
    single = [group for group in groups if len(group.controls) == 1 and not group.part]
    apart = frozenset().union(*(group.all_controls for group in single))
    free = {i for i in grouping.sets if grouping.controls[i] in apart}
    return tuple(
        tuple(grouping.names[i] for i in found.motions) for found in grouping.patches(free)
    )


def _motions_of(merged: Iterable[_Merged]) -> set[int]:
    return set().union(*(element.motions for element in merged))


def _compatible(proposals: Iterable[_Proposal]) -> list[_Merged]:
    """The elements of the best proposals, each motion in one."""
    found: list[_Merged] = []
    for _, elements in sorted(proposals, key=lambda proposal: proposal[0]):
        if not _motions_of(found) & _motions_of(elements):
            found += elements
    return found


class _Grouping:
    """What the ways to group have in common: candidates by motion, twins by motion, comparisons."""

    def __init__(self, known: Measured, candidates: Candidates) -> None:
        face, requests = known.face, known.requests
        motions, mirror = face.trajectories.motions, known.settings.symmetry
        self.face, self.similarity, self.requests = face, known.similarity, requests
        self.settings = known.settings.groups
        self.double_middle = mirror.double_middle
        self.two_sided = frozenset(bidirectional(motions))
        self.controls = [motion.control for motion in motions]
        self.sets = {
            i: candidates.sets[control]
            for i, control in enumerate(self.controls)
            if control in candidates.sets
        }
        self.classification = known.classification
        self.category = {i: known.classification[i].category for i in self.sets}
        self.names = [face.control_name(control) for control in self.controls]
        # What the only view does not see holds no element, be it the image of one that is seen.
        fold = mirror.fold and not face.views.one_sided(face.symmetry.plane.normal)
        twins = face.twins.tolist()
        twin = {i: twins[i] if fold and twins[i] in self.sets else -1 for i in self.sets}
        # A control with a place of its own is not folded, and neither is its twin.
        alone = {
            i
            for i, other in twin.items()
            if other != i and has_own_place(face, requests, self.controls[i])
        }
        self.twin = {i: -1 if {i, other} & alone else other for i, other in twin.items()}
        self.evidence = Evidence(face, known.similarity, self.twin)

    # --- what others decided ----------------------------------------------------------------------

    def of_the_user(self) -> list[_Merged]:
        """The groups that the configuration names, in its order."""
        index = {name: i for i, name in enumerate(self.names)}
        check_groups(self.requests.groups, self.face.rig.control_names)
        found: list[_Merged] = []
        for name, members in self.requests.groups.items():
            axes: list[tuple[int, ...]] = []
            for motion in (index[m] for m in members if index.get(m) in self.sets):
                # Opposed members side by side make one axis.
                if axes and len(axes[-1]) == 1 and self._opposed(*axes[-1], motion):
                    axes[-1] += (motion,)
                else:
                    axes.append((motion,))
            if sum(map(len, axes)) < 2:
                what = "a group needs two controls that move something"
                raise refuse("CONFIG_VALUE", f'groups.groups."{name}"', what)
            found.append(_Merged(tuple(axes), "grouped by the configuration", name))
        return found

    def of_the_prior_layout(self, free: set[int]) -> list[_Merged]:
        """The groups of an earlier layout whose members still belong in one place, single controls
        included."""
        index = {self.controls[i]: i for i in free}
        found: list[_Merged] = []
        for group in self.requests.prior.groups:
            members = [
                [index[group.controls[i]] for i in axis if group.controls[i] in index]
                for axis in axes_of(len(group.controls), group.opposed)
            ]
            whole = sum(map(len, members)) == len(group.controls)
            axes = tuple(tuple(axis) for axis in members if axis)
            if not whole:
                axes = tuple((i,) for i in chain.from_iterable(axes))
            if not axes or len({bool(self.category[i]) for i in chain.from_iterable(axes)}) > 1:
                continue
            several = sum(map(len, axes)) > 1
            found.append(
                _Merged(
                    axes,
                    "as in the layout given" if several else "",
                    group.name if whole else "",
                    group.doubled,
                )
            )
        return found

    # --- opposed controls and joysticks -----------------------------------------------------------

    def sliders_and_joysticks(self, free: set[int]) -> list[_Merged]:
        """Opposed controls as axes, joined two by two where they share a region and cross, or with
        a single control."""
        sliders = _compatible(self._sliders(free))
        single = free - _motions_of(sliders)
        swinging = [_Merged(((i,),)) for i in sorted(single & self.two_sided)]
        lone = [_Merged(((i,),)) for i in sorted(single - self.two_sided)]
        pairs = combinations(sorted([*sliders, *swinging], key=lambda axis: axis.motions), 2)
        made = _compatible(
            [
                *self._joysticks(pairs),
                *self._joysticks(product(sliders, lone), second_choice=True),
            ]
        )
        used = _motions_of(made)
        return [*made, *(axis for axis in sliders if not used & {*axis.motions})]

    def _sliders(self, free: set[int]) -> Iterable[_Proposal]:
        """Pairs of opposed controls, those of the convention and the clearest first."""
        for a, b in combinations(sorted(free - self.two_sided), 2):
            if self._share_a_slider(a, b):
                score = round(float(self.similarity.cosine[a, b]), 9)
                known = self.evidence.ends_by_convention(a, b)
                names = sorted((self.names[a], self.names[b]))
                ends = [self._slider(pair) for pair in self._with_image((a, b))]
                yield (not known, score, names), ends

    def _slider(self, pair: tuple[int, ...]) -> _Merged:
        by = " by convention" if self.evidence.ends_by_convention(*pair) else ""
        reason = f"opposed: two ends of one axis{by} ({self.evidence.words(*pair)})"
        return _Merged((self.evidence.signed(pair),), reason)

    def _share_a_slider(self, a: int, b: int) -> bool:
        """Whether two controls are the ends of one axis: by convention if their motions agree, or
        by motions alone."""
        evidence = self.evidence
        fits = (
            evidence.agrees(a, b)
            if evidence.ends_by_convention(a, b)
            else evidence.relation(a, b) != "" and self._opposed(a, b) and evidence.like((a,), (b,))
        )
        return fits and self.share_a_place((a, b))

    def _opposed(self, a: int, b: int) -> bool:
        return bool(self.similarity.cosine[a, b] <= self.settings.opposed_cosine)

    def alone(self, free: set[int]) -> list[_Merged]:
        """Elements of one control each, with the reason why it shares no slider with its opposite
        by convention."""
        return [_Merged(((i,),), self._why_alone(i)) for i in sorted(free)]

    def _why_alone(self, index: int) -> str:
        if not self.settings.opposed or self.category[index]:
            return ""
        refused = (
            i
            for i in sorted(self.sets)
            if i != index
            and self.evidence.ends_by_convention(index, i)
            and not self._share_a_slider(index, i)
        )
        return next(
            (
                f"apart from {self.names[i]}, its opposite by convention"
                f" ({self.evidence.words(index, i)})"
                for i in refused
            ),
            "",
        )

    def _joysticks(
        self, pairs: Iterable[tuple[_Merged, _Merged]], *, second_choice: bool = False
    ) -> Iterable[_Proposal]:
        """Pairs of axes as joysticks, those of the convention and the best first."""
        for first, second in pairs:
            known, score = self.evidence.crossing(first.motions, second.motions)
            motions = (*first.motions, *second.motions)
            shapes = known == "open" and not self.evidence.joints[motions[0]]
            # What has a handle on either side shares none in the middle.
            lobes = {self._has_two_lobes(i) for i in motions} if shapes else ()
            if known and len(lobes) < 2 and self.share_a_place(motions):
                names = sorted(self.names[i] for i in motions)
                rank = (second_choice, known == "open", -round(score, 9), names)
                yield rank, self._with_joined_image(self._joined(first.axes, second.axes))

    def _with_joined_image(self, joined: _Merged) -> list[_Merged]:
        """A joystick and its image, where that is another one."""
        if len(self._with_image(joined.motions)) == 1:
            return [joined]
        axes = [self._image(axis) for axis in joined.axes]
        signed = [self.evidence.signed(axis) if len(axis) == 2 else axis for axis in axes]
        return [joined, self._joined(*((axis,) for axis in signed))]

    def _joined(self, *axes: tuple[tuple[int, ...], ...]) -> _Merged:
        """One element of two axes, the one that runs more across the view first."""
        (first,), (second,) = sorted(axes, key=lambda axis: self.evidence.uprightness(axis[0][0]))
        return _Merged((first, second), self.evidence.words_of_joystick(first, second))

    # --- the paper's patches and fans ------------------------------------------------------------

    def patches(self, free: set[int]) -> list[_Merged]:
        """Groups of up to k controls by the Jaccard index of their candidates (paper section
        4.2)."""
        groups: dict[frozenset[int], Flags] = {}
        for i in sorted(free):
            groups[frozenset([i])] = flags = np.zeros(len(self.face.surface.points), dtype=bool)
            flags[self.sets[i].points] = True
        while alike := self._most_alike(groups):
            for a, b in alike:
                groups[a | b] = groups.pop(a) & groups.pop(b)
        return [
            _Merged(tuple((i,) for i in self._by_name(key)), "move the same region")
            for key in groups
            if len(key) > 1
        ]

    def _most_alike(
        self, groups: dict[frozenset[int], Flags]
    ) -> list[tuple[frozenset[int], frozenset[int]]]:
        """The two groups with the largest Jaccard index that suffices, and their images; empty if
        none."""
        if not (keys := list(groups)):
            return []
        table = np.array([groups[key] for key in keys], dtype=np.float32)
        both = table @ table.T
        size = np.diagonal(both)
        # Hidden controls have no candidates.
        jaccard = both / np.maximum(size[:, None] + size[None, :] - both, 1.0)
        ranked = []
        for i, j in np.argwhere(np.triu(jaccard > self.settings.jaccard_min, 1)):
            pair = keys[i], keys[j]
            members = self._by_name(keys[i] | keys[j])
            images = frozenset(self._image([*pair[0]])), frozenset(self._image([*pair[1]]))
            fits = len(members) <= self.settings.fan_size and self._go_together(members)
            if fits and groups.keys() >= {*images}:
                names = [self.names[k] for k in members]
                ranked.append((-round(float(jaccard[i, j]), 9), names, pair, images))
        if not ranked:
            return []
        _, _, pair, images = min(ranked, key=lambda row: row[:2])
        return [pair, images] if not {*chain(*images)} & {*chain(*pair)} else [pair]

    def _by_name(self, motions: Iterable[int]) -> tuple[int, ...]:
        return tuple(sorted(motions, key=lambda i: self.names[i]))

    # --- symmetry ---------------------------------------------------------------------------------

    def _image(self, motions: Sequence[int]) -> tuple[int, ...]:
        """The twins, in the same order; a control without twin is its own."""
        return tuple(self.twin[i] if self.twin[i] >= 0 else i for i in motions)

    def _with_image(self, motions: tuple[int, ...]) -> list[tuple[int, ...]]:
        """The motions, and their image where that is another set."""
        image = self._image(motions)
        return [motions] if set(image) == set(motions) else [motions, image]

    def share_a_place(self, motions: tuple[int, ...]) -> bool:
        """Whether these motions could be one element and keep enough of their displacement at one
        visible place."""
        return self._go_together(motions) and (
            bool(self.category[motions[0]]) or self.evidence.one_place(motions)
        )

    def _go_together(self, motions: tuple[int, ...]) -> bool:
        """Whether these motions are of one category, and their mirror image is the same set or has
        nothing in common with it."""
        image = set(self._image(motions))
        alone = {self.twin[i] < 0 for i in motions}
        whole = image == set(motions) or not image & set(motions)
        return len({self.category[i] for i in motions}) == 1 and whole and len(alone) == 1

    # --- groups -----------------------------------------------------------------------------------

    def folded(
        self, merged: list[_Merged], orbits: tuple[tuple[int, ...], ...]
    ) -> tuple[Group, ...]:
        """Groups of the merged motions: of two mirror images the left one, of an orbit the first
        one only."""
        by_members = {frozenset(element.motions): element for element in merged}
        groups = [self._orbit_group(orbit) for orbit in orbits if orbit[0] in self.sets]
        done = set(chain.from_iterable(orbits))
        for element in merged:
            if not done.isdisjoint(element.motions):
                continue
            image = by_members.get(frozenset(self._image(element.motions)))
            if image is None or image is element:
                image = None
            elif self._leftness(image) < self._leftness(element):
                element, image = image, element
            done |= _motions_of([element, *([image] if image else [])])
            groups.append(self._group(element, image))
        return tuple(sorted(groups, key=lambda group: group.name))

    def _leftness(self, element: _Merged) -> tuple[float, list[tuple[bool, str]]]:
        """Sorts elements from the character's left, where their candidates lie; names with a side
        decide in the middle."""
        points = np.concatenate([self.sets[i].points for i in sorted(element.motions)])
        names = sorted((not has_side(self.names[i]), self.names[i]) for i in element.motions)
        return -round(float(self.face.aside[points].mean()), 3), names

    def _group(self, merged: _Merged, image: _Merged | None) -> Group:
        motions, category = merged.motions, self.category[merged.motions[0]]
        mirrored = self._image(motions)
        # A double element is its own twin; it repeats its controls on the other side.
        doubled = (
            {*mirrored} == {*motions} and self.twin[motions[0]] >= 0 and self._is_double(merged)
        )
        mirror = tuple(self.controls[i] for i in mirrored) if image or doubled else ()
        place = {motion: i for i, motion in enumerate(motions)}
        names = [self.names[i] for i in motions]
        return Group(
            name=merged.name or element_name(names, self.face.rig.control_names),
            kind=merged.kind,
            controls=tuple(self.controls[i] for i in motions),
            opposed=tuple(
                (place[axis[0]], place[axis[1]]) for axis in merged.axes if len(axis) == 2
            ),
            mirror=mirror,
            reason=self._reason(merged),
            category=category,
            images=(mirror,) if mirror else (),
            image_names=(image.name if image else "",) if mirror else (),
            image_reason=self._reason(image) if image else "",
        )

    def _reason(self, merged: _Merged) -> str:
        """Why its controls are off the face, and why they share an element, where they do."""
        off_face = self.classification[merged.motions[0]].off_face_reason
        return "; ".join(text for text in (off_face, merged.reason) if text)

    def _is_double(self, merged: _Merged) -> bool:
        """Whether an element that is its own mirror image has a copy on either side instead of one
        in the middle."""
        if self.double_middle != "evidence" or any(self.category[i] for i in merged.motions):
            return self.double_middle == "always"
        return merged.doubled or all(self._has_two_lobes(i) for i in merged.motions)

    def _has_two_lobes(self, index: int) -> bool:
        face, motion = self.face, self.face.trajectories.motions[index]
        expected, meaning = face.expected[motion.control], face.meanings[motion.control]
        override = self.requests.overrides[motion.control]
        points = self.sets[index].points
        images = face.symmetry.partner[points]
        # A copy that no view sees would be a handle that nobody can grab.
        if not face.views.anywhere[images[images >= 0]].any():
            return False
        # One handle would be on one side of the face only.
        if np.abs(face.aside[points]).min() > ASIDE and not (override.anchor or override.near):
            return True
        # A name of the region alone does not place it in the middle.
        is_expected = meaning is not None and not meaning.action.vague
        both_sides = expected.both_sides if expected is not None and is_expected else None
        return two_lobed(motion, face.aside[motion.points], face.views.anywhere, both_sides)

    def _orbit_group(self, orbit: tuple[int, ...]) -> Group:
        single = self._group(_Merged((orbit[:1],), "one of an orbit"), None)
        images = tuple((self.controls[i],) for i in orbit[1:])
        return replace(single, images=images, image_names=("",) * len(images))
