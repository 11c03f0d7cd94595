"""What the configuration asks for and the layout does not give."""

from __future__ import annotations

from collections.abc import Iterator

from usdrigui.errors import Issue, issue, listed
from usdrigui.layout.face import Face
from usdrigui.layout.measured import Measured
from usdrigui.model import Element
from usdrigui.settings import ObjectiveSettings


def shortfalls(known: Measured, elements: tuple[Element, ...]) -> tuple[Issue, ...]:
    """PLACE_KEEPS_LITTLE where a control is where it was asked to be and hardly moves there,
    GROUP_APART where no place on the character is one of all controls of a group,
    HANDLES_NARROWER where handles that were asked to be wider than usual are not."""
    return (
        *_still_places(known, elements),
        *_groups_apart(known, elements),
        *_narrow_handles(known.face, known.settings.objective),
    )


def _still_places(known: Measured, elements: tuple[Element, ...]) -> Iterator[Issue]:
    face, least = known.face, known.settings.candidates.least_kept
    asked = dict(zip(face.rig.control_names, known.requests.configured, strict=True))
    peaks = {face.control_name(each.control): each.peak for each in face.trajectories.motions}
    for element in elements:
        for member in element.members if not element.anchor.on_board else ():
            override, peak = asked[member.control], peaks[member.control]
            if (override.near or override.anchor) and member.arc_length < least * peak:
                key = f'controls."{member.control}".{"anchor" if override.anchor else "near"}'
                kept = f"keeps {member.arc_length / peak:.0%} of its peak displacement there"
                yield issue("PLACE_KEEPS_LITTLE", key, f"{member.control} {kept}")


def _groups_apart(known: Measured, elements: tuple[Element, ...]) -> Iterator[Issue]:
    for name, members in known.requests.groups.items():
        for element in elements:
            if element.category == "crowded" and element.controls <= {*members}:
                what = f"{listed(members)} are on the board: {element.reason}"
                yield issue("GROUP_APART", f'groups.groups."{name}"', what)


def _narrow_handles(face: Face, asked: ObjectiveSettings) -> Iterator[Issue]:
    size = face.handle_width / face.surface.face_size
    if asked.handle_size > max(ObjectiveSettings().handle_size, 1.001 * size):
        limit = f"{asked.max_neighbours:g} controls within four handle widths on average"
        found = f"handles of {size:.3g} instead of {asked.handle_size:g}, for no more than {limit}"
        yield issue("HANDLES_NARROWER", "objective.handle_size", found)
