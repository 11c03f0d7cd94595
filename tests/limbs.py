"""Characters driven by joints alone, as `Rig` records: tubes of skin along chains of joints."""

from dataclasses import replace

import makers
import numpy as np

from usdrigui.character import Control, Joint, Skeleton, Skin
from usdrigui.character.rotation import rotations
from usdrigui.reading.control import control_of, default_joint_drafts

_AROUND = 12
_RINGS = 8


def chain_rig(bones=3, length=1.0, radius=0.15, late=0.0):
    """A tube of `bones` bones from the origin, each of a joint; the weight passes to the next joint `late` bones beyond
    it, over a fifth of a bone on either side; every joint has a control of each axis, ``j0:rx`` and so on."""
    rings = np.linspace(0.0, bones * length, bones * _RINGS + 1)
    angles = np.linspace(0.0, 2.0 * np.pi, _AROUND, endpoint=False)
    circle = radius * np.stack([np.cos(angles), np.zeros(_AROUND), np.sin(angles)], axis=1)
    points = np.concatenate([circle + np.array([0.0, along, 0.0]) for along in rings])
    ring, corner = np.divmod(np.arange((len(rings) - 1) * _AROUND), _AROUND)
    beside = ring * _AROUND + (corner + 1) % _AROUND
    here = ring * _AROUND + corner
    faces = np.stack([here, here + _AROUND, beside + _AROUND, beside], axis=1)
    weights = _weights(points[:, 1] / length - late, bones)
    skin = Skin(np.tile(np.arange(bones), (len(points), 1)), weights, "classicLinear", np.eye(4), False)
    mesh = makers.mesh(points, faces, skin=skin)
    joints = tuple(_joint(i, length) for i in range(bones))
    controls = tuple(_control(i, axis) for i in range(bones) for axis in range(3))
    made = makers.rig_of_meshes([mesh], [])
    return makers.changed(made, joints=joints, skeletons=(Skeleton("/Root/skel", "", np.eye(4)),), controls=controls)


def _weights(along, bones):
    """(n, bones) weights of points `along` a chain, in bones."""
    rise = [np.clip((along - i + 0.2) / 0.4, 0.0, 1.0) if i else np.ones(len(along)) for i in range(bones)]
    return np.stack([rise[i] - (rise[i + 1] if i + 1 < bones else 0.0) for i in range(bones)], axis=1)


def _joint(index, length):
    local, world = np.eye(4), np.eye(4)
    local[3, 1], world[3, 1] = length * (index > 0), length * index
    return Joint("/".join(f"j{i}" for i in range(index + 1)), 0, index - 1, world, local, local)


def _control(joint, axis):
    turns = np.zeros((2, 1, 3))
    turns[:, 0, axis] = np.radians([-30.0, 30.0])
    drive = makers.drive(values=(-30.0, 30.0), joints=[joint], turns=turns)
    name = f"j{joint}:r{'xyz'[axis]}"
    return Control(name, name, "joint", f"j{joint}", -30.0, 0.0, 30.0, "default", drive)


def hand_rig():
    """A wrist at the origin with four fingers along y, each of three joints and an end without skin, a little bent
    towards z, which is the palm."""
    names, places = ["w"], [np.zeros(3)]
    for finger in range(4):
        x = 0.3 * (finger - 1.5)
        for number, at in enumerate([(x, 1.0, 0.0), (x, 1.5, 0.02), (x, 1.85, 0.07), (x, 2.1, 0.14)]):
            names.append("w/" + "/".join(f"f{finger}{k}" for k in range(number + 1)))
            places.append(np.array(at))
    return skeleton_rig(names, np.array(places), [i for i, name in enumerate(names) if not name.endswith("3")])


def body_rig():
    """Hips, a chest, a head, straight arms a and b along x, straight legs c and d down, with ends without skin."""
    at = {"h": (0, 0, 0), "h/s": (0, 0.5, 0), "h/s/n": (0, 1.0, 0), "h/s/n/e": (0, 1.4, 0)}
    for side, (arm, leg) in ((1, "ac"), (-1, "bd")):
        hang(at, "h/s", arm, [(side * x, 0.9, 0) for x in (0.25, 0.85, 1.4, 1.6)])
        hang(at, "h", leg, [(side * 0.2, y, 0) for y in (-0.1, -0.9, -1.7, -1.9)])
    names, places = by_depth(at)
    owners = [i for i, name in enumerate(names) if name[-1] not in "e3"]
    return skeleton_rig(names, places, owners)


