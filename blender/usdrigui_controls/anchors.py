"""Every element's anchor in Blender: the evaluated mesh, the bones, the shape keys at one vertex;
and where controls would take any vertex."""

from __future__ import annotations

import numpy as np

from .character import basis_of
from .inbetweens import offsets_at
from .joints import JointFrame
from .maths.handle_track import along
from .tracking import drawing_of, place


class Anchors:
    """The elements of one character, prepared once and asked at every change of the scene."""

    def __init__(self, character):
        self.layout = character.layout
        self.drawings = [
            drawing_of(element, character.controls) for element in self.layout.elements
        ]
        self.bones = {
            path: Bones(character, path, armature) for path, armature in character.armatures.items()
        }
        self.spots = [
            Spot(
                character,
                self.bones,
                element.mesh if element.follows else "",
                element.point,
                [member.control for member in element.members],
                element,
            )
            for element in self.layout.elements
        ]
        self.to_skin = [
            np.linalg.inv(_to_root(self.layout, *each))
            for each in zip(self.spots, self.layout.elements, strict=True)
        ]

    def place(self, depsgraph, values):
        """`Placed` elements at these values of all controls, None for those whose mesh is not
        shown."""
        posed = self.posed()
        return [
            self._place(depsgraph, values, posed, *each)
            for each in zip(self.drawings, self.spots, self.to_skin, strict=True)
        ]

    def posed(self):
        """By skeleton and bone, the pose matrices in armature space."""
        return {path: bones.posed() for path, bones in self.bones.items()}

    def _place(self, depsgraph, values, posed, drawing, spot, to_skin):
        point = spot.shown(depsgraph)
        if point is None and drawing.element.follows:
            return None
        quiet = {name: control.base for name, control in spot.controls.items()}
        anchor, skin = spot.carried(posed, point, values, quiet)
        mine = [values[member.control] for member in drawing.element.members]
        return place(drawing, point, anchor, skin @ to_skin, mine)


class Bones:
    """One armature: rest and base poses in its own space."""

    def __init__(self, character, skeleton, armature):
        self.armature = armature
        rests = character.layout.skeleton(skeleton)
        self.to_root = character.layout.to_root(skeleton)
        bones = armature.data.bones
        self.rest = {bone.name: matrix_of(bone.matrix_local) for bone in bones}
        self.unbound = {name: np.linalg.inv(matrix) for name, matrix in self.rest.items()}
        self.above = {
            bone.name: [each.name for each in (bone, *bone.parent_recursive)] for bone in bones
        }
        self.joints = {each.path: character.bone_name(skeleton, each.path) for each in rests.joints}
        self.frames = {
            self.joints[each.path]: JointFrame(each.bind, each.rest) for each in rests.joints
        }
        self.moves = {name: np.zeros((3, 3)) for name in self.frames}
        for control in character.layout.controls:
            for joint in control.joints:
                if joint.skeleton == skeleton:
                    self.moves[self.joints[joint.joint]] += control.at(joint.moves, control.base)
        self.base = {}
        for name, matrix in self.rest.items():
            line, found = self.above[name], matrix
            if len(line) > 1:
                found = self.base[line[1]] @ self.unbound[line[1]] @ matrix
            if name in self.moves:
                found = found @ composed(*self.frames[name].basis(self.moves[name]))
            self.base[name] = found

    def posed(self):
        """By bone, the pose matrix in armature space."""
        return {bone.name: matrix_of(bone.matrix) for bone in self.armature.pose.bones}

    def move(self, name):
        """(3, 3) the move of the joint of a bone now, as `layout.JointDrive` has them."""
        return self.frames[name].move(*basis_of(self.armature.pose.bones[name]))

    def turned(self, pose, name, move, change):
        """(4, 4) what takes a bone at ``pose`` and all below it along, once a ``change`` (3, 3) is
        added to its ``move``."""
        now, then = (composed(*self.frames[name].basis(each)) for each in (move, move + change))
        return pose[name] @ np.linalg.inv(now) @ then @ np.linalg.inv(pose[name])

    def blend(self, matrices, influences):
        """(4, 4) skinning of weighted bones in armature space."""
        if not influences:
            return np.eye(4)
        total = sum(weight for _, weight in influences)
        return sum(
            weight / total * matrices[name] @ self.unbound[name] for name, weight in influences
        )


