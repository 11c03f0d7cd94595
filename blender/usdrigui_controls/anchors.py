"""Where the elements are in Blender: the evaluated place, bones and shape keys of one vertex."""

from __future__ import annotations

import numpy as np

from .character import basis_of
from .inbetweens import offsets_at
from .layout import gained
from .maths.handle_track import along
from .tracking import drawing_of, place


class Anchors:
    """The elements of one character, prepared once and asked at every change of the scene."""

    def __init__(self, character):
        self.layout = character.layout
        self.bones = {
            path: Bones(character, path, armature) for path, armature in character.armatures.items()
        }
        self.spots = [Spot(character, self.bones, each) for each in self.layout.elements]

    def place(self, depsgraph, values):
        """`Placed` elements at these values of all controls, None for those whose mesh is not
        shown."""
        posed = {path: bones.posed() for path, bones in self.bones.items()}
        return [spot.place(depsgraph, posed, values) for spot in self.spots]


class Bones:
    """One armature: rest and base poses in its own space."""

    def __init__(self, character, skeleton, armature):
        layout, self.armature = character.layout, armature
        self.to_root = layout.to_root(skeleton)
        bones = armature.data.bones
        self.rest = {bone.name: matrix_of(bone.matrix_local) for bone in bones}
        self.unbound = {name: np.linalg.inv(matrix) for name, matrix in self.rest.items()}
        self.above = {
            bone.name: [each.name for each in (bone, *bone.parent_recursive)] for bone in bones
        }
        self.joints = {
            character.bone_name(*each): each for each in layout.frames if each[0] == skeleton
        }
        self.frames = layout.frames
        still = {control.name: control.default for control in layout.controls}
        base = {control.name: control.base for control in layout.controls}
        _, moves = gained(layout.controls, still, base)
        self.base = {}
        for name, matrix in self.rest.items():
            line, found = self.above[name], matrix
            if len(line) > 1:
                found = self.base[line[1]] @ self.unbound[line[1]] @ matrix
            joint = self.joints.get(name)
            if joint:
                found = found @ composed(*self.frames[joint].basis(moves[joint]))
            self.base[name] = found

    def posed(self):
        """By bone, the pose matrix in armature space."""
        return {bone.name: matrix_of(bone.matrix) for bone in self.armature.pose.bones}

    def turned(self, pose, name, change):
        """(4, 4) what takes a bone at ``pose`` and all below it along, once a ``change`` (3, 3) is
        added to its move."""
        frame = self.frames[self.joints[name]]
        move = frame.move(*basis_of(self.armature.pose.bones[name]))
        now, then = (composed(*frame.basis(each)) for each in (move, move + change))
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
    """One element: the vertex that it follows, or what carries it off the skin."""

    def __init__(self, character, bones, element):
        self.drawing, self.point = drawing_of(element, character.controls), element.point
        self.controls = [character.controls[member.control] for member in element.members]
        self.base = {control.name: control.base for control in self.controls}
        self.mesh = character.meshes.get(element.mesh) if element.follows else None
        # Without bones it goes with its mesh, or off the skin with the character as a whole.
        path = element.mesh if self.mesh else next(iter(character.objects))
        self.carrier = character.objects[path]
        self.skeleton = skeleton_of(self.mesh, bones) if self.mesh else element.skeleton
        self.bones = bones.get(self.skeleton)
        self.influences = self._influences(character)
        self.turning = self._turning()
        self.into = self._into()
        self.to_skin = np.linalg.inv(self._to_root(character.layout.to_root(path)))
        tokens = {shape.token for control in self.controls for shape in control.shapes}
        keys = {token: character.shape_key(path, token) for token in tokens} if self.mesh else {}
        self.keys = {
            token: (key, *offsets_at(self.mesh, key, self.point))
            for token, key in keys.items()
            if key is not None
        }

    def place(self, depsgraph, posed, values):
        """The `Placed` element at these values of all controls; ``posed`` are the pose matrices by
        skeleton and bone.  None where its mesh is not shown."""
        point, anchor = self.shown(depsgraph), None
        if point is None and self.drawing.element.follows:
            return None
        weights, moves = gained(self.controls, values, self.base)
        pose = posed.get(self.skeleton)
        skin = self._skin(self._turned(pose, moves))
        if point is not None:
            now = self._skin(pose)
            before = np.linalg.pinv(now[:3, :3]) @ (point - now[:3, 3]) + self._added(weights)
            anchor = skin[:3, :3] @ before + skin[:3, 3]
        mine = [values[name] for name in self.base]
        return place(self.drawing, point, anchor, skin @ self.to_skin, mine)

    def shown(self, depsgraph):
        """(3,) where Blender has the vertex, in the world; None where its mesh is not shown."""
        if self.mesh is None or not self.mesh.visible_get():
            return None
        mesh = self.mesh.evaluated_get(depsgraph)
        if self.point >= len(mesh.data.vertices):
            return None
        return np.array(mesh.matrix_world @ mesh.data.vertices[self.point].co, dtype=np.float64)

    def _skin(self, pose):
        """(4, 4) the map of the skin from before skinning to the world."""
        if self.bones is None:
            return matrix_of(self.carrier.matrix_world)
        world = matrix_of(self.bones.armature.matrix_world)
        return world @ self.bones.blend(pose, self.influences) @ self.into

    def _turned(self, pose, moves):
        """A pose, once ``moves`` by joint are added."""
        if not self.turning:
            return pose
        pose = dict(pose)
        for name, joint in self.turning.items():
            if moves[joint].any():
                along_it = self.bones.turned(pose, name, moves[joint])
                for other in {*self.turning, *(name for name, _ in self.influences)}:
                    if name in self.bones.above[other]:
                        pose[other] = along_it @ pose[other]
        return pose

    def _added(self, weights):
        """(3,) what ``weights`` that are added, by token, do before skinning."""
        found = np.zeros(3)
        for token, (key, knots, offsets) in self.keys.items():
            found += along(knots, offsets, key.value + weights[token])
            found -= along(knots, offsets, key.value)
        return found

    def _influences(self, character):
        """(bone, weight) pairs of what carries it."""
        if self.bones is None:
            return ()
        if self.mesh is None:
            carriers = self.drawing.element.carriers
            named = [
                (character.bone_name(self.skeleton, joint), weight) for joint, weight in carriers
            ]
        else:
            groups = self.mesh.vertex_groups
            mine = self.mesh.data.vertices[self.point].groups
            named = [(groups[each.group].name, each.weight) for each in mine if each.weight]
        return tuple(pair for pair in named if pair[0] in self.bones.rest)

    def _turning(self):
        """By bone, parents first, the joints above the influences that the element's controls
        move."""
        if self.bones is None:
            return {}
        moved = {joint.at for control in self.controls for joint in control.joints}
        above = {name for each, _ in self.influences for name in self.bones.above[each]}
        joints = self.bones.joints.items()
        return {name: joint for name, joint in joints if joint in moved and name in above}

    def _into(self):
        """The mesh's space to the armature's."""
        if self.bones is None or self.mesh is None:
            return np.eye(4)
        world = matrix_of(self.bones.armature.matrix_world)
        return np.linalg.inv(world) @ matrix_of(self.mesh.matrix_world)

    def _to_root(self, stands):
        """Before skinning to root space, in the base pose; ``stands`` is that of what carries it
        without bones."""
        if self.bones is None:
            return stands
        return self.bones.to_root @ self.bones.blend(self.bones.base, self.influences) @ self.into


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
