"""Layouts at a pose: what follows the skin, what does not, and what is refused."""

from dataclasses import replace

import laid_out
import makers
import numpy as np
import pytest

from usdrigui.character.deform import deform
from usdrigui.errors import RigUIError
from usdrigui.pose.evaluate import checked_values, evaluate, prepare, values_of


@pytest.fixture(scope="module")
def rig():
    return makers.face()


@pytest.fixture(scope="module")
def layout(rig):
    return laid_out.layout_of(rig, seed=1)


def element(layout, name):
    return [each.name for each in layout.elements].index(name)


def test_at_the_base_pose_everything_is_as_laid_out(rig, layout):
    posed = evaluate(prepare(rig, layout))
    assert posed.points == pytest.approx(deform(rig), abs=1e-12)
    for laid, at in zip(layout.elements, posed.elements, strict=True):
        assert at.handle == pytest.approx(laid.anchor.position, abs=1e-12)
        assert at.rest == pytest.approx(laid.anchor.position, abs=1e-6)
        assert at.tracks[0] == pytest.approx(laid.members[0].track, abs=1e-12)
        assert at.normal == pytest.approx(laid.anchor.normal, abs=1e-12)


def test_enlarged_tracks_leave_the_handle_on_the_skin(rig, layout):
    smile = element(layout, "smile_L")
    one = layout.elements[smile]
    base = one.anchor.position
    large = replace(one.members[0], track=base + 3.0 * (one.members[0].track - base), magnification=3.0)
    changed = replace(layout, elements=(replace(one, members=(large,)),))
    posed = evaluate(prepare(rig, changed), values_of(rig, {"smile_L": 0.5}))
    assert posed.elements[0].handle == pytest.approx(posed.points[one.anchor.point], abs=1e-12)
    assert posed.elements[0].tracks[0] == pytest.approx(large.track, abs=1e-6)


def test_poses_by_name_start_from_defaults_or_a_base(rig):
    assert values_of(rig, {"chin": 0.25}).sum() == 0.25
    base = np.full(len(rig.controls), 0.5)
    assert values_of(rig, {"chin": 0.25}, base).sum() == pytest.approx(base.sum() - 0.25)
    assert (base == 0.5).all()


def test_refuses_poses_that_are_none(rig, layout):
    with pytest.raises(RigUIError, match="POSE_CONTROL chinn"):
        values_of(rig, {"chinn": 1.0})
    with pytest.raises(RigUIError, match="POSE_VALUE chin"):
        values_of(rig, {"chin": float("nan")})
    with pytest.raises(RigUIError, match="POSE_VALUE"):
        evaluate(prepare(rig, layout), [0.0])
    with pytest.raises(RigUIError, match="POSE_VALUE"):
        checked_values(rig, np.full(len(rig.controls), np.inf))


def test_refuses_layouts_of_another_character(rig, layout):
    one = layout.elements[0]
    for broken in (
        replace(one, anchor=replace(one.anchor, mesh="/Root/gone")),
        replace(one, anchor=replace(one.anchor, point=10**6)),
        replace(one, anchor=replace(one.anchor, topology_hash="other")),
        replace(one, members=(replace(one.members[0], control="gone"),)),
    ):
        with pytest.raises(RigUIError, match="LAYOUT_STALE"):
            prepare(rig, replace(layout, elements=(broken,)))
    with pytest.raises(RigUIError, match="LAYOUT_STALE"):
        prepare(rig, replace(layout, base_values=np.zeros(3)))
