"""Characters driven by joints alone, as `Rig` records: tubes of skin along chains of joints."""

from __future__ import annotations

from dataclasses import replace

import makers
import numpy as np

from usdrigui.model import Control, Drive, Joint, Skeleton, Skin

_AROUND = 12
_RINGS = 8


def chain_rig(bones=3, length=1.0, radius=0.15):
    """A tube of `bones` bones from the origin, each of a joint; the weight passes to the next joint halfway, over a
    fifth of a bone on either side; every joint has a control of each axis, ``j0:rx`` and so on."""
    rings = np.linspace(0.0, bones * length, bones * _RINGS + 1)
    angles = np.linspace(0.0, 2.0 * np.pi, _AROUND, endpoint=False)
    circle = radius * np.stack([np.cos(angles), np.zeros(_AROUND), np.sin(angles)], axis=1)
    points = np.concatenate([circle + np.array([0.0, along, 0.0]) for along in rings])
    ring, corner = np.divmod(np.arange((len(rings) - 1) * _AROUND), _AROUND)
    beside = ring * _AROUND + (corner + 1) % _AROUND
    here = ring * _AROUND + corner
    faces = np.stack([here, here + _AROUND, beside + _AROUND, beside], axis=1)
    weights = _weights(points[:, 1] / length, bones)
    skin = Skin(np.tile(np.arange(bones), (len(points), 1)), weights, "classicLinear", np.eye(4), False)
    mesh = makers.mesh(points, faces, skin=skin)
    joints = tuple(_joint(i, length) for i in range(bones))
    controls = tuple(_control(i, axis) for i in range(bones) for axis in range(3))
    made = makers.rig_of_meshes([mesh], [])
    return replace(made, joints=joints, skeletons=(Skeleton("/Root/skel", "", np.eye(4)),), controls=controls)


def _weights(along, bones):
    """(n, bones) weights of points `along` a chain, in bones."""
    rise = [np.clip((along - i + 0.2) / 0.4, 0.0, 1.0) if i else np.ones(len(along)) for i in range(bones)]
    return np.stack([rise[i] - (rise[i + 1] if i + 1 < bones else 0.0) for i in range(bones)], axis=1)


def _joint(index, length):
    local, world = np.eye(4), np.eye(4)
    local[3, 1], world[3, 1] = length * (index > 0), length * index
    return Joint("/".join(f"j{i}" for i in range(index + 1)), 0, index - 1, world, local, local)


def _control(joint, axis):
    turns, still = np.zeros((2, 1, 3)), np.zeros((2, 1, 3))
    turns[:, 0, axis] = np.radians([-30.0, 30.0])
    indices, nothing = np.array([joint]), np.zeros(0, dtype=np.int64)
    drive = Drive(np.array([-30.0, 30.0]), nothing, np.zeros((2, 0)), indices, turns, still, still)
    name = f"j{joint}:r{'xyz'[axis]}"
    return Control(name, name, "joint", f"j{joint}", -30.0, 0.0, 30.0, "default", drive)
