"""Where the elements are in Blender: the evaluated place, bones and shape keys of one vertex."""

from __future__ import annotations

import numpy as np

from .character import move_of
from .inbetweens import offsets_at
from .layout import gained
from .maths.handle_track import along
from .tracking import drawing_of, place

_STILL = 1e-9
"""Moves of a joint that are no larger are what reading its values off the bone leaves."""


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
        posed = {
            path: {bone.name: np.array(bone.matrix) for bone in each.armature.pose.bones}
            for path, each in self.bones.items()
        }
        return [spot.place(depsgraph, posed, values) for spot in self.spots]


class Bones:
    """One armature: rest and base poses in its own space."""

    def __init__(self, character, skeleton, armature):
        layout, self.armature = character.layout, armature
        bones = armature.data.bones
        self.rest = {bone.name: np.array(bone.matrix_local) for bone in bones}
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
        for bone in bones:
            found, joint = self.rest[bone.name], self.joints.get(bone.name)
            if bone.parent:
                above = bone.parent.name
                found = self.base[above] @ self.unbound[above] @ found
            if joint:
                found = found @ composed(*self.frames[joint].basis(moves[joint]))
            self.base[bone.name] = found

    def turned(self, pose, name, change):
        """(4, 4) what takes a bone at ``pose`` and all below it along, once a ``change`` (3, 3) is
        added to its move."""
        frame = self.frames[self.joints[name]]
        move = move_of(self.armature.pose.bones[name], frame)
        now, then = (composed(*frame.basis(each)) for each in (move, move + change))
        return pose[name] @ np.linalg.inv(now) @ then @ np.linalg.inv(pose[name])


class Spot:
    """One element: the vertex that it follows, or what carries it off the skin."""

    def __init__(self, character, bones, element):
        self.drawing, self.point = drawing_of(element, character.controls), element.point
        self.controls = [character.controls[member.control] for member in element.members]
        self.base = {control.name: control.base for control in self.controls}
        self.mesh = character.meshes.get(element.mesh) if element.follows else None
        path = element.mesh if self.mesh else next(iter(character.objects))
        self.skeleton = skeleton_of(self.mesh, bones) if self.mesh else element.skeleton
        self.bones = bones.get(self.skeleton)
        # Without bones it goes with its mesh, or off the skin with the character as a whole.
        self.carrier, self.influences, self.turning = character.objects[path], (), {}
        self.into, base = np.eye(4), {}
        if self.bones:
            self.carrier, base, path = self.bones.armature, self.bones.base, self.skeleton
            self.influences = self._influences(character)
            self.turning = self._turning()
        if self.bones and self.mesh:
            world = np.array(self.carrier.matrix_world)
            self.into = np.linalg.inv(world) @ np.array(self.mesh.matrix_world)
        to_root = character.layout.to_root(path)
        self.to_skin = np.linalg.inv(to_root @ self._blended(base) @ self.into)
        shapes = [each for control in self.controls for each in control.shapes if self.mesh]
        self.keys = {
            each.token: (key, *offsets_at(self.mesh, key, each.token, self.point))
            for each in shapes
            if (key := character.shape_key(element.mesh, each.token))
        }

    def place(self, depsgraph, posed, values):
        """The `Placed` element at these values of all controls; ``posed`` are the pose matrices by
        skeleton and bone.  None where its mesh is not shown."""
        point, anchor = self.shown(depsgraph), None
        if point is None and self.drawing.element.follows:
            return None
        weights, moves = gained(self.controls, values, self.base)
        pose = posed.get(self.skeleton, {})
        skin = self._skin(self._turned(pose, moves))
        if point is not None:
            now = self._skin(pose)
            before = np.linalg.pinv(now[:3, :3]) @ (point - now[:3, 3]) + self._added(weights)
            anchor = skin[:3, :3] @ before + skin[:3, 3]
        mine = tuple(values[name] for name in self.base)
        return place(self.drawing, point, anchor, skin @ self.to_skin, mine)

    def shown(self, depsgraph):
        """(3,) where Blender has the vertex, in the world; None where its mesh is not shown."""
        if self.mesh is None or not self.mesh.visible_get():
            return None
        mesh = self.mesh.evaluated_get(depsgraph)
        if self.point >= len(mesh.data.vertices):
            return None
        return np.array(mesh.matrix_world @ mesh.data.vertices[self.point].co)

    def _skin(self, pose):
        """(4, 4) the map of the skin from before skinning to the world."""
        return np.array(self.carrier.matrix_world) @ self._blended(pose) @ self.into

    def _blended(self, pose):
        """(4, 4) skinning by the bones that carry it, in their armature's space."""
        if not self.influences:
            return np.eye(4)
        return sum(
            weight * pose[name] @ self.bones.unbound[name] for name, weight in self.influences
        )

    def _turned(self, pose, moves):
        """A pose, once ``moves`` by joint are added."""
        pose = dict(pose)
        for name, joint in self.turning.items():
            if np.abs(moves[joint]).max() > _STILL:
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
        """(bone, weight) pairs of what carries it; the weights add up to one."""
        if self.mesh is None:
            carriers = self.drawing.element.carriers
            named = [
                (character.bone_name(self.skeleton, joint), weight) for joint, weight in carriers
            ]
        else:
            groups = self.mesh.vertex_groups
            mine = self.mesh.data.vertices[self.point].groups
            named = [(groups[each.group].name, each.weight) for each in mine if each.weight]
        found = [pair for pair in named if pair[0] in self.bones.rest]
        total = sum(weight for _, weight in found)
        return [(name, weight / total) for name, weight in found]

    def _turning(self):
        """By bone, parents first, the joints above the influences that the element's controls
        move."""
        moved = {joint.at for control in self.controls for joint in control.joints}
        above = {name for each, _ in self.influences for name in self.bones.above[each]}
        joints = self.bones.joints.items()
        return {name: joint for name, joint in joints if joint in moved and name in above}


def skeleton_of(mesh, bones):
    """The prim path of the armature that deforms a mesh, or empty."""
    used = [
        modifier.object
        for modifier in mesh.modifiers
        if modifier.type == "ARMATURE" and modifier.show_viewport
    ]
    return next((path for path, each in bones.items() if each.armature in used), "")


def composed(location, rotation, scale):
    """(4, 4) local transform for column vectors."""
    found = np.eye(4)
    found[:3, :3] = rotation * scale
    found[:3, 3] = location
    return found
