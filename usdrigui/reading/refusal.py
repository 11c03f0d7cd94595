"""Why nothing of a stage, or of a character, can be laid out: refusals with what would help."""

from __future__ import annotations

from dataclasses import dataclass

from pxr import Usd

from usdrigui.character import LeftOff, Rig
from usdrigui.errors import Faults, Issue, RigUIError, issue, listed, meant, of_character, refuse
from usdrigui.reading.control import joint_names, names_in_configuration
from usdrigui.settings import Settings
from usdrigui.stages.schema import SCOPE


@dataclass(frozen=True)
class Reading:
    """A rig and what only refusals tell of it."""

    rig: Rig
    known: frozenset[str]
    """The names that the configuration may use for its controls."""
    bound_in_vain: tuple[Issue, ...]
    """Meshes with joint influences that no Skeleton moves although one is named."""
    faults: tuple[RigUIError, ...]
    """Why parts were left off."""


def without_controls(stage: Usd.Stage, readings: list[Reading]) -> RigUIError:
    """Why none of some characters has anything to control."""
    broken = [fault for reading in readings for fault in reading.faults]
    if broken:
        return broken[0]
    lost = [dropped for reading in readings for dropped in reading.rig.left_off]
    reasons = tuple({dropped.reason for dropped in lost})
    bound = [finding for reading in readings for finding in reading.bound_in_vain]
    vain = [finding for finding in bound if not finding.message.endswith(reasons)]
    off = "".join(_inactive_clause(stage, reading.rig.path) for reading in readings)
    first = f"; {vain[0].path} {vain[0].message}" if vain else ""
    why = f"{_lost_clause(lost)}{first}{off}" or _joints_clause(readings[0])
    meshes = any(reading.rig.body.meshes for reading in readings)
    what = "no blend shape, animated joint or named pose" if meshes else "no mesh to move"
    return refuse("CONTROLS_MISSING", readings[0].rig.path, f"{what}{why}")


def why_lost(stage: Usd.Stage, readings: list[Reading]) -> tuple[Issue, ...]:
    """Why characters that are laid out have nothing to control."""
    found = []
    for reading in readings:
        root = reading.rig.path
        if not reading.rig.body.meshes:
            what = f"none of its meshes is left{_inactive_clause(stage, root)}"
            found.append(issue("LAYOUT_MESH_GONE", root, what, root))
        elif not reading.rig.controls:
            found += of_character(root, without_controls(stage, [reading]).issues)
    return tuple(found)


def check_names(readings: list[Reading], settings: Settings, faults: Faults) -> None:
    """Collect CONFIG_UNKNOWN_CONTROL for names in the configuration that no rig knows."""
    known = frozenset[str]().union(*(reading.known for reading in readings))
    controls = [control.name for reading in readings for control in reading.rig.controls]
    unknown = [
        (f'controls."{name}"', f"no rig of the asset has this control{meant(name, controls)}")
        for name in settings.controls
        if name not in known
    ]
    bodies = [reading.rig.body for reading in readings]
    joints = [joint for body in bodies for joint in body.joints]
    for name in settings.joints:
        if not any(name in names_in_configuration(body.joints) for body in bodies):
            spellings = (*(joint.name for joint in joints), *(joint.path for joint in joints))
            hint = meant(name, spellings) or "".join(map(_joints_clause, readings))
            unknown.append((f'joints."{name}"', f"no rig of the asset has this joint{hint}"))
    faults.add([issue("CONFIG_UNKNOWN_CONTROL", where, what) for where, what in unknown])


def _joints_clause(reading: Reading) -> str:
    """A clause with the names of the first joints of a rig, empty if it has none."""
    names = joint_names(reading.rig.body.joints)
    return f"; {reading.rig.path} has the joints {listed(names)}" if names else ""


def _lost_clause(lost: list[LeftOff]) -> str:
    """A clause with the reasons for which everything was left off, and how many controls share
    each; empty if none."""
    names: dict[str, list[str]] = {}
    for dropped in lost:
        names.setdefault(dropped.reason, []).append(dropped.control)
    reasons = [f"{listed(same)} ({reason})" for reason, same in names.items()]
    return f"; left off: {listed(reasons)}" if reasons else ""


def _inactive_clause(stage: Usd.Stage, root: str) -> str:
    """A clause with the prims below a SkelRoot that are not active; empty if none."""
    walk = Usd.PrimRange(stage.GetPrimAtPath(root), Usd.PrimAllPrimsPredicate)
    off = [str(prim.GetPath()) for prim in walk if not prim.IsActive() and prim.GetName() != SCOPE]
    return f"; not active: {listed(off)}" if off else ""
