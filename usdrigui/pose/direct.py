"""Direct manipulation: pull the skin and the controls follow (Lewis and Anjyo 2010).

J. P. Lewis and K. Anjyo, "Direct manipulation blendshapes", IEEE Computer Graphics and Applications
30(4), 2010, fit the weights w to pulled points m by  min |B w - m|^2 + alpha |w - w0|^2 + mu |w|^2.
Ours, with x_j the change of control j since the drag began, as a share of its range:

    minimise  sum_i weight_i |W (p_i(x) - target_i)|^2 / L^2  +  stay sum_j (1 + elsewhere (1 - s_j)^2) x_j^2
    with      minimum_j <= value_j <= maximum_j,   x_j = 0 where locked or without effect

over pulled points and pins i.  The departures, and why:

* p_i(x) is the sum of the points' paths under each control (polylines: in-betweens and joints bend), and
  `solve` corrects it by the true deformation, so that joints and shapes together arrive as well;
* L is the longest path that any control gives the pulled points, so that nothing depends on scene units;
* every control is bounded: unbounded solutions left [0, 1] for 16-35 % of the weights in a trial;
* w0 is the pose at the start of the drag: what one drag does not need stays, and a drag back undoes;
* only controls that give the pulled points at least `locality` of the longest path take part, and
  s_j = (longest path at the pulled points) / (longest path anywhere) makes those dearer whose effect is
  mainly elsewhere: a pull at the lip corner should not close an eye (compare the locality of Cetinaslan,
  Orvalho and Lewis 2015, "Sketch-based controllers for blendshape facial animation");
* W scales the component toward the viewer by `depth`: a pointer moves in the plane of the screen;
* in symmetric mode twin controls share one x.

numpy only.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from usdrigui.deform import deform, posed
from usdrigui.errors import refuse
from usdrigui.model import Flags, Floats, Indices, Layout, Record, Rig
from usdrigui.pose.evaluate import checked_values
from usdrigui.pose.fit import Lines, fit, lines
from usdrigui.pose.reach import ends, paths_around, values_along
from usdrigui.pose.subset import subset

_CORRECTIONS = 2
_ENOUGH = 1e-3
"""Of the longest path: what the paths may be wrong by; a fraction of a pixel on the screen."""


@dataclass(frozen=True, slots=True)
class Feel:
    """How direct manipulation behaves."""

    stay: float = 0.01
    """Cost of moving one control through its whole range, against missing a target by the longest path."""
    elsewhere: float = 3.0
    """How much dearer a control is whose effect lies wholly elsewhere."""
    locality: float = 0.1
    """Controls below this share of the longest path at the pulled points take no part."""
    depth: float = 0.15
    """Weight of the component toward the viewer, where a view is given."""
    pin: float = 1.0
    """Weight of a pin, against 1 for a pulled point."""


@dataclass(frozen=True, eq=False)
class Grip(Record):
    """What `grab` found out about the points in hand; good until the drag ends."""

    rig: Rig
    """Cut down to the points in hand."""
    rows: Indices
    """(q,) row of each point in `rig`: pulled points first, then pins."""
    pulled: int
    """How many of them are pulled."""
    start: Floats
    """(controls,) the pose at the start of the drag."""
    positions: Floats
    """(q, 3) of the points in that pose."""
    reach: Floats
    """(controls,) longest path that each control gives any of the pulled points; scene units."""
    controls: Indices
    """(m,) the controls that take part."""
    paths: Lines
    """Of the points in hand under `controls`, in scene units."""
    cost: Floats
    """(variables,) ``stay (1 + elsewhere (1 - s)^2)``, twins added up."""
    low: Floats
    high: Floats
    """(variables,) bounds, as shares of the range from the start."""
    additive: bool
    """True when the paths of the controls that take part add up exactly: no joints, no shared weights."""
    length: float
    """L, over the controls that may change; 0 when none of them moves the pulled points."""
    feel: Feel


@dataclass(frozen=True, eq=False)
class Pulled(Record):
    """The answer to one pull."""

    values: Floats
    """(controls,) the pose."""
    reached: Floats
    """(q, 3) where the points in hand are in it."""
    changed: Indices
    """Controls whose value differs from the start of the drag, strongest change first."""


def grab(
    rig: Rig,
    values: ArrayLike,
    points: Sequence[int],
    pins: Sequence[int] = (),
    *,
    locked: Collection[int] = (),
    twins: Indices | None = None,
    peaks: Floats | None = None,
    feel: Feel | None = None,
) -> Grip:
    """Take ``points`` (indices into all meshes' points) of a rig at a pose in hand and hold ``pins`` still.

    ``locked`` are controls that must not change.  ``twins`` (controls,), from `twins_of`, turns symmetric
    mode on.  ``peaks`` (controls,), from `reach.longest_paths`, says how far each control moves anything, for
    the locality of costs; without it all controls cost the same.  Costs some milliseconds once per drag.
    Raises RigUIError POSE_VALUE for a bad pose, POSE_POINT for no point or one that does not exist.
    """
    feel = feel or Feel()
    start = checked_values(rig, values)
    small, rows = subset(rig, _checked_points(rig, points, pins))
    held = posed(small, start)
    reach, found = _paths(small, start, rows, len(points))
    ranges = np.array([control.maximum - control.minimum for control in rig.controls])
    usable = ranges > 0.0
    usable[list(locked)] = False
    if twins is not None:
        usable &= usable[twins]
    length = float(reach[usable].max(initial=0.0))
    variable = _variables(usable & (reach > 0.0) & (reach >= feel.locality * length), twins)
    controls = np.flatnonzero(variable >= 0)
    low, high = _bounds(small, start, ranges, controls, variable)
    paths = _lines_of(found, controls, start, ranges, variable, 3 * len(rows))
    cost = _costs(feel, reach, peaks, controls, variable)
    return Grip(
        small,
        rows,
        len(points),
        start,
        held.points[rows],
        reach,
        controls,
        paths,
        cost,
        low,
        high,
        _additive(small, controls),
        length,
        feel,
    )


def solve(grip: Grip, targets: ArrayLike, toward: ArrayLike | None = None) -> Pulled:
    """The pose that brings the pulled points nearest to ``targets`` (pulled, 3) at the least change.

    With ``toward`` (3,), the direction to the viewer, what lies along it counts by `Feel.depth` only.
    Raises RigUIError POSE_VALUE when the targets are not finite or of another number.
    """
    goals = np.array(targets, dtype=np.float64)
    if goals.shape != (grip.pulled, 3) or not np.isfinite(goals).all():
        raise refuse("POSE_VALUE", grip.rig.root, f"expected finite targets for {grip.pulled} points")
    if not len(grip.controls):
        return Pulled(grip.start, grip.positions, np.zeros(0, dtype=np.int64))
    wanted = np.zeros_like(grip.positions)
    wanted[: grip.pulled] = goals - grip.positions[: grip.pulled]
    rows = _row_weights(grip, toward)
    weighted = _weighted(grip.paths, rows)
    missing = np.zeros_like(wanted)
    x = np.zeros(len(grip.cost))
    for _ in range(1 + _CORRECTIONS):
        x = fit(weighted, (wanted - missing).ravel() @ rows.T, grip.cost, grip.low, grip.high, x)
        values = _values(grip, x)
        if grip.additive:
            reached = grip.positions + grip.paths.moved(x).reshape(-1, 3)
            break
        reached = deform(grip.rig, values)[grip.rows]
        # What the sum of paths leaves out, where joints and shapes act together, is added to the target.
        unforeseen = (reached - grip.positions) - grip.paths.moved(x).reshape(-1, 3)
        if float(np.abs(unforeseen - missing).max()) <= _ENOUGH * grip.length:
            break
        missing = unforeseen
    change = np.zeros(len(values))
    change[grip.controls] = np.abs(x[grip.paths.variable])
    order = np.argsort(-change, kind="stable")
    return Pulled(values, reached, order[change[order] > 1e-6])


def ranked(grip: Grip) -> Indices:
    """Controls that move the pulled points, strongest first: the answer to "what acts here?"."""
    order = np.argsort(-grip.reach, kind="stable")
    return np.asarray(order[grip.reach[order] > 1e-3 * grip.reach.max(initial=0.0)], dtype=np.int64)


def twins_of(rig: Rig, layout: Layout) -> Indices:
    """(controls,) the twin of each control, as the layout's mirrored elements tell; itself where none.

    Twins that go opposite ways are left to themselves: a pull does not tie eyes to squint.
    """
    names = {control.name: index for index, control in enumerate(rig.controls)}
    elements = {element.name: element for element in layout.elements}
    twins = np.arange(len(rig.controls))
    for element in layout.elements:
        other = elements.get(element.mirror)
        if other is not None and len(other.members) == len(element.members):
            for m, (mine, theirs) in enumerate(zip(element.members, other.members, strict=True)):
                if m not in element.reversed:
                    twins[names[mine.control]] = names[theirs.control]
    return twins


# --- grabbing ----------------------------------------------------------------------------------------


def _checked_points(rig: Rig, points: Sequence[int], pins: Sequence[int]) -> Indices:
    found = np.array([*points, *pins], dtype=np.int64)
    if not len(points) or found.min() < 0 or found.max() >= rig.starts[-1]:
        raise refuse("POSE_POINT", rig.root, f"expected points below {rig.starts[-1]}, got {found.tolist()}")
    return found


def _paths(rig: Rig, start: Floats, rows: Indices, pulled: int) -> tuple[Floats, dict[int, tuple[Floats, Floats]]]:
    """Reach (controls,) and, per control that moves a point in hand, its values (k,) and offsets (k, 3 q)."""
    base = posed(rig, start)
    reach = np.zeros(len(rig.controls))
    found: dict[int, tuple[Floats, Floats]] = {}
    touching = {shape.channel for mesh in rig.meshes for shape in mesh.shapes}
    bending = {shape.channel for mesh in rig.meshes for shape in mesh.shapes if len(shape.weights) > 1}
    for j, control in enumerate(rig.controls):
        channels = set(control.drive.channels.tolist())
        if not len(control.drive.joints) and touching.isdisjoint(channels):
            continue
        straight = not len(control.drive.joints) and bending.isdisjoint(channels) and len(control.drive.values) == 2
        at = ends(control) if straight else values_along(rig, j)
        points, offsets = paths_around(rig, base, start, j, at)
        if len(points):
            full = np.zeros((len(at), int(rig.starts[-1]), 3))
            full[:, points] = offsets
            mine = full[:, rows]
            steps = np.linalg.norm(np.diff(mine[:, :pulled], axis=0), axis=2)
            reach[j] = float(steps.sum(axis=0).max())
            found[j] = at, mine.reshape(len(at), -1)
    return reach, found


def _additive(rig: Rig, controls: Indices) -> bool:
    """Whether the controls move no joints and share no channel."""
    drives = [rig.controls[j].drive for j in controls.tolist()]
    channels = [channel for drive in drives for channel in drive.channels.tolist()]
    return len(set(channels)) == len(channels) and not any(len(drive.joints) for drive in drives)


def _variables(acting: Flags, twins: Indices | None) -> Indices:
    """(controls,) the variable of each control that takes part, -1 of the others; twins share one.

    A pair takes part if one of the two acts at the pulled points.
    """
    if twins is None:
        return np.asarray(np.where(acting, np.cumsum(acting) - 1, -1), dtype=np.int64)
    variable = np.full(len(acting), -1, dtype=np.int64)
    for j in np.flatnonzero(acting).tolist():
        if variable[j] < 0:
            variable[[j, int(twins[j])]] = variable.max() + 1
    return variable


def _bounds(rig: Rig, start: Floats, ranges: Floats, controls: Indices, variable: Indices) -> tuple[Floats, Floats]:
    """Bounds (variables,) of x: all controls of a variable stay in their ranges, or where they already are."""
    count = int(variable.max(initial=-1)) + 1
    low, high = np.full(count, -np.inf), np.full(count, np.inf)
    for j in controls.tolist():
        control, mine = rig.controls[j], int(variable[j])
        low[mine] = max(low[mine], min((control.minimum - start[j]) / ranges[j], 0.0))
        high[mine] = min(high[mine], max((control.maximum - start[j]) / ranges[j], 0.0))
    return low, high


def _lines_of(
    found: dict[int, tuple[Floats, Floats]],
    controls: Indices,
    start: Floats,
    ranges: Floats,
    variable: Indices,
    rows: int,
) -> Lines:
    """The paths (m, k, rows) of the controls that take part."""
    # A twin may take part without moving the points in hand.
    still = np.array([0.0, 1.0]), np.zeros((2, rows))
    mine = [found.get(j, still) for j in controls.tolist()]
    knots, offsets = [each[0] for each in mine], [each[1] for each in mine]
    return lines(knots, offsets, start[controls], ranges[controls], variable[controls])


def _costs(feel: Feel, reach: Floats, peaks: Floats | None, controls: Indices, variable: Indices) -> Floats:
    """(variables,) ``stay (1 + elsewhere (1 - s)^2)``, added up over the controls of each variable."""
    share = np.ones(len(reach)) if peaks is None else np.minimum(reach / np.maximum(peaks, 1e-300), 1.0)
    each = feel.stay * (1.0 + feel.elsewhere * (1.0 - share[controls]) ** 2)
    return np.bincount(variable[controls], weights=each).astype(np.float64)


# --- solving -----------------------------------------------------------------------------------------


def _row_weights(grip: Grip, toward: ArrayLike | None) -> Floats:
    """(3 q, 3 q) matrix that turns offsets of the points into weighted rows."""
    one = np.eye(3)
    if toward is not None:
        ahead = np.array(toward, dtype=np.float64)
        ahead = ahead / max(float(np.linalg.norm(ahead)), 1e-300)
        one = one - (1.0 - grip.feel.depth) * np.outer(ahead, ahead)
    weights = np.full(len(grip.rows), np.sqrt(grip.feel.pin))
    weights[: grip.pulled] = 1.0
    return np.asarray(np.kron(np.diag(weights), one) / max(grip.length, 1e-300), dtype=np.float64)


def _weighted(paths: Lines, rows: Floats) -> Lines:
    return Lines(paths.knots, paths.offsets @ rows.T, paths.home, paths.span, paths.variable)


def _values(grip: Grip, x: Floats) -> Floats:
    """The pose at x, exactly within the ranges."""
    values = grip.start.copy()
    moved = grip.paths.home + grip.paths.span * x[grip.paths.variable]
    for j, value in zip(grip.controls.tolist(), moved.tolist(), strict=True):
        control = grip.rig.controls[j]
        low, high = min(control.minimum, grip.start[j]), max(control.maximum, grip.start[j])
        values[j] = min(max(value, low), high)
    return values
