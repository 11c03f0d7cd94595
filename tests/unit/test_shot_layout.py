"""What a shot's layer adds to elements of another layer."""

from types import SimpleNamespace

import numpy as np
import pytest
from pxr import Sdf

from usdrigui.layer import shot_layout
from usdrigui.layer.shot_layout import _author_new_shapes, _moved
from usdrigui.layer.skin_binding import PointShape
from usdrigui.model import Placement


def shape(channel, count=1):
    return PointShape(channel, np.array([1.0]), np.arange(3.0 * count).reshape(1, count, 3))


@pytest.mark.parametrize(("channels", "written"), [((0, 0), []), ((0, 1), [[[], [1]]]), ((1, 1), [[[1], [1]]])])
def test_a_prim_gets_the_shapes_that_any_of_its_elements_newly_follows(monkeypatch, channels, written):
    """Channel 0 is known to its layer; of two elements on the prim one may follow a new one."""
    found = []
    anchor, placement = SimpleNamespace(on_board=False), Placement()
    elements = [SimpleNamespace(name=f"e{i}", anchor=anchor, placement=placement) for i in range(2)]
    drawn = {
        f"e{i}": [SimpleNamespace(shapes=(shape(channel),), points=np.zeros((1, 3)))]
        for i, channel in enumerate(channels)
    }
    monkeypatch.setattr(shot_layout, "SkinBinding", lambda *_: None)
    monkeypatch.setattr(shot_layout, "drawn_parts", lambda _, element, __: drawn[element.name])
    monkeypatch.setattr(
        shot_layout, "author_shapes",
        lambda spec, _rig, new, *_: found.append((spec.path, [[each.channel for each in shapes] for _, shapes in new])),
    )  # fmt: skip
    spans = [SimpleNamespace(element=f"e{i}", role="handle", points=np.array([i])) for i in (0, 1)]
    prim = SimpleNamespace(path="/Base/RigUI/face/shapes", spans=spans, shapes=["known"], targets=["/Base/x"], names=())
    body = SimpleNamespace(channels=(SimpleNamespace(token="known"), SimpleNamespace(token="new")))
    rig = SimpleNamespace(skel_root=SimpleNamespace(path="/Shot/Char"), body=body)
    layout = SimpleNamespace(frame=None)
    shot = SimpleNamespace(rig=rig, layout=layout, base_root="/Base", prims=[prim])
    layer = Sdf.Layer.CreateAnonymous(".usda")
    scope = Sdf.CreatePrimInLayer(layer, "/Shot/Char/RigUI")
    _author_new_shapes(scope, shot, elements)
    assert [shapes for _, shapes in found] == written
    assert all(str(path) == "/Shot/Char/RigUI/face/shapes" for path, _ in found)


def test_what_somebody_drew_otherwise_follows_its_anchor_as_one():
    parts = [SimpleNamespace(points=np.zeros((count, 3)), shapes=(shape(0, count),)) for count in (3, 4)]
    theirs = list(_moved(parts, SimpleNamespace(role="handle", points=np.array([7, 9]))))
    assert [points.tolist() for points, _ in theirs] == [[7, 9]]
    assert theirs[0][1][0].offsets.tolist() == [[[0.0, 1.0, 2.0]] * 2]
    assert list(_moved(parts, SimpleNamespace(role="handle", points=np.zeros(0, dtype=int)))) == []