def twisted_body(twists):
    """The body with skin on the ends of arms and legs too; their other skin, of `twists`, on two twist joints of each
    bone: ``beside`` or ``below`` each other."""
    at = {joint.path: joint.bind[3, :3] for joint in body_rig().body.joints}
    limbs = [path for path in at if twists and path[-2:] in {x + y for x in "abcd" for y in "01"}]
    for path in limbs:
        bone = at[f"{path}/{path[-2]}{int(path[-1]) + 1}"] - at[path]
        at[f"{path}/t"] = at[path] + 0.05 * bone
        at[f"{path}/t/u" if twists == "below" else f"{path}/u"] = at[path] + 0.5 * bone
    names, places = by_depth(at)
    owners = [i for i, name in enumerate(names) if name[-1] != "e" and name not in limbs]
    return skeleton_rig(names, places, owners)


def hang(at, path, name, places):
    """Add joints `name`0, `name`1 and on at `places`, each below the one before, to those `at` the joint `path`; the
    path of the last."""
    for number, place in enumerate(places):
        path += f"/{name}{number}"
        at[path] = place
    return path


def by_depth(at):
    """Paths of joints, those above others first, and their places."""
    names = sorted(at, key=lambda path: (path.count("/"), path))
    return names, np.array([at[name] for name in names], float)


def skeleton_rig(names, places, owners=None, own=None, size=None):
    """Joints at `places` with a small box of skin, of half an edge `size`, around each owner, or around all."""
    owners = range(len(names)) if owners is None else owners
    size = np.full(len(owners), 0.05) if size is None else np.array(size)
    parents = [names.index(name.rpartition("/")[0]) if "/" in name else -1 for name in names]
    frame = np.eye(3) if own is None else own
    world = [np.block([[frame, np.zeros((3, 1))], [place[None], np.ones((1, 1))]]) for place in places]
    joints = tuple(_placed(name, world, i, parents[i]) for i, name in enumerate(names))
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    sides = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    points = np.concatenate([places[i] + half * corners for i, half in zip(owners, size, strict=True)])
    faces = np.concatenate([sides + 8 * k for k in range(len(owners))])
    influences = np.repeat(np.array(owners), 8)[:, None]
    skin = Skin(influences, np.ones(influences.shape), "classicLinear", np.eye(4), False)
    mesh = makers.mesh(points, faces, skin=skin)
    made = makers.rig_of_meshes([mesh], [])
    return makers.changed(made, joints=joints, skeletons=(Skeleton("/Root/skel", "", np.eye(4)),))


def _placed(name, world, index, parent):
    local = world[index] @ np.linalg.inv(world[parent]) if parent >= 0 else world[index]
    return Joint(name, 0, parent, world[index], local, local)


