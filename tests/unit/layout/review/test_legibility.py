"""What can be read and grabbed at a glance: each way of being in another's way, by hand."""

from __future__ import annotations

import chain
import limbs
import numpy as np
import pytest

from usdrigui.layout.review.legibility import SCREEN_HEIGHT, legibility, legibility_of
from usdrigui.model import Anchor, Element, Member

SCREEN = np.eye(3)[:2]
FRAME = (("low", (0, 0), (0, 20)), ("high", (0, SCREEN_HEIGHT - 20), (0, SCREEN_HEIGHT)))
"""Two elements that stretch what is drawn to the height of the screen: lengths below are pixels."""


def element(name: str, *track: tuple[float, float], inner: tuple[str, ...] = (), on_board: bool = False) -> Element:
    points = np.array([(*point, 0.0) for point in track])
    member = Member(name, np.linspace(0.0, 1.0, len(points)), points, 1.0, 1.0)
    anchor = Anchor("/Face", 0, 1, "", points[0], np.array([0.0, 0.0, 1.0]), on_board)
    return Element(name, "slider", (member,), anchor, name, "none", inner=inner)


def unclear(*elements: Element) -> dict[str, str]:
    found = legibility((*(element(*each) for each in FRAME), *elements), SCREEN)
    assert found.clear == found.elements - len(found.unclear)
    return dict(found.unclear)


@pytest.mark.parametrize(
    ("one", "other", "reason", "both"),
    [
        (((100, 300), (100, 340)), ((113, 300), (130, 270)), "its handle is 13 px from that of other", True),
        (((100, 300), (100, 340)), ((104, 330), (140, 330)), "the handle of other is on its track", False),
        (((100, 300), (140, 300)), ((120, 280), (120, 320)), "its track crosses that of other", True),
        (((100, 300), (140, 300)), ((90, 320), (95, 303), (220, 303)), "its track runs along that of other", True),
        (((100, 300), (100, 311)), ((200, 300), (200, 340)), "its track is 11 px long", False),
    ],
)
def test_an_element_in_the_way_is_named_with_what_it_does(one, other, reason, both):
    found = unclear(element("one", *one), element("other", *other))
    assert reason in found["one"].split(", ")
    assert ("other" in found) == both


def test_tracks_that_run_along_each_other_for_less_than_a_third_do_not_count():
    found = unclear(element("one", (100, 300), (140, 300)), element("other", (100, 303), (110, 303), (110, 260)))
    assert not any("runs along" in reasons for reasons in found.values())


def test_elements_apart_are_clear():
    assert unclear(element("one", (100, 300), (100, 340)), element("other", (130, 300), (130, 340))) == {}


def test_members_of_a_coarse_element_and_the_board_are_not_in_the_way():
    coarse = element("one", (100, 300), (100, 340), inner=("member",))
    assert unclear(coarse, element("member", (100, 300), (130, 300))) == {}
    assert (
        unclear(coarse, element("member", (100, 300), (130, 300)), element("b", (101, 300), (120, 300), on_board=True))
        == {}
    )
    assert legibility((), SCREEN).elements == 0


def test_hands_are_clear_each_from_its_own_side():
    """Not one of them was while curls and spreads were kept apart in space."""
    _, hands, _ = chain.laid_parts(limbs.whole_body())
    assert legibility_of(hands.inputs.face, hands.layout.elements).clear == 8
