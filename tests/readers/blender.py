"""The Blender extension, as it is packed, as a reader of layouts: ``blender.py EXTENSION LAYER``, with questions on
standard input.  Poses away from the base pose Blender itself evaluates: these are answered with null."""

import json
import sys
from dataclasses import fields

import numpy as np
from pxr import Usd

sys.path.insert(0, sys.argv[1])
from usdrigui_controls import layout, reading, screen, tracking

PIXELS = screen.Screen(
    np.array([[1.0, 0, 0, -1], [0, -1, 0, 1], [0, 0, 1, 0], [0, 0, 0, 1]]), 2.0, 2.0, np.array([0.0, 0.0, 1.0]), False
)
"""A view in which world x and y are pixels."""


def elements(found, _):
    return {
        each.name: {
            "type": each.kind,
            "axes": [[each.members[member].control for member in axis] for axis in each.axes],
            "mirror": each.mirror,
            "side": each.side,
            "members": each.inner,
            "onBoard": not each.mesh,
            "values": [member.values for member in each.members],
        }
        for each in found.elements
    }


def pose(found, question):
    controls, placed = {control.name: control for control in found.controls}, {}
    if question["values"]:
        return None
    for each in found.elements:
        drawing, still = tracking.drawing_of(each, controls), np.eye(4)
        point = np.array(each.position) if each.follows else None
        where = tracking.place(drawing, point, point, still, drawing.base)
        placed[each.name] = {"handle": where.handle.tolist(), "tracks": [track.tolist() for track in where.tracks]}
    return placed


def drag(_, question):
    ranges = zip(*(question[name] for name in ("minimum", "default", "maximum", "base")), strict=True)
    rest = {"keys": (), "shapes": (), "joints": (), "attribute": ""}
    controls = tuple(layout.Control(str(i), "", *each, **rest) for i, each in enumerate(ranges))
    tracks = [tuple((x, y, 0.0) for x, y in track) for track in question["tracks"]]
    members = tuple(
        layout.Member(str(i), tuple(values), track, 1.0, False)
        for i, (values, track) in enumerate(zip(question["values"], tracks, strict=True))
    )
    given = {each.name: {"str": "", "int": 0, "bool": False}.get(each.type, ()) for each in fields(layout.Element)}
    element = layout.Element(
        **{**given, "members": members, "position": (0.0,) * 3, "normal": (0.0,) * 3, "axes": question["axes"]}
    )
    stored = layout.from_json(layout.to_json(layout.Layout("/Char", (), controls, (element,), (), ())))
    drawing = tracking.drawing_of(stored.elements[0], {control.name: control for control in stored.controls})
    where = tracking.Placed(tuple(map(np.array, tracks)), (), np.zeros(3), np.zeros(3), 1.0, question["start"])
    grab = screen.Grab(PIXELS, drawing, where)
    return [grab.to(move).tolist() for move in question["moves"]]


ASKED = {"layout": elements, "pose": pose, "drag": drag, "findings": lambda *_: None}
questions = json.load(sys.stdin)
try:
    (read,) = reading.read_layouts(Usd.Stage.Open(sys.argv[2]))
    answers = [ASKED[each["ask"]](read, each) for each in questions]
except layout.LayoutError:
    answers = [{"refused": True}] * len(questions)
print(json.dumps(answers))
