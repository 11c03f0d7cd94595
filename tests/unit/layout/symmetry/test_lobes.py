"""A symmetric control with two lobes gets a handle on each, both of one value."""

import chain
import makers
import pytest

POINTS, QUADS = makers.mask()
SHAPES = makers.face_shapes(POINTS)


def elements_of(control, x, **settings):
    lobes = sum(makers.bump(POINTS, (side * x, -0.1), (side * x, 0.0, 1.0), 0.2, 0.1) for side in (-1, 1))
    line = chain.lay_out(makers.rig(POINTS, QUADS, SHAPES | {control: lobes}), chain.settings(**settings))
    layout = chain.by_name(line)
    return [each for each in layout.values() if any(member.control == control for member in each.members)]


@pytest.mark.parametrize(("x", "count"), [(0.45, 2), (0.3, 2), (0.05, 1)])
def test_two_lobes_off_the_plane_have_a_handle_each_and_one_lobe_stands_in_the_middle(x, count):
    found = elements_of("puff", x)
    assert len(found) == count
    if count == 2:
        left, right = found
        assert left.mirror == right.name
        assert right.mirror == left.name
        assert left.anchor.position[0] == pytest.approx(-right.anchor.position[0], abs=1e-6)


@pytest.mark.parametrize(("setting", "x", "count"), [("never", 0.45, 1), ("always", 0.2, 2)])
def test_the_configuration_has_the_last_word(setting, x, count):
    assert len(elements_of("puff", x, symmetry={"double_middle": setting})) == count


def test_a_double_element_without_room_on_the_face_stands_on_the_board_once():
    found = elements_of("puff", 0.45, objective={"handle_size": 0.9, "handle_size_min": 0.9})
    assert [each.anchor.on_board for each in found] == [True]
