"""usdrigui.layout.names: what elements are called."""

import itertools

import pytest

from usdrigui.layout.names import common_label, element_name

CONTROLS = ["smile", "50", "smile_50", "a_b", "c", "a", "b_c", "+", "a+b"]


@pytest.mark.parametrize(
    ("controls", "expected"),
    [(["a"], "a"), (["smile", "c"], "smile_c"), (["smile", "50"], "smile+50"), (["a_b", "c"], "a_b+c")],
)
def test_names_are_joined_so_that_they_are_nobody_elses(controls, expected):
    assert element_name(controls, CONTROLS) == expected


def test_no_two_elements_have_one_name():
    groups = [group for size in (1, 2, 3) for group in itertools.permutations(CONTROLS[:7], size)]
    names = [element_name(group, CONTROLS[:7]) for group in groups]
    assert len(set(names)) == len(names)


@pytest.mark.parametrize(
    ("labels", "expected"),
    [
        (["eyeLookIn_L", "eyeLookOut_L"], "eyeLook In/Out L"),
        (["eye_blink", "eye_eye_blink"], "eye_blink / eye_eye_blink"),
        (["jaw", "brow"], "jaw / brow"),
        (["jawLeft", "jawRight"], "jaw Left/Right"),
        (["mouthOpen", "browUp"], "mouthOpen / browUp"),
        (["smile_x_c_d", "frown_y_c_d"], "smile_x/frown_y c_d"),
        (["one"], "one"),
    ],
)
def test_a_label_says_once_what_its_controls_have_in_common(labels, expected):
    assert common_label(labels) == expected
