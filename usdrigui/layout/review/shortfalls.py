"""What the configuration asks for and the layout does not give."""

from __future__ import annotations

from collections.abc import Iterator

from usdrigui.errors import Issue, issue
from usdrigui.layout.face import Face
from usdrigui.model import Element
from usdrigui.settings import ObjectiveSettings, Settings


def shortfalls(face: Face, elements: tuple[Element, ...], asked: Settings) -> tuple[Issue, ...]:
    """PLACE_KEEPS_LITTLE where a control is where it was asked to be and hardly moves there,
    HANDLES_NARROWER where handles that were asked to be wider than usual are not."""
    return (
        *_still_places(face, elements, asked),
        *_narrow_handles(face, asked.layout.objective),
    )


def _still_places(face: Face, elements: tuple[Element, ...], asked: Settings) -> Iterator[Issue]:
    peaks = {face.control_name(each.control): each.peak for each in face.trajectories.motions}
    least = asked.layout.candidates.least_kept
    for element in elements:
        for member in element.manipulator.members:
            override, peak = asked.rig.controls.get(member.control), peaks.get(member.control, 0.0)
            if (
                override is None
                or not (override.near or override.anchor)
                or element.anchor.on_board
            ):
                continue
            if member.arc_length < least * peak:
                key = f'controls."{member.control}".{"anchor" if override.anchor else "near"}'
                kept = f"keeps {member.arc_length / peak:.0%} of its peak displacement there"
                yield issue("PLACE_KEEPS_LITTLE", key, f"{member.control} {kept}")


def _narrow_handles(face: Face, asked: ObjectiveSettings) -> Iterator[Issue]:
    size = face.handle_width / max(face.trajectories.surface.face_size, 1e-300)
    if asked.handle_size > max(ObjectiveSettings().handle_size, 1.001 * size):
        limit = f"{asked.max_neighbours:g} controls within four handle widths on average"
        found = f"handles of {size:.3g} instead of {asked.handle_size:g}, for no more than {limit}"
        yield issue("HANDLES_NARROWER", "objective.handle_size", found)
