"""Every element's anchor in Blender: the evaluated mesh, the bones, the shape keys at one
vertex."""

from __future__ import annotations

import numpy as np

from .inbetweens import offsets_at
from .joints import drive_at
from .tracking import AnchorFrame, drawing_of, place


class Anchors:
    """The elements of one character, prepared once and asked at every change of the scene."""

    def __init__(self, character):
        layout = character.layout
        self.elements = layout.elements
        self.drawings = [drawing_of(element, character.controls) for element in layout.elements]
        self.bones = {
            path: _Bones(character, path, armature)
            for path, armature in character.armatures.items()
        }
        self.bindings = [
            _AnchorBinding(character, self.bones, element) for element in layout.elements
        ]

    def place(self, character, depsgraph, values):
        """`Placed` elements, None for those whose mesh is not shown."""
        posed = {path: bones.posed() for path, bones in self.bones.items()}
        evaluated = {}
        return [
            self._place(character, depsgraph, values, posed, evaluated, index)
            for index in range(len(self.elements))
        ]

    def _place(self, character, depsgraph, values, posed, evaluated, index):
        element, drawing, binding = self.elements[index], self.drawings[index], self.bindings[index]
        point = None
        if element.follows:
            mesh = character.meshes.get(element.mesh)
            if mesh is None or not mesh.visible_get():
                return None
            if element.mesh not in evaluated:
                evaluated[element.mesh] = mesh.evaluated_get(depsgraph)
            shown = evaluated[element.mesh]
            if element.point >= len(shown.data.vertices):
                return None
            point = np.array(
                shown.matrix_world @ shown.data.vertices[element.point].co, dtype=np.float64
            )
        mine = np.array([values[member.control] for member in element.members])
        return place(drawing, binding.frame(posed, point, values), mine)


class _Bones:
    """One armature: rest and base poses in its own space."""

    def __init__(self, character, skeleton, armature):
        self.armature = armature
        rests = next(each for each in character.layout.skeletons if each.path == skeleton)
        self.to_root = np.array(rests.to_root).T
        bones = armature.data.bones
        self.names = [bone.name for bone in bones]
        self.rest = {bone.name: _matrix(bone.matrix_local) for bone in bones}
        self.unbound = {name: np.linalg.inv(matrix) for name, matrix in self.rest.items()}
        self.parents = {bone.name: bone.parent.name if bone.parent else "" for bone in bones}
        self.joints = {each.path: character.bone_name(skeleton, each.path) for each in rests.joints}
        self.frames = {
            name: character.frame(skeleton, joint) for joint, name in self.joints.items()
        }
        self.base_bases = self._base_bases(character, skeleton)
        self.base = {}
        for name in self.names:
            parent = self.parents[name]
            local = self.unbound[parent] @ self.rest[name] if parent else self.rest[name]
            above = self.base[parent] if parent else np.eye(4)
            self.base[name] = above @ local @ self.base_bases.get(name, np.eye(4))

    def posed(self):
        """By bone, the pose matrix in armature space and the bone's own basis."""
        return {
            bone.name: (_matrix(bone.matrix), _matrix(bone.matrix_basis))
            for bone in self.armature.pose.bones
        }

    def without(self, name, drives, values):
        """(4, 4) the basis of a bone with some controls in the base pose; ``drives`` are (control,
        drive) pairs."""
        frame, move = self.frames[name], self.armature.pose.bones[name].matrix_basis.decompose()
        found = frame.move(np.array(move[0]), np.array(move[1].to_matrix()), np.array(move[2]))
        for control, drive in drives:
            for row, table in enumerate((drive.rotations, drive.translations, drive.scales)):
                value = drive_at(control.keys, table, values[control.name])
                found[row] -= value - drive_at(control.keys, table, control.base)
        return _composed(*frame.basis(found))

    def _base_bases(self, character, skeleton):
        moves = {name: np.zeros((3, 3)) for name in self.frames}
        for control in character.layout.controls:
            for joint in control.joints:
                if joint.skeleton == skeleton:
                    tables = (joint.rotations, joint.translations, joint.scales)
                    name = self.joints[joint.joint]
                    moves[name] = moves[name] + [
                        drive_at(control.keys, table, control.base) for table in tables
                    ]
        return {name: _composed(*frame.basis(moves[name])) for name, frame in self.frames.items()}

    def blend(self, matrices, influences):
        """(4, 4) skinning of weighted bones in armature space."""
        if not influences:
            return np.eye(4)
        total = sum(weight for _, weight in influences)
        return sum(
            weight / total * matrices[name] @ self.unbound[name] for name, weight in influences
        )

    def below(self, name, top):
        """Whether a bone is ``top`` or hangs on it."""
        while name and name != top:
            name = self.parents[name]
        return name == top

    def depth(self, name):
        """How many bones there are from a bone to its root."""
        count = 0
        while name:
            name, count = self.parents[name], count + 1
        return count


