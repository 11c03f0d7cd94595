"""Makes drags.json, the questions about drags: ``python schemas/conformance/drags.py``.

An element on the screen, in pixels, and drags of its handle.  What is expected never comes from a rule of drags:
coordinates are chosen on the element's axes, and the tracks say where the pointer must be for them.  Steps without an
expected answer lie out of the handle's reach: there the laws alone hold.  The elements of real rigs, seen from the
front of their face and from its side, are kept in the file itself.
"""

from __future__ import annotations

import itertools
import json
from pathlib import Path

import numpy as np

FILE = Path(__file__).with_suffix(".json")
FIFTH = 0.2
"""Pixels between pointer and handle."""
# --- forward: from coordinates to values to pixels -----------------------------------------------------


def ends(element, axis):
    """(member, sign, off, far) of an axis."""
    low, middle, high = (element[name] for name in ("minimum", "default", "maximum"))
    if len(axis) == 1:
        return [(axis[0], 1.0, low[axis[0]], high[axis[0]])]
    far = [high[i] if high[i] - middle[i] >= middle[i] - low[i] else low[i] for i in axis]
    return [(i, sign, middle[i], end) for i, sign, end in zip(axis, (-1.0, 1.0), far, strict=True)]


def values_at(element, coordinates):
    """Member values at one coordinate per axis."""
    found = np.zeros(len(element["tracks"]))
    for axis, coordinate in zip(element["axes"], coordinates, strict=True):
        for member, sign, off, far in ends(element, axis):
            found[member] = off + max(sign * coordinate, 0.0) * (far - off)
    return found


def handle(element, values):
    """(2,) pixels from where the handle is in the base pose: the sum of what the members' tracks say."""
    moved = np.zeros(2)
    for track, knots, value, base in zip(element["tracks"], element["values"], values, element["base"], strict=True):
        for axis in (0, 1):
            line = np.array(track)[:, axis]
            moved[axis] += np.interp(value, knots, line) - np.interp(base, knots, line)
    return moved


def within(element, coordinates, free):
    """(members,) what a fifth of a pixel is in values, on the worst sides of the coordinates; None where the
    handle hardly moves in some direction."""
    here, worst = handle(element, values_at(element, coordinates)), np.zeros(len(coordinates))
    for sides in itertools.product((-1e-6, 1e-6), repeat=len(free)):
        slopes = []
        for i, side in zip(free, sides, strict=True):
            other = np.array(coordinates, dtype=np.float64)
            low = 0.0 if len(element["axes"][i]) == 1 else -1.0
            other[i] += side if low <= other[i] + side <= 1.0 else -side
            slopes.append((handle(element, values_at(element, other)) - here) / (other[i] - coordinates[i]))
        rows = np.array(slopes).T
        if np.linalg.svd(rows, compute_uv=False).min() < 5.0:
            return None
        worst[free] = np.maximum(worst[free], FIFTH * np.linalg.norm(np.linalg.pinv(rows), axis=1))
    found = np.zeros(len(element["tracks"]))
    for axis, error in zip(element["axes"], worst, strict=True):
        for member, _, off, far in ends(element, axis):
            found[member] = max(error, 1e-6) * abs(far - off)
    return found


# --- drags -------------------------------------------------------------------------------------------


def described(element, paths):
    """The element with its drags: coordinates on the way, from the base pose or from the first of them."""
    reach = _reach(element)
    return {**element, "drags": [_drag(element, reach, path) for path in paths]}


def _drag(element, reach, path):
    start = values_at(element, path[0])
    first, steps = handle(element, start), []
    for before, after in itertools.pairwise(path):
        steps += [
            _step(element, reach, np.add(before, share * np.subtract(after, before)), first) for share in (0.5, 1)
        ]
        steps += [_beside(element, reach, after, first, np.array(off)) for off in ((0.0, -4.0), (0.0, 4.0))]
    around = 1.7 * max(np.abs(np.array(track)).max() for track in element["tracks"])
    for turn in np.arange(0.0, 2.0 * np.pi, np.pi / 4.0):
        steps.append({"to": (around * np.array([np.cos(turn), np.sin(turn)])).round(3).tolist()})
    return {"start": start.round(12).tolist(), "steps": steps}


def _step(element, reach, at, first):
    """The pointer is where the handle is at the coordinates."""
    values = values_at(element, at)
    place, base = handle(element, values), np.array(element["base"])
    free = [i for i, axis in enumerate(element["axes"]) if len(element["axes"]) <= 2 or (values != base)[axis].any()]
    error = within(element, at, free) if 0 < len(free) <= 2 else None
    if error is not None and not (reach and _folded(reach, place, at, 3.0)):
        return {
            "to": (place - first).round(4).tolist(),
            "values": values.round(6).tolist(),
            "within": error.round(6).tolist(),
        }
    return {"to": (place - first).round(4).tolist()}


