"""Real rigs laid out with earlier layouts to heed, as the pipeline does but without files."""

import pytest
from folders import ASSETS

from usdrigui.pipeline.reference_layouts import ReferenceLayouts
from usdrigui.pipeline.stages import build_problem, layout_of
from usdrigui.reader.reader_process import read_rigs_isolated
from usdrigui.settings import load
from usdrigui.solve import solve

SETTINGS = load({"solve": {"gap": 1e-2}})


def read(name, settings=SETTINGS):
    """The rig of a file; skips the test where it is not there."""
    path = ASSETS / name
    if not path.is_file():
        pytest.skip(f"needs {path}")
    return read_rigs_isolated(path, settings).rigs[0]


def lay_out(rig, settings=SETTINGS, **references):
    """The problem, its solution and the layout; `references` as of `ReferenceLayouts`."""
    inputs = build_problem(rig, settings, ReferenceLayouts(**references))
    found = solve(inputs.placement.problem, settings.solve)
    return inputs, found, layout_of(inputs, found)
