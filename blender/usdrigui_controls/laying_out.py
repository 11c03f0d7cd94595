"""One button on the face that is there: written as USD, laid out beside Blender, and its own shape
keys and bones bound."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import bpy

from . import visibility
from .character import BONES, EXPORTED, SOURCE, holder_of
from .environment import Background, need_room, usdrigui
from .exporting import selected_face, write_character
from .gizmos import active
from .importing import add_controls, need_usd, open_stage
from .layout import LayoutError

ROOM = 0.2e9
"""Bytes that the files of a face may take."""


class LayOutFace(Background, bpy.types.Operator):
    """Lay controls out on the selected face; again where it has some, which stay where they are."""

    bl_idname = "usdrigui.lay_out"
    bl_label = "Lay Out This Face"
    bl_options = {"REGISTER", "UNDO"}

    def prepare(self, context):
        """Write the face, and the program that lays it out."""
        need_usd()
        face = selected_face(context)
        held = holder_of([*face.meshes, *face.armatures])
        if held and EXPORTED not in held:
            raise LayoutError(
                f"{held.name} has the layout of {held[SOURCE]}: lay that file out again, or remove"
                " the layout first"
            )
        if held and BONES in held:
            raise LayoutError("bones drive the shape keys: switch Controls as Bones off first")
        usdrigui()  # say what is missing before anything is written
        # Beside the saved scene, else where Blender keeps files until it ends.
        folder = Path(bpy.path.abspath("//") or bpy.app.tempdir) / "rigui"
        folder.mkdir(exist_ok=True)
        need_room(folder, ROOM, "save the scene on another disk")
        source = folder / f"{bpy.path.clean_name(face.name)}.usd"
        self.layer = source.with_suffix(".rigui.usda")
        self.previous = self.layer.with_name(f"previous_{self.layer.name}")
        write_character(face, source)
        self.left_off, self.beside = face.driven(), face.beside
        return [usdrigui(*self._arguments(source, held))]

    def _arguments(self, source, held):
        configuration = source.with_suffix(".rigui.toml")
        mine = Path(bpy.app.tempdir) / "left_off.rigui.toml"
        named = (f"[controls.{json.dumps(name)}]\nexclude = true\n" for name in self.left_off)
        mine.write_text("".join(named), encoding="utf-8")
        found = ["process", source, "-o", self.layer, "--openjd", "--config", mine]
        beside = ("--config", configuration), ("--corrections", _corrections_of(self.layer))
        for option, path in beside:
            if path.is_file():
                found += [option, path]
        before = Path(held[SOURCE] if held else "")
        if before == self.layer and before.is_file():
            # The layer is about to be replaced: it is read under another name.
            shutil.copyfile(before, self.previous)
            found += ["--previous", self.previous]
        elif before.is_file():  # of a character with other names: what this is a copy of, perhaps
            found += ["--like", before]
        return found

    def finish(self):
        """Bind the layout to the objects of the scene."""
        self.previous.unlink(missing_ok=True)
        for character in add_controls(open_stage(str(self.layer))):
            character.holder[EXPORTED] = True
            on = [each.name for each in character.armatures.values()] or [character.holder.name]
            said = f"{len(character.controls)} controls on {' and '.join(on)}"
            if self.left_off:
                said += f"; {len(self.left_off)} shape keys are driven or muted and have none"
            if self.beside:
                said += (
                    f"; {', '.join(self.beside)} and what has no armature beside it are left out:"
                    " select with the face what belongs to it"
                )
            self.report({"INFO"}, said)
        visibility.forget()


class PinElement(Background, bpy.types.Operator):
    """Decide where the element used last stands in every layout to come."""

    bl_idname = "usdrigui.pin"
    bl_label = "Pin This Element"

    place: bpy.props.StringProperty(
        description="here, board, face or free; empty for the selected vertex of its mesh"
    )

    def prepare(self, _context):
        """The program that writes the decision into the corrections beside the layout."""
        character, element = active()
        if element is None:
            raise LayoutError("use the handle first that is to be pinned")
        place, layer = self.place or _selected(character), Path(character.holder[SOURCE])
        decisions = [f"{member.control}={place}" for member in element.members]
        return [usdrigui("pin", layer, *decisions, "-o", _corrections_of(layer))]

    def finish(self):
        """The next layout heeds it."""
        self.report({"INFO"}, "noted: it holds from the next Lay Out This Face on")


def _selected(character):
    """``MESH_PATH#POINT`` of the one selected vertex."""
    found = []
    for path, mesh in character.meshes.items():
        mesh.update_from_editmode()
        found += [f"{path}#{each.index}" for each in mesh.data.vertices if each.select]
    if len(found) != 1:
        raise LayoutError(f"select one vertex of the face; {len(found)} are selected")
    return found[0]


def _corrections_of(layer):
    return layer.with_suffix("").with_suffix(".corrections.usda")