def _beside(element, reach, at, first, off):
    """The pointer is a little off: where it cannot be reached, the handle comes as near as it can."""
    goal = handle(element, values_at(element, at)) + off
    step = {"to": (goal - first).round(4).tolist()}
    if reach is None:
        return step
    grids, there = reach
    away = np.linalg.norm(there - goal, axis=-1)
    best = [grid[i] for grid, i in zip(grids, np.unravel_index(np.argmin(away), away.shape), strict=True)][: len(at)]
    error = within(element, best, list(range(len(at))))
    if error is None or _folded(reach, goal, best, 2.0 * away.min() + 8.0):
        return step
    # The grid is as coarse as it is; across a flat minimum twice that.
    coarse = 2.0 * max(grid[1] - grid[0] for grid in grids[: len(at)])
    scale = [abs(far - near) for near, far in zip(element["minimum"], element["maximum"], strict=True)]
    return {
        **step,
        "values": values_at(element, best).round(6).tolist(),
        "within": (error + coarse * np.array(scale)).round(6).tolist(),
    }


def _reach(element):
    """Coordinates of one or two axes, as grids, and the handle's place at each; None for a fan."""
    axes = element["axes"]
    if len(axes) > 2:
        return None
    grids = [np.linspace(0.0 if len(axis) == 1 else -1.0, 1.0, 161) for axis in axes]
    none, lines = [0.0] * len(axes), []
    for i, grid in enumerate(grids):
        lines.append(np.array([handle(element, values_at(element, [*none[:i], s, *none[i + 1 :]])) for s in grid]))
    if len(axes) == 1:
        return [grids[0], np.zeros(1)], lines[0][:, None]
    return grids, lines[0][:, None] + (lines[1] - handle(element, values_at(element, none)))[None]


def _folded(reach, place, at, near):
    """Whether other coordinates bring the handle to nearly the same place."""
    (first, second), there = reach
    far = np.abs(first - at[0])[:, None] > 0.2
    far = far | (np.abs(second - at[-1])[None] > 0.2) if len(second) > 1 else far
    return bool(((np.linalg.norm(there - place, axis=-1) < near) & far).any())


def ways(element):
    """Paths over the axes: along each of one or two, then over what two of them span."""
    lows = [0.0 if len(axis) == 1 else -1.0 for axis in element["axes"]]
    if len(lows) == 1:
        there = [(0,), (0.3,), (0.8,), (1,), (0.4,), (0,)]
        return [[*there, *(([-0.5], [-1], [-0.3], [0.2]) if lows[0] else ([0.6], [0.2]))]]
    out = [(0, 0), (0.3, 0), (0.3, 0.6), (1, 0.6), (0.5, 1), (0.5 * lows[0], 1), (lows[0], 0.4)]
    back = [(0.7 * lows[0], 0.5 * lows[1]), (0.2, 0.8 * lows[1]), (0.9, 0.3 * lows[1]), (0.3, 0)]
    return [[*out, *back], [(0, 0), (0.3 * lows[0], 0), (lows[0], 0), (0.6 * lows[0], lows[1]), (0.1, lows[1])]]


# --- made elements -----------------------------------------------------------------------------------


def arm(degrees, length=90.0, bend=0.0, knots=(0.0, 1.0)):
    """A track from the origin, turning by `bend` degrees on its way; x to the right, y down."""
    turns = np.radians(degrees + np.linspace(0.0, bend, len(knots) - 1))
    steps = np.diff(knots)[:, None] * np.stack([np.cos(turns), -np.sin(turns)], axis=1)
    return np.vstack([np.zeros(2), length / (knots[-1] - knots[0]) * np.cumsum(steps, axis=0)]).round(6).tolist()


def made(tracks, axes, values=None, minimum=0.0, default=0.0, maximum=1.0, base=None):
    """An element of which all controls go from 0 to 1 unless told otherwise."""
    ranges = {
        name: np.broadcast_to(np.array(each, dtype=np.float64), len(tracks)).tolist()
        for name, each in (("minimum", minimum), ("default", default), ("maximum", maximum))
    }
    knots = values or [np.linspace(0.0, 1.0, len(track)).tolist() for track in tracks]
    return {"axes": axes, "tracks": tracks, "values": knots, **ranges, "base": base or ranges["default"]}


THIRDS = (0.0, 0.25, 0.5, 0.75, 1.0)