def flattened(rig, aim_sign=1.0, wrist=0.0):
    """The same with every joint a root that looks along its bone, as some hands are exported: along its own z, or
    against it; the wrist looks `wrist` radians beside its bone."""
    joints = []
    for i, joint in enumerate(rig.body.joints):
        below = [each for each in rig.body.joints if each.parent == i]
        along = (below[len(below) // 2].bind if below else joint.bind)[3, :3] - joint.bind[3, :3]
        along = along if below else joint.bind[3, :3] - rig.body.joints[joint.parent].bind[3, :3]
        beside = rotations(np.array([0.0, 0.0, wrist * (joint.parent < 0)]))
        aim = aim_sign * (along / np.linalg.norm(along)) @ beside
        side = np.cross(aim, [0.0, 0.6, 0.8])
        side /= np.linalg.norm(side)
        world = np.eye(4)
        world[:3, :3], world[3, :3] = np.stack([side, np.cross(aim, side), aim]), joint.bind[3, :3]
        joints.append(Joint(joint.path.rsplit("/", 1)[-1], 0, -1, world, world, world))
    return makers.changed(rig, joints=tuple(joints))


def moved(rig, turn, scale, own):
    """The same under a rotation and a scale, its joints with other axes of their own."""
    names = [joint.path for joint in rig.body.joints]
    places = np.array([joint.bind[3, :3] for joint in rig.body.joints]) @ turn * scale
    made = skeleton_rig(names, places, sorted(set(rig.body.meshes[0].skin.joints.ravel().tolist())), own)
    points = rig.body.meshes[0].points @ turn * scale
    return makers.changed(made, meshes=(replace(made.body.meshes[0], points=points),))


def as_control(draft):
    """The control of a draft as it stands."""
    return control_of(draft, draft.name, draft.name, draft.range)


def whole_body(ahead=1.0, head="Head", bare=(), strands=None):
    """Hips, spine and neck, a head called `head` with nine small joints on its front, which lies `ahead` along z, arms
    with hands of four fingers, and legs; with the controls that its joints have by default.  No other name says what it
    is of.  Joints whose names end in one of `bare` have no skin.  Three `strands` hang on a joint: its path, their name
    and the way along each bone."""
    at = {"h": (0, 0, 0), "h/s": (0, 0.4, 0), "h/s/t": (0, 0.8, 0), "h/s/t/n": (0, 1.32, 0)}
    at[f"h/s/t/n/{head}"] = (0, 1.4, 0)
    for k, (x, y) in enumerate((x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)):
        at[f"h/s/t/n/{head}/k{k}"] = (0.08 * x, 1.5 + 0.08 * y, ahead * (0.12 - 0.02 * abs(x)))
    for side, name in ((1, "a"), (-1, "b")):
        hand = hang(at, "h/s/t", name, [(side * x, 0.9, 0) for x in (0.25, 0.85, 1.4)])
        for finger in range(4):
            z = 0.04 * (finger - 1.5)
            hang(at, hand, f"{name}f{finger}", [(side * x, 0.9, z) for x in (1.5, 1.56, 1.61, 1.65)])
        hang(at, "h", f"{name}l", [(side * 0.2, y, 0) for y in (-0.1, -0.9, -1.7)])
    if strands is not None:
        path, name, way = strands
        for k in range(3):
            start = at[path] + np.array([0.0, 0.0, 0.02 * k])
            hang(at, path, f"{name}{k}_", [start + n * np.array(way) for n in (1, 2, 3)])
    names, places = by_depth(at)
    ends = {name for name in names if "f" in name.rpartition("/")[2] and name[-1] == "3"}
    owners = [i for i, name in enumerate(names) if name not in ends and name[-2:] not in bare]
    made = skeleton_rig(names, places, owners, size=_sizes(names, owners))
    return with_default_controls(made)


def with_shapes(rig, shapes):
    """The same with blend shapes before its controls of joints: names to dense offsets (n, 3)."""
    mesh, *others = rig.body.meshes
    shaped = makers.rig(mesh.points, [], shapes)
    own = replace(shaped.body.meshes[0], topology=mesh.topology, skin=mesh.skin)
    body = replace(shaped.body, meshes=(own, *others), joints=rig.body.joints, skeletons=rig.body.skeletons)
    return replace(shaped, body=body, controls=shaped.controls + rig.controls)


def smiling(rig):
    """The same with a blend shape: the head moves ahead, the back of it a little more."""
    _, y, z = rig.body.meshes[0].points.T
    return with_shapes(rig, {"smile": np.outer(np.where(y > 1.4, 0.05 - 0.02 * z, 0.0), [0.0, 0.0, 1.0])})


def resting(rig, turns):
    """The same character, bound as before, with joints at rest turned by `turns` (rotation vectors) by their names."""
    joints = []
    turned = rotations(np.array([turns.get(joint.name, (0.0, 0.0, 0.0)) for joint in rig.body.joints]))
    for joint, turn in zip(rig.body.joints, turned, strict=True):
        local = joint.rest.copy()
        local[:3, :3] = turn @ local[:3, :3]
        joints.append(replace(joint, rest=local, base=local))
    return makers.changed(rig, joints=tuple(joints))


def anyhow(rig, seed):
    """The same with every joint turned by up to half a radian."""
    turns = np.random.default_rng(seed).uniform(-0.5, 0.5, (len(rig.body.joints), 3))
    return resting(rig, {joint.name: turn for joint, turn in zip(rig.body.joints, turns, strict=True)})


def _sizes(names, owners):
    """Half the edge of each owner's box: small on the face and the fingers."""
    return [0.008 if names[i].count("/") > 4 else 0.05 for i in owners]


def with_default_controls(rig):
    """The rig with the controls that its joints have by default."""
    return replace(rig, controls=tuple(map(as_control, default_joint_drafts(rig.body, None, (), {}))))
