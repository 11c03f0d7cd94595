"""usdrigui's own reader, for `usdrigui conform` and for the answers that are kept here: ``readers.py LAYER``, with
questions on standard input."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
from pxr import Usd

import usdrigui
from usdrigui.errors import RigUIError
from usdrigui.pose.drag import begin_drag, drag_to, values_at
from usdrigui.pose.evaluate import elements_at, prepare, values_of
from usdrigui.settings.loading import load_beside


def answers(layer, questions):
    """The answer to each question about a layer."""
    try:
        opened = usdrigui.open(Usd.Stage.Open(str(layer)), load_beside(Path(layer)))
    except RigUIError:
        return [{"refused": True} if each["ask"] != "drag" else drag(each) for each in questions]
    return [ASKED[each["ask"]](opened, each) for each in questions]


def layout(opened, _):
    ((_, found),) = opened.characters
    return {each.name: element(each) for each in found.elements}


def element(each):
    controls = [member.control for member in each.members]
    return {
        "type": each.kind,
        "axes": [[controls[member] for member in axis] for axis in each.axes],
        "mirror": each.mirror,
        "side": each.side,
        "members": list(each.inner),
        "onBoard": each.anchor.on_board,
        "values": [member.values.tolist() for member in each.members],
    }


def pose(opened, question):
    ((rig, found),) = opened.characters
    at = values_of(rig, question["values"], found.base_values)
    return {
        each.name: {"handle": each.handle.tolist(), "tracks": [track.tolist() for track in each.tracks]}
        for each in elements_at(prepare(rig, found), at)
    }


def drag(question):
    ranges = np.stack([question[name] for name in ("minimum", "default", "maximum")], axis=1)
    given = (question[name] for name in ("tracks", "values", "axes"))
    held = begin_drag(*given, ranges, question["base"], question["start"])
    at, found = held.start, []
    for move in question["moves"]:
        at = drag_to(held, at, move)
        found.append(values_at(held, at).tolist())
    return found


def findings(opened, _):
    return sorted({each.code for each in opened.check().issues if each.severity != "info"})


ASKED = {"layout": layout, "pose": pose, "drag": lambda _, question: drag(question), "findings": findings}

if __name__ == "__main__":
    print(json.dumps(answers(sys.argv[1], json.load(sys.stdin))))
