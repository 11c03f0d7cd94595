"""Terms of other packages."""

from dataclasses import replace
from importlib import metadata
from importlib.metadata import EntryPoint

import chain
import makers
import numpy as np
import pytest
from makers import POINTS

from usdrigui.errors import RigUIError
from usdrigui.layout.place import extensions
from usdrigui.model import ExtraPairs
from usdrigui.overlap import total_cost


class KeepLow:
    """A term as another package would write it: lower is better, and chin and pucker avoid each other."""

    @staticmethod
    def linear(face, motion, points):
        del motion
        heights = face.surface.points[points] @ face.rig.up
        return 5.0 * (heights - heights.min())

    @staticmethod
    def pairs(face, problem, choices):
        del face, choices
        names = [variable.name for variable in problem.variables]
        a, b = sorted((names.index("chin"), names.index("pucker")))
        first, second = (len(problem.variables[i].points) for i in (a, b))
        grid = np.indices((first, second)).reshape(2, -1)
        yield ExtraPairs(a, b, grid[0], grid[1], np.full(first * second, 0.25))


class Wrong:
    @staticmethod
    def linear(face, motion, points):
        del face, motion
        return -np.ones(len(points))


@pytest.fixture
def installed(monkeypatch):
    found = [EntryPoint("low", f"{__name__}:KeepLow", extensions.GROUP), EntryPoint("wrong", "x:y", extensions.GROUP)]
    loads = {"low": KeepLow, "wrong": Wrong}
    monkeypatch.setattr(metadata, "entry_points", lambda group: [e for e in found if e.group == group])
    monkeypatch.setattr(EntryPoint, "load", lambda self: loads[self.name])


@pytest.mark.usefixtures("installed")
def test_terms_of_other_packages_act_when_named():
    plain = chain.problem_of(makers.face())
    line = chain.problem_of(makers.face(), chain.settings(objective={"terms": ("low",)}))
    low, free = (next(v for v in each.problem.variables if v.name == "brow_L") for each in (line, plain))
    raised = low.cost - free.cost
    heights = POINTS[low.points, 1]
    # Both copies count.
    assert np.allclose(raised, 10.0 * (heights - heights.min()), atol=1e-5)
    assert plain.problem.extra == ()
    labels = np.zeros(len(line.problem.variables), dtype=int)
    without = replace(line.problem, extra=())
    assert total_cost(line.problem, labels) == pytest.approx(total_cost(without, labels) + 0.25)


@pytest.mark.usefixtures("installed")
@pytest.mark.parametrize(("term", "code"), [("wrong", "TERM_INVALID"), ("absent", "CONFIG_VALUE")])
def test_wrong_terms_are_refused(term, code):
    with pytest.raises(RigUIError, match=code):
        chain.problem_of(makers.face(), chain.settings(objective={"terms": (term,)}))


@pytest.mark.parametrize("answer", [[1.0, np.nan], [np.inf, 0.0], [0.5, -0.5], [1.0], [1.0, 1.0, 1.0]])
def test_one_cost_that_is_not_finite_or_below_nothing_or_one_too_many_is_refused(answer):
    with pytest.raises(RigUIError, match="TERM_INVALID"):
        extensions._checked("low", answer, 2)
    assert extensions._checked("low", [0.0, 1.5], 2).tolist() == [0.0, 1.5]
