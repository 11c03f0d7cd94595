"""Layouts that exist and that a run uses as references: fixed ones, the previous one, another
character's, the base.

Reads their layers and finds out of which characters they are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from usdrigui.character import Performance, Rig
from usdrigui.errors import Faults, issue, meant, of_character, refuse
from usdrigui.isolation.foreign_file import SourceFile
from usdrigui.layout.motion.trajectory import trajectories as find_trajectories
from usdrigui.layout.reuse.existing_layout import layout_of
from usdrigui.layout.reuse.identity import Matching, match_layout
from usdrigui.layout.reuse.pinned import Pins
from usdrigui.model import Layout, Trajectories
from usdrigui.pipeline.animation import performances
from usdrigui.reader.reader_process import read_composed_isolated, read_layouts_isolated
from usdrigui.reader.reader_records import LayoutsResult, Limits, Opening
from usdrigui.settings import Settings, TrajectorySettings


@dataclass(frozen=True, slots=True)
class ReferenceLayers:
    """Paths of the layers to use."""

    fixed: Path | None = None
    """Its anchors and groups are kept to the point."""
    previous: Path | None = None
    """Its anchors and groups are kept unless leaving them saves more than
    ``objective.keep_penalty``."""
    like: Path | None = None
    """The layout of another character, over that character, to be imitated; not together with
    `previous`."""
    animations: tuple[Path, ...] = ()
    """Controls that these use often matter more."""
    base: Path | None = None
    """The asset's own layout, which stays: only controls that it lacks are laid out; not together
    with the others."""


@dataclass(frozen=True, eq=False)
class ReferenceLayouts:
    """What those layers hold, by SkelRoot."""

    fixed: Mapping[str, Layout] = field(default_factory=dict)
    previous: Mapping[str, Layout] = field(default_factory=dict)
    like: tuple[tuple[Rig, Layout], ...] = ()
    """Other characters with their layouts."""
    clips: tuple[Performance, ...] = ()
    """Animations that weigh the controls."""
    base: LayoutsResult | None = None
    """Existing layouts, with the paths of their own layer."""
    sources: tuple[SourceFile, ...] = ()
    """Every file that composed those layers and characters."""

    def existing(self, rig: Rig) -> Layout | None:
        """The existing layout of this character, with its paths; none where there is none."""
        return layout_of(self.base.layouts, rig) if self.base is not None else None


def read_references(layers: ReferenceLayers, opening: Opening) -> ReferenceLayouts:
    """Read the layers, each in a process of its own.

    Raises LAYOUT_MISSING, SOURCE_MISSING for a `like` that does not name its character, and
    everything that reading a layer or an asset can raise.
    """
    if layers.previous and layers.like:
        raise refuse(
            "CONFIG_VALUE",
            "--like",
            "a layout is either this character's previous one or another's",
        )
    if layers.base and (layers.fixed or layers.previous or layers.like):
        raise refuse(
            "CONFIG_VALUE",
            "--base",
            "keeps the whole layout, and cannot be combined with another layout",
        )
    clips = performances(layers.animations, opening)
    base = read_layouts_isolated(layers.base, opening) if layers.base else None
    fixed = read_layouts_isolated(layers.fixed, opening) if layers.fixed else None
    previous = read_layouts_isolated(layers.previous, opening) if layers.previous else None
    like, theirs = _characters(layers.like, opening.limits) if layers.like else ((), ())
    sources = (
        *theirs,
        *(source for each in (base, fixed, previous) if each for source in each.sources),
    )
    return ReferenceLayouts(_by_root(fixed), _by_root(previous), like, clips, base, sources)


def as_sibling(references: ReferenceLayouts, rig: Rig, first: Layout) -> ReferenceLayouts:
    """The references with the layout of another variant of the same character as its earlier one:
    what both have stands at the same places.  As they are where a layout is given for it already,
    or the two have no control in common.
    """
    root = rig.skel_root.path
    given = bool(references.like) or root in references.fixed or root in references.previous
    if given or not _shares_controls(first.controls, rig):
        return references
    return replace(references, previous={**references.previous, root: first})


def followed(
    references: ReferenceLayouts, rigs: tuple[Rig, ...]
) -> tuple[ReferenceLayouts, tuple[Rig, ...]]:
    """The references with the earlier layout of the one character where that has another path
    now.

    Only where there is one character on either side, with a mesh of the same name below its
    SkelRoot and a control in common; its rig then has PREVIOUS_RENAMED.
    """
    if (
        len(rigs) != 1
        or len(references.previous) != 1
        or rigs[0].skel_root.path in references.previous
    ):
        return references, rigs
    (rig,), (before,) = rigs, references.previous.values()
    layout = layout_of((before,), rig)
    if layout is None:
        return references, rigs
    was = f"was {before.character.root} in the previous layout"
    renamed = issue("PREVIOUS_RENAMED", rig.skel_root.path, was)
    told = (*rig.findings.issues, *of_character(rig.skel_root.path_in_variants, (renamed,)))
    return replace(references, previous={rig.skel_root.path: layout}), (
        replace(rig, findings=replace(rig.findings, issues=told)),
    )


def rigs_over(
    references: ReferenceLayouts, rigs: tuple[Rig, ...], sampling: TrajectorySettings
) -> tuple[Rig, ...]:
    """The characters to lay out: all, or those with an existing layout.

    Raises BASE_MISMATCH or PREVIOUS_MISMATCH where no layout of `base` or `previous` is of any of
    them.
    """
    if references.previous and not any(
        _can_be_of(references.previous.get(rig.skel_root.path), rig, sampling) for rig in rigs
    ):
        raise refuse(
            "PREVIOUS_MISMATCH", rigs[0].skel_root.path, _mismatch(references.previous, rigs[0])
        )
    if references.base is None:
        return rigs
    found = tuple(rig for rig in rigs if references.existing(rig) is not None)
    if not found:
        theirs = ", ".join(layout.character.root for layout in references.base.layouts)
        raise refuse(
            "BASE_MISMATCH",
            rigs[0].skel_root.path,
            f"shares mesh and controls with none of the layouts, or with several: {theirs}",
        )
    return found


def _mismatch(previous: Mapping[str, Layout], rig: Rig) -> str:
    """Why none of the earlier layouts can be this character's: it has another path, or other
    controls."""
    alike = [root for root, layout in previous.items() if _shares_controls(layout.controls, rig)]
    if alike:
        return (
            "has another path than the character of the layer with its controls,"
            f" {', '.join(alike)}"
        )
    return f"shares no control with a layout of the layer, of {', '.join(previous)}"


def _can_be_of(layout: Layout | None, rig: Rig, sampling: TrajectorySettings) -> bool:
    """Whether a layout can be an earlier one of this character, all of whose controls may have
    other names now."""
    if layout is None or _shares_controls(layout.controls, rig):
        return layout is not None
    return bool(match_layout(layout, rig, find_trajectories(rig, sampling)).names)


def _shares_controls(controls: frozenset[str], rig: Rig) -> bool:
    return not rig.control_names.isdisjoint(controls)


@dataclass(frozen=True, eq=False)
class OwnReferences:
    """What the references hold for one character, by its own names for its controls."""

    fixed: Layout | None = None
    previous: Layout | None = None
    like: tuple[Rig, Trajectories, Layout] | None = None
    """Another character and its layout, by the names that it has there."""
    existing: Layout | None = None
    clips: tuple[Performance, ...] = ()
    pins: Pins = field(default_factory=Pins)
    """What a person has decided in the layouts that the new one succeeds."""
    matchings: Mapping[str, Matching] = field(default_factory=dict)
    """By ``fixed``, ``previous`` and ``like``: whose control there is which one here."""

    @property
    def followed(self) -> bool:
        """Whether the layout follows another one of the same controls."""
        return any(each is not None for each in (self.fixed, self.previous, self.like))


def check_like(like: tuple[tuple[Rig, Layout], ...], rig: Rig, names: Mapping[str, str]) -> None:
    """Raise CONFIG_UNKNOWN_CONTROL for all names of `names` (``[like.names]``) that nobody bears,
    CONFIG_VALUE when none of several characters to imitate has the path of this one."""
    if not like:
        return
    other, _ = imitated(like, rig.skel_root.path)
    faults = Faults()
    for theirs, ours in names.items():
        for whose, name in ((other, theirs), (rig, ours)):
            with faults.collected():
                if name and name not in whose.control_names:
                    root, near = whose.skel_root.path, meant(name, whose.control_names)
                    what = f"{root} has no control {name!r}{near}"
                    raise refuse("CONFIG_UNKNOWN_CONTROL", f'like.names."{theirs}"', what)
    faults.raise_all()


def imitated(like: Sequence[tuple[Rig, Layout]], root: str) -> tuple[Rig, Layout]:
    """The character to imitate: of several the one with the path of this one."""
    by_root = {other.skel_root.path: (other, layout) for other, layout in like}
    if root not in by_root and len(by_root) > 1:
        raise refuse(
            "CONFIG_VALUE", "--like", f"has layouts of {', '.join(by_root)}; none is of {root}"
        )
    return by_root.get(root) or like[0]


def _characters(
    layer: Path, limits: Limits
) -> tuple[tuple[tuple[Rig, Layout], ...], tuple[SourceFile, ...]]:
    """The characters of a layer to imitate, read without the configuration of ours, and
    their files."""
    found, read = read_composed_isolated(layer, Settings(), limits)
    layouts = _by_root(found)
    characters = tuple(
        (rig, layouts[rig.skel_root.path]) for rig in read.rigs if rig.skel_root.path in layouts
    )
    return characters, read.sources


def _by_root(found: LayoutsResult | None) -> Mapping[str, Layout]:
    return {layout.character.root: layout for layout in found.layouts} if found else {}
