"""Which controls share one element (paper sections 3.2 and 4.2, multi-parameter grouping).

Groups come from the user, from opposed controls (the two ends of one axis become one bipolar
slider), from axes that share a region (two of them become a joystick), and, where asked for, from
the Jaccard index of the controls' candidates as in the paper.  Whatever is merged on one side of
the character is merged on the other.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, combinations

import numpy as np

from usdrigui.character import Flags, Indices
from usdrigui.conventions.sides import has_side
from usdrigui.errors import Faults, meant, refuse
from usdrigui.layout.control_overrides import control_index
from usdrigui.layout.group.evidence import SAME_REGION, Evidence, Relation, alike
from usdrigui.layout.group.own_places import has_own_place
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.similarity import bidirectional
from usdrigui.layout.names import element_name
from usdrigui.layout.symmetry.lobes import all_aside, two_lobed
from usdrigui.layout.symmetry.mirror_plane import plane_distance
from usdrigui.layout.symmetry.orbits import configured_orbits
from usdrigui.layout.visibility import screen
from usdrigui.model import Candidates, CandidateSet, ElementKind, Group
from usdrigui.ties import first_largest

_TWIN_LEEWAY = 0.8
"""Twins of each other are called opposed at this share of the usual cosine: mouthLeft and
mouthRight."""
_AXES_SHARED = 0.8
"""Least overlap of the regions of two axes that make a joystick."""
_SINGLE_SHARED = 0.9
"""The same for an axis and a single control."""
_ACROSS = 0.4
"""Largest cosine of the directions of two axes of a joystick."""
_ACROSS_BY_CONVENTION = 0.7
"""The same where the conventions make a joystick of them."""
_ALIKE = 0.1
"""Least amount of one axis of a joystick in shares of the other's: no drag could aim at a far
lesser one."""


@dataclass(frozen=True)
class _Merged:
    """Motions that share an element, in its order; `axes` are tuples of positions, two for opposed
    ends."""

    motions: tuple[int, ...]
    axes: tuple[tuple[int, ...], ...]
    reason: str
    name: str = ""
    doubled: bool = False
    """Whether the layout given has it on either side of the middle."""


def find_groups(known: Measured, candidates: Candidates) -> tuple[Group, ...]:
    """One group per element, by name; every control that has candidates is in exactly one.

    Of two elements that mirror each other only the one on the character's left becomes a group, and
    the other is its image.  Raises CONFIG_UNKNOWN_CONTROL and CONFIG_VALUE for groups of the
    configuration.
    """
    grouping, face = _Grouping(known, candidates), known.face
    merged = grouping.of_the_user()
    names = control_index(face.rig, known.settings.rig.controls)
    orbits = configured_orbits(
        face.rig.controls, face.trajectories, known.requests.overrides, names
    )
    turning = set().union(*orbits)
    merged += [_Merged((i,), ((0,),), "") for i in sorted(turning)]
    merged += grouping.of_the_prior_layout(_free(merged, grouping))
    merged += grouping.joysticks(grouping.axes(_free(merged, grouping)), _free(merged, grouping))
    if grouping.settings.patches:
        merged += grouping.patches(_free(merged, grouping))
    merged += [
        _Merged((i,), ((0,),), grouping.why_alone(i)) for i in sorted(_free(merged, grouping))
    ]
    return grouping.folded(merged, orbits)


def check_groups(groups: Mapping[str, Sequence[str]], known: Collection[str]) -> None:
    """Raise CONFIG_UNKNOWN_CONTROL for all members of groups that are not `known`, CONFIG_VALUE for
    those of two groups."""
    faults, taken = Faults(), set[str]()
    for name, members in groups.items():
        where = f'groups.groups."{name}"'
        for member in members:
            with faults.collected():
                if member not in known:
                    what = f"no control is called {member!r}{meant(member, known)}"
                    raise refuse("CONFIG_UNKNOWN_CONTROL", where, what)
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
    index = {motion.control: i for i, motion in enumerate(known.face.trajectories.motions)}
    free = {index[control] for group in single for control in (*group.controls, *group.mirror)}
    return tuple(
        tuple(grouping.names[i] for i in found.motions) for found in grouping.patches(free)
    )


def share_a_place(known: Measured, candidates: Candidates, names: Sequence[str]) -> bool:
    """Whether controls could be one element: all are controls of the face, and some point suits
    them all."""
    grouping = _Grouping(known, candidates)
    motions = [i for i in grouping.sets if grouping.names[i] in names]
    on_face = not any(grouping.category[i] for i in motions)
    return len(motions) == len(names) and on_face and grouping.may_share(tuple(motions))


def _free(merged: Iterable[_Merged], grouping: _Grouping) -> set[int]:
    return set(grouping.sets) - _motions_of(merged)


def _motions_of(merged: Iterable[_Merged]) -> set[int]:
    return set().union(*(each.motions for each in merged))


class _Grouping:
    """What the ways to group have in common: candidates by motion, twins by motion, comparisons."""

    def __init__(self, known: Measured, candidates: Candidates) -> None:
        face, requests = known.face, known.requests
        motions, mirror = face.trajectories.motions, known.settings.character.symmetry
        index = {motion.control: i for i, motion in enumerate(motions)}
        self.face, self.similarity, self.requests = face, known.similarity, requests
        self.settings = known.settings.layout.groups
        self.double_middle = mirror.double_middle
        self.evidence = Evidence(face, known.similarity)
        self.two_sided = frozenset(bidirectional(motions))
        self.sets: dict[int, CandidateSet] = {each.motion: each for each in candidates.sets}
        self.names = [face.control_name(motion.control) for motion in motions]
        twins = face.symmetry.twins
        # What the only view does not see holds no element, be it the image of one that is seen.
        fold = mirror.fold and not face.views.one_sided(face.symmetry.plane.normal)
        found = {
            i: index.get(int(twins[motions[i].control]), -1) if fold else -1 for i in self.sets
        }
        # A control with a place of its own is not folded, and neither is its twin.
        alone = {
            i
            for i, twin in found.items()
            if twin != i and has_own_place(face, requests, motions[i].control)
        }
        self.twin = {
            i: -1 if i in alone or twin in alone or twin not in self.sets else twin
            for i, twin in found.items()
        }
        self.category = {i: each.category for i, each in self.sets.items()}

    # --- the user's -----------------------------------------------------------------------------

    def of_the_user(self) -> list[_Merged]:
        """The groups that the configuration names, in its order."""
        index = {name: i for i, name in enumerate(self.names)}
        check_groups(self.requests.groups, self.face.rig.control_names)
        found: list[_Merged] = []
        for name, members in self.requests.groups.items():
            motions = tuple(index[member] for member in members if index.get(member) in self.sets)
            if len(motions) < 2:
                what = "a group needs two controls that move something"
                raise refuse("CONFIG_VALUE", f'groups.groups."{name}"', what)
            found.append(
                _Merged(motions, self._axes_within(motions), "grouped by the configuration", name)
            )
        return found

    def _axes_within(self, motions: Sequence[int]) -> tuple[tuple[int, ...], ...]:
        """Positions of `motions` as axes: opposed members side by side in the order make one."""
        axes: list[tuple[int, ...]] = []
        for position, motion in enumerate(motions):
            before = axes[-1] if axes else ()
            if len(before) == 1 and self._opposed(motions[before[0]], motion):
                axes[-1] = (before[0], position)
            else:
                axes.append((position,))
        return tuple(axes)

    def of_the_prior_layout(self, free: set[int]) -> list[_Merged]:
        """The groups of an earlier layout whose members still belong in one place, single controls
        included."""
        index = {self.face.trajectories.motions[i].control: i for i in free}
        found: list[_Merged] = []
        for group in self.requests.prior.groups:
            motions = tuple(index[control] for control in group.controls if control in index)
            whole = len(motions) == len(group.controls)
            if not motions or len({bool(self.category[i]) for i in motions}) > 1:
                continue
            pairs = group.opposed if whole else ()
            ends = set().union(*pairs)
            axes = sorted((*pairs, *((i,) for i in range(len(motions)) if i not in ends)), key=min)
            reason = "as in the layout given" if len(motions) > 1 else ""
            name = group.name if whole else ""
            found.append(_Merged(motions, tuple(axes), reason, name, group.doubled))
        return found

    # --- opposed controls -------------------------------------------------------------------------

    def axes(self, free: set[int]) -> list[_Merged]:
        """Pairs of opposed controls, those of the convention and the clearest first, each control
        in one."""
        if not self.settings.opposed:
            return []
        table, ranked = self.similarity, []
        for a, b in combinations(sorted(free - self.two_sided), 2):
            if self._share_a_slider(a, b):
                ratio = min(table.norm[a], table.norm[b]) / max(table.norm[a], table.norm[b])
                # Of several opposites the one of like amount is meant: look down and up, not down
                # and wide.
                score = float(table.cosine[a, b] * ratio**0.25)
                known = self.evidence.ends_by_convention(a, b)
                ranked.append(
                    (not known, round(score, 9), sorted((self.names[a], self.names[b])), a, b)
                )
        found: list[_Merged] = []
        taken: set[int] = set()
        for *_, a, b in sorted(ranked):
            pairs = self._with_image((a, b))
            if taken & set().union(*pairs):
                continue
            for pair in pairs:
                taken |= set(pair)
                by = " by convention" if self.evidence.ends_by_convention(a, b) else ""
                reason = f"opposed: two ends of one axis{by} ({self.evidence.words(*pair)})"
                found.append(_Merged(self._signed(pair), ((0, 1),), reason))
        return found

    def _share_a_slider(self, a: int, b: int) -> bool:
        """Whether two controls are the ends of one axis: by convention if their motions agree, or
        by motions alone."""
        evidence = self.evidence
        if evidence.ends_by_convention(a, b):
            fits = evidence.agrees(a, b, twins=self.twin.get(a, -1) == b)
        else:
            fits = (
                evidence.relation(a, b) != "" and self._opposed(a, b) and evidence.like_amount(a, b)
            )
        return fits and self._share_a_place((a, b))

    def why_alone(self, index: int) -> str:
        """Why a control shares no slider with its opposite by convention; empty for one that has
        none."""
        if not self.settings.opposed or self.category[index]:
            return ""
        ends = [
            i
            for i in sorted(self.sets)
            if i != index and self.evidence.ends_by_convention(index, i)
        ]
        refused = [i for i in ends if not self._share_a_slider(index, i)]
        if not refused:
            return ""
        words = self.evidence.words(index, refused[0])
        return f"apart from {self.names[refused[0]]}, its opposite by convention ({words})"

    def _opposed(self, a: int, b: int) -> bool:
        least = self.settings.opposed_cosine
        if self.twin.get(a, -1) == b:
            least *= _TWIN_LEEWAY
        return bool(self.similarity.cosine[a, b] <= least)

    def _signed(self, pair: tuple[int, ...]) -> tuple[int, ...]:
        """The pair with the end first that goes to the left or down as seen by the viewer."""
        fields = self.similarity.fields
        frame = screen(self.face.views)
        mean = np.einsum(
            "mi,m->i", fields.vectors[pair[1]] - fields.vectors[pair[0]], fields.weights
        )
        flat = frame @ mean
        along = flat[first_largest(np.abs(flat))]
        return pair if along >= 0.0 else pair[::-1]

    # --- joysticks --------------------------------------------------------------------------------

    def joysticks(self, axes: list[_Merged], free: set[int]) -> list[_Merged]:
        """The axes, joined two by two where they share a region and cross; or joined with a single
        control."""
        if not self.settings.opposed:
            return []
        left = list(axes)
        singles = free - _motions_of(axes)
        swinging = [_Merged((i,), ((0,),), "") for i in sorted(singles & self.two_sided)]
        lone = [_Merged((i,), ((0,),), "") for i in sorted(singles - self.two_sided)]
        made: list[_Merged] = []
        for partners, least in (([*left, *swinging], _AXES_SHARED), (lone, _SINGLE_SHARED)):
            for first, second in self._crossings(
                left if partners is lone else [*left, *swinging], partners, least
            ):
                used = _motions_of(made)
                images = self._joined_images(first, second)
                if images and not used & _motions_of(images):
                    made += images
        used = _motions_of(made)
        return [*made, *(axis for axis in left if not used & set(axis.motions))]

    def _crossings(
        self, firsts: list[_Merged], seconds: list[_Merged], least: float
    ) -> list[tuple[_Merged, _Merged]]:
        """Pairs of axes that may make a joystick, those of the convention and the best first."""
        ranked = []
        for first in firsts:
            for second in seconds:
                if (first.motions >= second.motions and second in firsts) or set(
                    first.motions
                ) & set(second.motions):
                    continue
                known = self._cross(first, second, least)
                if known and self._share_a_place((*first.motions, *second.motions)):
                    shared, across = self._crossing(first, second)
                    score = -round(shared * (1.0 - across) * self._flatness(second), 9)
                    names = sorted(self.names[i] for i in (*first.motions, *second.motions))
                    ranked.append((known == "open", score, names, first, second))
        return [(first, second) for *_, first, second in sorted(ranked, key=lambda each: each[:3])]

    def _cross(self, first: _Merged, second: _Merged, least: float) -> Relation:
        """What makes a joystick of two axes: the convention if their motions agree, or these alone;
        empty if not."""
        known = self.evidence.crossing(first.motions, second.motions)
        most = _ACROSS
        if known == "convention":
            least, most = SAME_REGION, _ACROSS_BY_CONVENTION
        shared, across = self._crossing(first, second)
        return known if shared >= least and across <= most and self._alike(first, second) else ""

    def _crossing(self, first: _Merged, second: _Merged) -> tuple[float, float]:
        """Least overlap of the regions of two axes, and largest cosine of their directions."""
        table = self.similarity
        pick = np.ix_(first.motions, second.motions)
        return float(table.shared[pick].min()), float(np.abs(table.direction[pick]).max())

    def _alike(self, first: _Merged, second: _Merged) -> bool:
        """Whether two axes are of like amount: no drag could aim at a far lesser one."""
        amounts = [
            max(float(self.similarity.norm[i]) for i in axis.motions) for axis in (first, second)
        ]
        return min(amounts) >= _ALIKE * max(amounts)

    def _flatness(self, axis: _Merged) -> float:
        """How far an axis runs along the surface rather than out of it: what a drag on a screen can
        follow."""
        fields = self.similarity.fields
        normals = self.face.trajectories.surface.normals[fields.places]
        vectors = fields.vectors[axis.motions[0]]
        out = float((np.einsum("mi,mi->m", vectors, normals) ** 2 * fields.weights).sum())
        return 1.0 - out / max(
            float((np.einsum("mi,mi->m", vectors, vectors) * fields.weights).sum()), 1e-300
        )

    def _joined_images(self, first: _Merged, second: _Merged) -> list[_Merged]:
        """The joystick of two axes and of their images; empty where the images do not make one."""
        joined = self._joined(first, second)
        images = self._with_image(joined.motions)
        if len(images) == 1:
            return [joined]
        other = tuple(tuple(images[1][i] for i in axis) for axis in joined.axes)
        one, two = (
            _Merged(self._signed(o) if len(o) == 2 else o, (tuple(range(len(o))),), "")
            for o in other
        )
        return [joined, self._joined(one, two)]

    def _joined(self, first: _Merged, second: _Merged) -> _Merged:
        """One element of two axes, the one that runs more across the view first."""
        if self._uprightness(first) > self._uprightness(second):
            first, second = second, first
        shift = len(first.motions)
        axes = (*first.axes, *(tuple(i + shift for i in axis) for axis in second.axes))
        motions = (*first.motions, *second.motions)
        shared, across = self._crossing(first, second)
        by = (
            " by convention"
            if self.evidence.crossing(first.motions, second.motions) == "convention"
            else ""
        )
        words = f"two axes of one region: a joystick{by} ({alike(across, shared)})"
        return _Merged(motions, axes, words)

    def _uprightness(self, axis: _Merged) -> float:
        fields = self.similarity.fields
        flat = np.abs(fields.vectors[axis.motions[0]] @ screen(self.face.views).T)
        across, upright = fields.weights @ flat
        return float(upright / max(float(across + upright), 1e-300))

    # --- the paper's patches and fans ------------------------------------------------------------

    def patches(self, free: set[int]) -> list[_Merged]:
        """Groups of up to k controls by the Jaccard index of their candidates (paper section
        4.2)."""
        settings = self.settings
        groups: dict[tuple[int, ...], Flags] = {
            (i,): self._flags(self.sets[i].points) for i in sorted(free)
        }
        while best := self._most_alike(groups, settings.fan_size, settings.jaccard_min):
            for a, b in best:
                groups[tuple(sorted(a + b, key=lambda i: self.names[i]))] = groups.pop(
                    a
                ) & groups.pop(b)
        return [
            _Merged(key, tuple((i,) for i in range(len(key))), "move the same region")
            for key in groups
            if len(key) > 1
        ]

    def _most_alike(
        self, groups: dict[tuple[int, ...], Flags], most: int, least: float
    ) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
        """The two groups with the largest Jaccard index above `least`, and their images; empty if
        none."""
        ranked = []
        keys = list(groups)
        if not keys:
            return []
        table = np.array([groups[key] for key in keys], dtype=np.float32).reshape(len(keys), -1)
        both = table @ table.T
        size = np.diagonal(both)
        jaccard = both / np.maximum(size[:, None] + size[None, :] - both, 1.0)
        for i, j in np.argwhere(np.triu(jaccard > least, 1)):
            a, b = keys[i], keys[j]
            if len(a) + len(b) <= most and self.may_share(a + b):
                images = [(tuple(self._image(a)), tuple(self._image(b))), (a, b)]
                known = {tuple(sorted(key)) for key in keys}
                if all(tuple(sorted(key)) in known for key in images[0]):
                    ranked.append(
                        (
                            -round(float(jaccard[i, j]), 9),
                            sorted(self.names[k] for k in a + b),
                            a,
                            b,
                        )
                    )
        if not ranked:
            return []
        _, _, a, b = min(ranked)
        found = [(a, b)]
        image = tuple(
            next(key for key in keys if set(key) == set(self._image(each))) for each in (a, b)
        )
        if not set(image[0] + image[1]) & set(a + b):
            found.append((image[0], image[1]))
        return found

    def _flags(self, points: Indices) -> Flags:
        flags = np.zeros(len(self.face.trajectories.surface.points), dtype=bool)
        flags[points] = True
        return flags

    # --- symmetry ---------------------------------------------------------------------------------

    def _image(self, motions: Sequence[int]) -> tuple[int, ...]:
        """The twins, in the same order; a control without twin is its own."""
        return tuple(self.twin[i] if self.twin[i] >= 0 else i for i in motions)

    def _with_image(self, motions: tuple[int, ...]) -> list[tuple[int, ...]]:
        """The motions, and their image where that is another set."""
        image = self._image(motions)
        return [motions] if set(image) == set(motions) else [motions, image]

    def may_share(self, motions: tuple[int, ...]) -> bool:
        """Whether these motions could be one element and have a common candidate."""
        common = self.sets[motions[0]].points
        for i in motions[1:]:
            common = np.intersect1d(common, self.sets[i].points, assume_unique=True)
        return self._go_together(motions) and (bool(self.category[motions[0]]) or len(common) > 0)

    def _share_a_place(self, motions: tuple[int, ...]) -> bool:
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

    def folded(
        self, merged: list[_Merged], orbits: tuple[tuple[int, ...], ...]
    ) -> tuple[Group, ...]:
        """Groups of the merged motions: of two mirror images the left one, of an orbit the first
        one only."""
        by_members = {frozenset(each.motions): each for each in merged}
        groups = [self._orbit_group(orbit) for orbit in orbits if orbit[0] in self.sets]
        done = {frozenset([i]) for i in chain.from_iterable(orbits)}
        for each in merged:
            members = frozenset(each.motions)
            image = frozenset(self._image(each.motions))
            if members in done:
                continue
            paired = image != members and image in by_members and not image & members
            if paired and self._leftness(image) > self._leftness(members):
                each, image = by_members[image], members
            done |= {frozenset(each.motions), image} if paired else {members}
            groups.append(self._group(each, by_members[image] if paired else None))
        return tuple(sorted(groups, key=lambda group: group.name))

    def _leftness(self, motions: frozenset[int]) -> tuple[float, list[str]]:
        """How far on the character's left the candidates lie; names with a side decide in the
        middle."""
        points = np.concatenate([self.sets[i].points for i in sorted(motions)])
        apart = plane_distance(
            self.face.trajectories.surface.points[points], self.face.symmetry.plane
        )
        names = sorted(
            (self.names[i] for i in motions), key=lambda name: (not has_side(name), name)
        )
        inverse = ["".join(chr(0x10FFFF - ord(letter)) for letter in name) for name in names]
        return round(float(apart.mean() / self.face.trajectories.surface.face_size), 3), inverse

    def _group(self, merged: _Merged, image: _Merged | None) -> Group:
        motions = self.face.trajectories.motions
        controls = tuple(motions[i].control for i in merged.motions)
        own_image = (
            set(self._image(merged.motions)) == set(merged.motions)
            and self.twin[merged.motions[0]] >= 0
        )
        # A double element is its own twin; it repeats its controls on the other side.
        paired = image is not None or (own_image and self._is_double(merged))
        mirror = tuple(motions[i].control for i in self._image(merged.motions)) if paired else ()
        return Group(
            name=merged.name
            or element_name([self.names[i] for i in merged.motions], self.face.rig.control_names),
            kind=_kind(merged),
            controls=controls,
            opposed=tuple((axis[0], axis[1]) for axis in merged.axes if len(axis) == 2),
            mirror=mirror,
            reason=self._reason(merged),
            category=self.category[merged.motions[0]],
            images=(mirror,) if mirror else (),
            image_names=(image.name if image is not None else "",) if mirror else (),
            image_reason=self._reason(image) if image is not None else "",
        )

    def _reason(self, merged: _Merged) -> str:
        """Why its controls are off the face, and why they share an element, where they do."""
        off_face = self.sets[merged.motions[0]].off_face_reason
        return "; ".join(each for each in (off_face, merged.reason) if each)

    def _is_double(self, merged: _Merged) -> bool:
        """Whether an element that is its own mirror image has a copy on either side instead of one
        in the middle."""
        if self.double_middle != "evidence" or any(self.category[i] for i in merged.motions):
            return self.double_middle == "always"
        return merged.doubled or all(self._has_two_lobes(i) for i in merged.motions)

    def _has_two_lobes(self, index: int) -> bool:
        face, motion = self.face, self.face.trajectories.motions[index]
        expected = face.expected[motion.control]
        meaning = face.meanings[motion.control]
        override = self.requests.overrides[motion.control]
        placed = bool(override.anchor or override.near) or motion.shares.owned is not None
        if not placed and all_aside(
            face.trajectories.surface, face.symmetry.plane, self.sets[index].points
        ):
            return True
        # A name of the region alone does not place it in the middle.
        is_expected = expected is not None and meaning is not None and not meaning.action.vague
        both_sides = expected.both_sides if expected is not None and is_expected else None
        return two_lobed(
            face.trajectories.surface, face.symmetry.plane, face.views.anywhere, motion, both_sides
        )

    def _orbit_group(self, orbit: tuple[int, ...]) -> Group:
        motions = self.face.trajectories.motions
        single = self._group(_Merged(orbit[:1], ((0,),), "one of an orbit"), None)
        images = tuple((motions[i].control,) for i in orbit[1:])
        return replace(single, images=images, image_names=("",) * len(images))


def _kind(merged: _Merged) -> ElementKind:
    if len(merged.axes) == 1:
        return "slider"
    return "patch" if len(merged.axes) == 2 else "fan"
