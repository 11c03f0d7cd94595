"""Whatever the controls of a rig are called and however it stands or lies, they are where they usually are.

The sample is renamed and turned once in every way, in three of them in the quick suite, and solved to a proof:
variables are in the order of names, and where the search is cut short another order ends in another layout.  More
rigs and draws by the environment; two hundred draws of small heads take an hour of one core::

    RENAMED_RIGS="$(echo heads/*.usdc)" RENAMED_DRAWS=2 pytest --suite all tests/laws/test_names_are_hints.py
"""

import os
from pathlib import Path

import namings
import numpy as np
import pytest
import rig_copies
from folders import SAMPLE

from usdrigui.pipeline import stages
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load
from usdrigui.solve import solve

RIGS = [SAMPLE, *map(Path, os.environ.get("RENAMED_RIGS", "").split())]
DRAWS = int(os.environ.get("RENAMED_DRAWS", "1"))
SETTINGS = load({"read": {"joints": "none"}, "solve": {"work_limit": 20_000_000}})
QUICK = (namings.prefixed, namings.permuted)
WAYS = [
    pytest.param(way, id=way.__name__, marks=() if way in QUICK else pytest.mark.slow)
    for way in (*namings.HINTS, namings.permuted)
]
WORLDS = [pytest.param(world, marks=() if world == "on its back" else pytest.mark.slow) for world in rig_copies.WORLDS]
REACH = 0.12
"""Distance, in face sizes, within which a handle stands at the same place."""


def placed(rig):
    """Points with the handles of the controls of the first part, the face, and its surface."""
    character = stages.character_of(rig, SETTINGS)
    inputs = stages.part_problem(character, character.parts[0])
    layout = stages.layout_of(inputs, solve(inputs.placement.problem, SETTINGS.solve))
    return namings.places(rig, layout), inputs.face.surface


@pytest.fixture(scope="module", params=RIGS, ids=lambda path: path.stem)
def plain(request):
    rig = read_rigs(request.param, SETTINGS)[0]
    return rig, *placed(rig)


def assert_in_place(plain, rig, least=0.97):
    """No more than a few of the controls of `rig`, a copy, are elsewhere than on the `plain` one."""
    before, surface = plain[1:]
    after, _ = placed(rig)
    lost = namings.lost(before, after, surface.points, REACH * surface.face_size)
    assert len(lost) <= (1.0 - least) * len(before), sorted(rig.controls[i].name for i in lost)


@pytest.mark.parametrize("draw", range(DRAWS))
@pytest.mark.parametrize("naming", WAYS)
def test_controls_stand_where_they_stand_by_their_usual_names(plain, naming, draw):
    least = 0.95 if naming is namings.permuted else 0.97
    assert_in_place(plain, namings.renamed(plain[0], naming, np.random.default_rng(draw)), least)


@pytest.mark.parametrize("draw", range(DRAWS))
@pytest.mark.parametrize("world", WORLDS)
def test_controls_stand_where_they_stand_on_an_upright_character(plain, world, draw):
    rotation = rig_copies.WORLDS[world](np.random.default_rng(draw))
    assert_in_place(plain, rig_copies.turned(plain[0], rotation))
