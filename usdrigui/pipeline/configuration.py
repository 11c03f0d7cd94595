"""Errors of a configuration that only the asset shows, all of them at once."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from usdrigui.character import Floats, Rig
from usdrigui.conventions import same_name
from usdrigui.errors import Faults, RigUIError, check_known, refuse
from usdrigui.layout.control_overrides import control_index, control_overrides
from usdrigui.layout.group.grouping import check_groups
from usdrigui.layout.place.extensions import check_terms
from usdrigui.layout.place.locality import check_near
from usdrigui.layout.reuse.partial_layout import anchored_point
from usdrigui.layout.symmetry.orbits import check_orbits
from usdrigui.layout.symmetry.twins import configured_twins
from usdrigui.model import Correction, Layout
from usdrigui.pipeline.reference_layouts import check_like
from usdrigui.reader.reader_process import read_rigs_isolated
from usdrigui.reader.reader_records import ReadResult
from usdrigui.settings import Settings, load
from usdrigui.settings.loading import UnsoundSettingsError
from usdrigui.settings.parts import ControlSettings, PartSettings


def refuse_unsound(
    source: ReadResult,
    settings: Settings | None = None,
    like: tuple[tuple[Rig, Layout], ...] = (),
) -> None:
    """Raise RigUIError with all CONFIG_ and GLYPH_ codes of what the configuration asks and the
    asset, or the character to imitate, does not allow; without `settings` of what reading needs.

    What depends on how a control moves is found out later, and so is which elements there are.
    """
    faults = Faults()
    faults.add(source.config_faults)
    if settings is not None:
        with faults.collected():
            check_terms(settings.objective.terms)
        for rig in source.rigs:
            _check_rig(rig, settings, like, faults)
        _check_parts(source.rigs, settings.parts, faults)
    faults.raise_all()


def with_faults_of_asset(error: UnsoundSettingsError, asset: Path) -> RigUIError:
    """The error with what the valid part of the configuration asks and `asset` does not allow, as
    far as that can be read."""
    try:
        source = read_rigs_isolated(asset, error.sound)
    except RigUIError:
        return error
    try:
        refuse_unsound(source, error.sound)
    except RigUIError as more:
        return RigUIError(error.issue, error.exit_code, (*error.others, *more.issues))
    return error


def with_corrections(
    settings: Settings, corrections: Sequence[Correction], rigs: Sequence[Rig]
) -> Settings:
    """The settings with those of corrections of controls that the rigs have by these names, or by
    another spelling; what the settings say is stronger.  Raises UnsoundSettingsError."""
    names, plain = tuple({name for rig in rigs for name in rig.control_names}), ControlSettings()
    controls, groups = dict(settings.controls), dict(settings.groups.groups)
    for each in corrections:
        name = same_name(each.control, names)
        if name and each.settings:
            own = controls.get(name, plain)
            said = load({"controls": {name: each.settings}}).controls[name]
            unsaid = [key for key in each.settings if getattr(own, key) == getattr(plain, key)]
            controls[name] = replace(own, **{key: getattr(said, key) for key in unsaid})
        members = tuple(member for member in each.group if member in names)
        if len(members) > 1 and not {*members} & {*itertools.chain(*groups.values())}:
            groups["_".join(members)] = members
    return replace(settings, controls=controls, groups=replace(settings.groups, groups=groups))


def base_values_of(rig: Rig, pose: Mapping[str, float]) -> Floats:
    """(controls,) the base pose (paper: P).  Raises CONFIG_UNKNOWN_CONTROL for what ``read.pose``
    names and the rig lacks."""
    index, values = rig.control_indices, rig.defaults
    faults = Faults()
    for name, value in pose.items():
        with faults.collected():
            check_known(name, index, f'read.pose."{name}"', f"{rig.path} has no control")
            values[index[name]] = value
    faults.raise_all()
    return values


def _check_rig(
    rig: Rig,
    settings: Settings,
    like: tuple[tuple[Rig, Layout], ...],
    faults: Faults,
) -> None:
    controls = settings.controls
    index = control_index(rig, controls)
    view = settings.candidates.view
    with faults.collected():
        if view.startswith("/") and rig.camera is None:
            raise refuse("CONFIG_VALUE", "candidates.view", f"there is no camera {view}")
    with faults.collected():
        base_values_of(rig, settings.read.pose)
    for name in (each for each in controls if each in index):
        _check_places(rig, settings.controls, name, faults)
    with faults.collected():
        configured_twins(rig, controls)
    with faults.collected():
        check_orbits(rig.controls, control_overrides(rig, controls), index)
    with faults.collected():
        # A fault of a pose is reported once, for the pose.
        check_groups(settings.groups.groups, {*rig.control_names, *settings.poses})
    with faults.collected():
        check_like(like, rig, settings.like.names)


def _check_places(
    rig: Rig, settings: Mapping[str, ControlSettings], name: str, faults: Faults
) -> None:
    """Collect what is wrong with the places that the configuration gives one control."""
    override, where = settings[name], f'controls."{name}"'
    for key, anchor in (("anchor", override.anchor), ("inner_anchor", override.inner_anchor)):
        if anchor:
            with faults.collected():
                anchored_point(rig, f"{where}.{key}", anchor)
    if override.near:
        with faults.collected():
            check_near(rig, f"{where}.near", override.near)


def _check_parts(rigs: Sequence[Rig], settings: PartSettings, faults: Faults) -> None:
    """Collect CONFIG_UNKNOWN_CONTROL for names of ``[parts.controls]`` that no rig knows."""
    known = {name for rig in rigs for name in rig.control_names}
    known |= {left.control for rig in rigs for left in rig.left_off}
    for name in settings.controls:
        with faults.collected():
            check_known(
                name, known, f'parts.controls."{name}"', "no rig of the asset has a control"
            )