class Spot:
    """A vertex of a mesh, or for an ``element`` off the skin what carries it; and where the
    controls of some names take it."""

    def __init__(self, character, bones, path, point, names, element=None):
        self.mesh, self.point = character.meshes.get(path), point
        self.controls = {name: character.controls[name] for name in names}
        self.skeleton = skeleton_of(self.mesh, bones) if self.mesh else element.skeleton
        self.bones = bones.get(self.skeleton)
        self.influences = self._influences(element)
        self.into = self._into()
        self.turning = self._turning()
        self.near = {*self.turning, *(name for name, _ in self.influences)}
        self.keys = {}
        for control in self.controls.values() if self.mesh else ():
            for shape in control.shapes:
                key = character.shape_key(path, shape.token)
                if key is not None:
                    self.keys[shape.token] = (key, *offsets_at(self.mesh, key, point))

    def shown(self, depsgraph):
        """(3,) where Blender has the vertex, in the world; None where its mesh is not shown."""
        if self.mesh is None or not self.mesh.visible_get():
            return None
        mesh = self.mesh.evaluated_get(depsgraph)
        if self.point >= len(mesh.data.vertices):
            return None
        return np.array(mesh.matrix_world @ mesh.data.vertices[self.point].co, dtype=np.float64)

    def carried(self, posed, point, values, to, now=None):
        """(3,) where the skin that is at ``point``, or None off the skin, would be, and (4, 4) its
        map from before skinning to the world, once some controls go from ``values`` to those of
        ``to``, by name; ``posed`` is that of `Anchors` now, and ``now`` the map there."""
        now = self.skin(posed, values, {}) if now is None else now
        turns = any(control.name in to for drives in self.turning.values() for control, _ in drives)
        there = self.skin(posed, values, to) if turns else now
        if point is None:
            return None, there
        before = np.linalg.pinv(now[:3, :3]) @ (point - now[:3, 3]) + self._gained(values, to)
        return there[:3, :3] @ before + there[:3, 3], there

    def skin(self, posed, values, to):
        """(4, 4) its map, as of `carried`."""
        if self.bones is None:
            return matrix_of(self.mesh.matrix_world) if self.mesh else np.eye(4)
        pose = dict(posed[self.skeleton])
        for name, drives in self.turning.items():
            steps = [
                control.step(drive.moves, values[control.name], to[control.name])
                for control, drive in drives
                if control.name in to
            ]
            change = sum(steps, np.zeros((3, 3)))
            if change.any():
                along_it = self.bones.turned(pose, name, self.bones.move(name), change)
                for other in self.near:
                    if name in self.bones.above[other]:
                        pose[other] = along_it @ pose[other]
        world = matrix_of(self.bones.armature.matrix_world)
        return world @ self.bones.blend(pose, self.influences) @ self.into

    def _gained(self, values, to):
        """(3,) what shapes add before skinning."""
        steps = {}
        for name in to:
            control = self.controls[name]
            for shape in control.shapes:
                step = control.step(shape.weights, values[name], to[name])
                steps[shape.token] = steps.get(shape.token, 0.0) + step
        found = np.zeros(3)
        for token in steps.keys() & self.keys.keys():
            key, knots, offsets = self.keys[token]
            found += along(knots, offsets, key.value + steps[token])
            found -= along(knots, offsets, key.value)
        return found

    def _influences(self, element):
        if self.bones is None:
            return ()
        if self.mesh is None:
            named = [(self.bones.joints[joint], weight) for joint, weight in element.carriers]
        else:
            groups = self.mesh.vertex_groups
            mine = self.mesh.data.vertices[self.point].groups
            named = [(groups[each.group].name, each.weight) for each in mine if each.weight]
        return tuple(pair for pair in named if pair[0] in self.bones.rest)

    def _turning(self):
        """Bones above the influences that the controls move, parents first, with (control, drive)
        pairs."""
        found = {}
        if self.bones is not None:
            lines = [self.bones.above[name] for name, _ in self.influences]
            for control in self.controls.values():
                for drive in control.joints:
                    name = self.bones.joints.get(drive.joint)
                    if drive.skeleton == self.skeleton and any(name in line for line in lines):
                        found.setdefault(name, []).append((control, drive))
        return {name: found[name] for name in self.bones.rest if name in found} if found else {}

    def _into(self):
        """The mesh's space to the armature's."""
        if self.bones is None or self.mesh is None:
            return np.eye(4)
        world = matrix_of(self.bones.armature.matrix_world)
        return np.linalg.inv(world) @ matrix_of(self.mesh.matrix_world)


def _to_root(layout, spot, element):
    """Before skinning to root space, in the base pose."""
    if spot.bones is None:
        return layout.to_root(element.mesh)
    return spot.bones.to_root @ spot.bones.blend(spot.bones.base, spot.influences) @ spot.into


def skeleton_of(mesh, bones):
    """The prim path of the armature that deforms a mesh, or empty."""
    used = [
        modifier.object
        for modifier in mesh.modifiers
        if modifier.type == "ARMATURE" and modifier.show_viewport
    ]
    return next((path for path, each in bones.items() if each.armature in used), "")


def matrix_of(matrix):
    """A matrix of Blender's as an array."""
    return np.array(matrix, dtype=np.float64)


def composed(location, rotation, scale):
    """(4, 4) local transform for column vectors."""
    found = np.eye(4)
    found[:3, :3] = rotation * scale
    found[:3, 3] = location
    return found