def made_elements():
    """By name, elements that no rig at hand has."""
    west, east, north = arm(180), arm(0), arm(90)
    sticks = [arm(176, 70), arm(2, 80), arm(86, 60), arm(273, 75)]
    fan = [arm(each) for each in (10, 55, 100, 150)]
    signed = [[-80.0, 6.0], [0.0, 0.0], [80.0, 0.0]]
    found = {
        "slider": made([arm(30)], [[0]]),
        "slider of a curved track": made([arm(0, 160, 150, THIRDS)], [[0]]),
        "signed slider": made([signed], [[0]], [[-1.0, 0.0, 1.0]], minimum=-1.0),
        "patch": made([arm(20), arm(110, 60)], [[0], [1]]),
        "patch of curved tracks": made([arm(0, 100, 40, THIRDS), arm(90, 70, 30, THIRDS)], [[0], [1]]),
        "patch with a signed control": made([signed, north], [[0], [1]], [[-1, 0, 1], [0, 1]], minimum=[-1.0, 0.0]),
        "straight two-way slider": made([west, east], [[0, 1]]),
        "two-way slider bent by 4 degrees": made([arm(178), arm(-2)], [[0, 1]]),
        "two-way slider bent by 60 degrees": made([arm(150, 90, -20, THIRDS), arm(30)], [[0, 1]]),
        "two-way slider, positive end first": made([east, arm(176)], [[1, 0]]),
        "joystick of two bent axes": made(sticks, [[0, 1], [2, 3]]),
        "joystick of curved tracks": made(
            [arm(180, 80, 25, THIRDS), arm(3, 80, -25, THIRDS), arm(275, 60, 20, THIRDS), arm(90, 60)], [[0, 1], [2, 3]]
        ),
        "joystick in another base pose": made(sticks, [[0, 1], [2, 3]], base=[0.5, 0.0, 0.0, 0.2]),
        "joystick of other ranges": made(
            [arm(2, 80)[::-1], [[0.0, 0.0], [-5.0, 0.0], [-75.0, 4.0]], arm(88, 70)],
            [[0, 1], [2]],
            [[-2.0, 0.0], [0.0, 0.25, 3.75], [0.0, 10.0]],
            minimum=[-2.0, 0.0, 0.0],
            default=[0.0, 0.25, 0.0],
            maximum=[0.0, 3.75, 10.0],
        ),
    }
    elements = {name: described(element, ways(element)) for name, element in found.items()}
    fan_way = [(0, 0, 0, 0), (0.6, 0, 0, 0), (0.5, 0.4, 0, 0), (0, 0.8, 0, 0), (0, 0.3, 0.6, 0), (0, 0, 0.5, 0.9)]
    elements["fan"] = described(made(fan, [[0], [1], [2], [3]]), [fan_way])
    with_pair = made([*fan[:3], arm(187), arm(280)], [[0, 3], [1], [2], [4]])
    pair_way = [(0, 0, 0, 0), (-0.6, 0, 0, 0), (-0.5, 0.4, 0, 0), (0, 0.5, 0.5, 0), (0.4, 0, 0.6, 0), (0.8, 0, 0, 0.3)]
    elements["fan with a two-way axis"] = described(with_pair, [pair_way])
    return {**elements, **by_hand()}


