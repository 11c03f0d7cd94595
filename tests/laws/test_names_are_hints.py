"""Whatever the controls of a rig are called, they stand where they stand by their usual names.

The sample is renamed once in every way, in two of them in the quick suite, and solved to a proof: variables are in
the order of names, and where the search is cut short another order ends in another layout.  With names permuted,
wrong names keep the ends of two sliders apart.  More rigs and draws by the environment::

    RENAMED_RIGS="$(echo heads/*.usdc)" RENAMED_DRAWS=25 pytest tests/laws/test_names_are_hints.py
"""

import os
from pathlib import Path

import namings
import numpy as np
import pytest

from usdrigui.pipeline import Task, stages
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load
from usdrigui.solve import solve

SAMPLE = Path(__file__).resolve().parents[2] / "sample_assets/char.usda"
RIGS = [SAMPLE, *map(Path, os.environ.get("RENAMED_RIGS", "").split())]
DRAWS = int(os.environ.get("RENAMED_DRAWS", "1"))
SETTINGS = load({"read": {"joints": "none"}, "solve": {"work_limit": 10_000_000}})
QUICK = (namings.prefixed, namings.permuted)
WAYS = [
    pytest.param(way, id=way.__name__, marks=() if way in QUICK else pytest.mark.slow)
    for way in (*namings.HINTS, namings.permuted)
]
REACH = 0.12
"""Distance, in face sizes, within which a handle stands at the same place."""


def placed(rig):
    """Places of the controls of the first part, the face, and its size."""
    character = stages.character_of(rig, Task(SETTINGS))
    inputs = stages.part_problem(character, character.parts[0])
    layout = stages.layout_of(inputs, solve(inputs.placement.problem, SETTINGS.layout.solve))
    return namings.places(rig, layout), inputs.face.trajectories.surface.face_size


@pytest.fixture(scope="module", params=RIGS, ids=lambda path: path.stem)
def plain(request):
    rig = read_rigs(request.param, SETTINGS)[0]
    return rig, *placed(rig)


@pytest.mark.parametrize("draw", range(DRAWS))
@pytest.mark.parametrize("naming", WAYS)
def test_controls_stand_where_they_stand_by_their_usual_names(plain, naming, draw):
    rig, before, size = plain
    after, _ = placed(namings.renamed(rig, naming, np.random.default_rng(draw)))
    lost = namings.lost(before, after, REACH * size)
    least = 0.9 if naming is namings.permuted else 0.97
    assert len(lost) <= (1.0 - least) * len(before), sorted(rig.controls[i].name for i in lost)