class _AnchorBinding:
    """What one element's anchor hangs on."""

    def __init__(self, character, bones, element):
        mesh = character.meshes.get(element.mesh) if element.follows else None
        self.own = _own_shapes(character, mesh, element) if mesh else ()
        self.target = mesh
        self.skeleton = _skeleton(mesh, bones) if mesh else element.skeleton
        self.bones = bones.get(self.skeleton)
        self.influences = self._influences(element)
        self.own_bones = self._own_bones(character, element)
        self.into = self._into()
        self.rest = np.linalg.inv(self._to_root(character, element))

    def frame(self, posed, point, values):
        """`Site` with the bones' ``posed`` matrices, the deformed ``point`` (3,) or None, and all
        values."""
        own = sum((shape.now(values) for shape in self.own), np.zeros(3))
        if self.bones is None:
            world = _matrix(self.target.matrix_world) if self.target else np.eye(4)
            return AnchorFrame(point, own, world, world, self.rest)
        pose = {name: matrix for name, (matrix, _) in posed[self.skeleton].items()}
        now = self._skinned(pose)
        if self.own_bones:
            still = self._skinned(self._without_own(posed[self.skeleton], values))
            return AnchorFrame(point, own, now, still, self.rest)
        return AnchorFrame(point, own, now, now, self.rest)

    def _skinned(self, pose):
        return (
            _matrix(self.bones.armature.matrix_world)
            @ self.bones.blend(pose, self.influences)
            @ self.into
        )

    def _without_own(self, posed, values):
        """Pose matrices with the element's own controls in the base pose."""
        pose = {name: matrix for name, (matrix, _) in posed.items()}
        for own, drives in self.own_bones.items():
            basis = posed[own][1]
            quiet = self.bones.without(own, drives, values)
            back = pose[own] @ np.linalg.inv(basis) @ quiet @ np.linalg.inv(pose[own])
            for name in pose:
                if self.bones.below(name, own):
                    pose[name] = back @ pose[name]
        return pose

    def _influences(self, element):
        if self.bones is None:
            return ()
        if not element.follows:
            named = [(self.bones.joints[joint], weight) for joint, weight in element.carriers]
            return tuple(pair for pair in named if pair[0] in self.bones.rest)
        groups = self.target.vertex_groups
        vertex = self.target.data.vertices[element.point]
        named = [(groups[each.group].name, each.weight) for each in vertex.groups]
        return tuple((name, weight) for name, weight in named if weight and name in self.bones.rest)

    def _own_bones(self, character, element):
        """Bones that the element's own controls move, parents first, with (control, drive)
        pairs."""
        found = {}
        for member in element.members:
            control = character.controls[member.control]
            for drive in control.joints:
                if drive.skeleton == self.skeleton and self.bones is not None:
                    name = self.bones.joints[drive.joint]
                    if name in self.bones.rest:
                        found.setdefault(name, []).append((control, drive))
        return {
            name: found[name]
            for name in sorted(found, key=lambda name: (self.bones.depth(name), name))
        }

    def _into(self):
        """The mesh's space to the armature's."""
        if self.bones is None or self.target is None:
            return np.eye(4)
        return np.linalg.inv(_matrix(self.bones.armature.matrix_world)) @ _matrix(
            self.target.matrix_world
        )

    def _to_root(self, character, element):
        """Before skinning to root space, in the base pose."""
        if self.bones is None:
            rest = next(
                (each for each in character.layout.meshes if each.path == element.mesh), None
            )
            return np.array(rest.to_root).T if rest else np.eye(4)
        return self.bones.to_root @ self.bones.blend(self.bones.base, self.influences) @ self.into


class _OwnShape:
    """What one token adds to one vertex, as far as the element's own controls account for it."""

    def __init__(self, controls, key, knots, offsets):
        self.controls = controls
        self.key = key
        self.knots = knots
        self.offsets = offsets

    def now(self, values):
        share = sum(
            contribution(control, shape, values[control.name]) for control, shape in self.controls
        )
        whole = self.key.value
        return drive_at(self.knots, self.offsets, whole) - drive_at(
            self.knots, self.offsets, whole - share
        )


def contribution(control, shape, value):
    """What a control at ``value`` adds to the weight of a token over the base pose."""
    if control.plain:
        return value - control.base
    return drive_at(control.keys, shape.weights, value) - drive_at(
        control.keys, shape.weights, control.base
    )


def _own_shapes(character, mesh, element):
    tokens = {}
    for member in element.members:
        control = character.controls[member.control]
        for shape in control.shapes:
            tokens.setdefault(shape.token, []).append((control, shape))
    found = {token: character.shape_key(element.mesh, token) for token in tokens}
    return tuple(
        _OwnShape(tokens[token], key, *offsets_at(mesh, key, element.point))
        for token, key in found.items()
        if key is not None
    )


def _skeleton(mesh, bones):
    """The prim path of the armature that deforms a mesh, or empty."""
    used = [
        modifier.object
        for modifier in mesh.modifiers
        if modifier.type == "ARMATURE" and modifier.show_viewport
    ]
    return next((path for path, each in bones.items() if each.armature in used), "")


def _matrix(matrix):
    return np.array(matrix, dtype=np.float64)


def _composed(location, rotation, scale):
    """(4, 4) local transform for column vectors."""
    found = np.eye(4)
    found[:3, :3] = rotation * scale
    found[:3, 3] = location
    return found