def by_hand():
    """By name, elements with answers that stand here as they are."""
    hairpin = made([[[0.0, 0.0], [100.0, 0.0], [110.0, 10.0], [100.0, 20.0], [0.0, 20.0]]], [[0]])
    round_it = [
        ((20, 2), 0.15),
        ((50, 0), 0.225),
        ((65, 4), 0.3625),
        ((70, 10), 0.5),
        ((50, 20), 0.775),
        ((10, 20), 0.875),
    ]
    wide, narrow = (made([[[0.0, 0.0], [100.0, 0.0], [100.0, y], [0.0, y]]], [[0]]) for y in (60.0, 4.0))
    from_its_end = made([[[50.0, 50.0], [50.0, 50.0]]], [[0]])
    short = made([[[52.0, 50.0], [50.0, 50.0]]], [[0]])
    one_short = made([arm(178), arm(0), arm(90, 2.0)], [[0, 1], [2]])
    three = made([arm(176), arm(0), arm(90)], [[0, 1], [2]])
    return {
        "hairpin": answered(
            hairpin,
            ([0.1], ((10, 11), [0.125])),  # a little nearer to the branch across: the handle stays on its own
            ([0.9], ((10, -11), [0.875])),
            ([0.1], *((to, [value]) for to, value in round_it)),  # step by step round the bend
            ([0.1], ((10, 19.5), [0.875])),  # nearer by far: it changes
        ),
        "wide hairpin": answered(wide, ([0.1], ((20, 35), [1 / 6])), ([0.1], ((20, 50), [5 / 6]))),
        "narrow hairpin": answered(narrow, ([0.1], ((20, 3.5), [1 / 6]))),
        "slider seen from its end": answered(from_its_end, ([0.0], ((0, -12), [0.5]), ((0, 12), [0.0]))),
        "slider nearly seen from its end": answered(short, ([0.0], ((-6, 20), [0.25]), ((-30, 0), [1.0]))),
        "axis seen from its end": answered(
            one_short, ([0.0, 0.0, 0.4], ((9, 20), [0.0, 0.1, 0.4]), ((-45, 0), [0.5, 0.0, 0.4]))
        ),
        "both ends set before": answered(
            made([arm(180), arm(0)], [[0, 1]]), ([0.5, 0.7], ((9, 0), [0.0, 0.3]), ((-36, 0), [0.2, 0.0]))
        ),
        "joystick far away": answered(
            made([arm(180, 2.0), arm(0, 2.0), arm(90, 3.0)], [[0, 1], [2]]), ([0.0] * 3, ((6, -9), [0.0, 0.5, 0.5]))
        ),
        "fan with a short member between": _fan_with_a_short_member(),
        "fan out of reach": _fan_out_of_reach(),
        "thirty per cent to the right": answered(three, ([0.0] * 3, ((27, -2), [0.0, 0.3, 0.0222]))),
    }


def _fan_with_a_short_member():
    """The outer two are more than 180 degrees apart on their other side, and never set together."""
    a, b, c = (np.array(arm(*each)[1]) for each in ((10, 90.0), (80, 20.0), (150, 90.0)))
    goal = a + 0.9 * c
    share = float((goal - b) @ a / (a @ a))
    fan = made([[[0.0, 0.0], each.tolist()] for each in (a, b, c)], [[0], [1], [2]])
    return answered(fan, ([0.0] * 3, (goal.tolist(), [share, 1.0, 0.0])))


def _fan_out_of_reach():
    """Of two pairs as good, the one in use; else the nearer."""
    a, b, c, d = (np.array(arm(each)[1]) for each in (10, 55, 100, 150))
    return answered(
        made([[[0.0, 0.0], each.tolist()] for each in (a, b, c, d)], [[0], [1], [2], [3]]),
        ([0.5, 0.5, 0.0, 0.0], ((3.0 * b - 0.5 * (a + b)).tolist(), [1.0, 1.0, 0.0, 0.0])),
        ([0.0, 0.5, 0.5, 0.0], ((3.0 * b - 0.5 * (b + c)).tolist(), [0.0, 1.0, 1.0, 0.0])),
        ([0.0, 0.0, 0.5, 0.5], ((5.0 * (b + c) - 0.5 * (c + d)).tolist(), [0.0, 1.0, 1.0, 0.0])),
        ([0.0, 0.9, 0.0, 0.0], ((0.03 * a - 0.1 * b).tolist(), [0.03, 0.8, 0.0, 0.0])),
    )


def answered(element, *drags):
    """The element with drags of given answers: values at the start, then ways of the pointer with values."""
    return {
        **element,
        "drags": [
            {"start": start, "steps": [{"to": list(to), "values": at, "within": [0.003] * len(at)} for to, at in steps]}
            for start, *steps in drags
        ],
    }


# --- the file ----------------------------------------------------------------------------------------


def questions():
    """All elements, the made ones and those of real rigs that the file has, each with its drags."""
    kept = {each["element"]: each for each in json.loads(FILE.read_text(encoding="utf-8"))["questions"]}
    fields = ("axes", "tracks", "values", "minimum", "default", "maximum", "base")
    real = {name: {key: each[key] for key in fields} for name, each in kept.items() if "turned by" in name}
    elements = {**made_elements(), **{name: described(each, ways(each)) for name, each in real.items()}}
    return [
        {
            "ask": "drag",
            "element": name,
            **{key: element[key] for key in fields},
            "start": drag["start"],
            "moves": [step["to"] for step in drag["steps"]],
            "answer": [step.get("values") for step in drag["steps"]],
            "within": [step.get("within") for step in drag["steps"]],
        }
        for name, element in elements.items()
        for drag in element["drags"]
    ]


def written():
    """The text of the file, a question a line."""
    lines = ",\n".join(json.dumps(each, ensure_ascii=False) for each in questions())
    return f'{{"layer": "slider.usda", "questions": [\n{lines}\n]}}\n'


if __name__ == "__main__":
    FILE.write_text(written(), encoding="utf-8")
