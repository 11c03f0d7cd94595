"""Settings, the panel in the sidebar and the operators."""

from __future__ import annotations

import bpy
from bpy_extras.io_utils import ImportHelper

from . import visibility
from .bones import SwitchBones, remove_bones
from .character import BONES, Character, at_frames, holders, unbind
from .environment import MakeEnvironment, Preferences, in_one_line
from .gizmos import Hand, active, chosen, give
from .importing import add_controls, open_stage
from .laying_out import LayOutFace, PinElement
from .posing import flipped, mirrored_from
from .reach import crossing
from .saving import SaveAnimation


def _touch(_settings, _context):
    visibility.touch()


class Settings(bpy.types.PropertyGroup):
    """How the controls of a scene look and behave."""

    show: bpy.props.BoolProperty(name="Show Controls", default=True)
    opacity: bpy.props.FloatProperty(
        name="Opacity", default=0.8, min=0.05, max=1.0, subtype="FACTOR"
    )
    size: bpy.props.FloatProperty(name="Handle Size", default=1.0, min=0.2, max=4.0)
    symmetric: bpy.props.BoolProperty(
        name="Symmetric",
        default=False,
        description="Dragging a control moves its twin along",
    )
    names: bpy.props.BoolProperty(
        name="Names",
        default=True,
        description="Show the name of the control under the pointer",
    )
    board: bpy.props.BoolProperty(
        name="Side Board",
        default=True,
        description="Show the elements that stand on the board",
        update=_touch,
    )


class LoadLayout(bpy.types.Operator, ImportHelper):
    """Build the controls of a character that is in the scene from its layout."""

    bl_idname = "usdrigui.load_layout"
    bl_label = "Load Rig UI Layout"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: bpy.props.StringProperty(default="*.usd;*.usda;*.usdc;*.usdz", options={"HIDDEN"})

    @in_one_line
    def execute(self, context):
        """Read the layer and bind it to the objects that it means."""
        add_controls(open_stage(bpy.path.abspath(self.filepath)))
        visibility.forget()
        _warn(self)
        return {"FINISHED"}


class RemoveLayout(bpy.types.Operator):
    """Take the controls of all characters away; shape keys and bones stay."""

    bl_idname = "usdrigui.remove_layout"
    bl_label = "Remove Rig UI Layout"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, _context):
        """Unbind every character of the scene."""
        for holder in holders():
            if BONES in holder:
                remove_bones(holder)
            unbind(holder)
        visibility.forget()
        return {"FINISHED"}


class OnControls:
    """An operator that does something to the chosen elements, or to all controls of all characters:
    ``act(character, names)`` tells to how many controls.  ``needed`` says what is to be
    done first where there were none."""

    needed = "use a handle first"
    bl_options = {"REGISTER", "UNDO"}

    everything: bpy.props.BoolProperty(name="All Controls", default=False)

    def execute(self, _context):
        """Act, and tell how many there were."""
        if self.everything:
            acted_on = [
                (character, [*character.controls]) for character in map(Character, holders())
            ]
        else:
            acted_on = [
                (character, [member.control for member in element.members])
                for character, element in chosen()
            ]
        count = sum(self.act(*each) for each in acted_on)
        if not count:
            self.report({"WARNING"}, f"{self.bl_label}: {self.needed}")
            return {"CANCELLED"}
        self.report({"INFO"}, f"{self.bl_label}: {count} control{'' if count == 1 else 's'}")
        _warn(self)
        return {"FINISHED"}


class Posing(OnControls):
    """An operator that gives controls other values: ``changed(character, names)``."""

    def act(self, character, names):
        """Set those values."""
        changed = self.changed(character, names)
        give(character, changed)
        return len(changed)


class ResetControls(Posing, bpy.types.Operator):
    """Put controls back to the base pose."""

    bl_idname = "usdrigui.reset"
    bl_label = "Reset Controls"
    icon = "LOOP_BACK"

    def changed(self, character, names):
        """Their values in the base pose."""
        return {name: character.controls[name].base for name in names}


class MirrorPose(Posing, bpy.types.Operator):
    """The pose of one side on the other, or the pose seen in a mirror."""

    bl_idname = "usdrigui.mirror"
    bl_label = "Mirror Pose"
    needed = "pose one side first"

    everything: bpy.props.BoolProperty(name="All Controls", default=True, options={"SKIP_SAVE"})
    side: bpy.props.EnumProperty(
        name="From",
        items=[
            ("left", "Left to Right", "The character's left on its right"),
            ("right", "Right to Left", "The character's right on its left"),
            ("both", "Flip", "Each side on the other"),
        ],
    )

    def changed(self, character, names):
        """Of these, what the mirror changes."""
        layout, values = character.layout, character.values()
        if self.side == "both":
            found = flipped(layout, values, crossing(character))
        else:
            found = mirrored_from(layout, values, self.side)
        return {
            name: found[name] for name in names if found.get(name, values[name]) != values[name]
        }


class Breakdown(Posing, bpy.types.Operator):
    """Put the chosen controls between their keys before and after this frame."""

    bl_idname = "usdrigui.breakdown"
    bl_label = "Breakdown"
    icon = "IPO_EASE_IN_OUT"
    needed = "use a handle with keys before and after this frame first"

    share: bpy.props.FloatProperty(
        name="Share", default=0.5, soft_min=0.0, soft_max=1.0, description="0 before, 1 after"
    )

    def changed(self, character, names):
        """Of the controls without a key on one of the two sides nothing changes."""
        frame, now = bpy.context.scene.frame_current_final, character.values()
        sides = {name: character.frames_around(name, frame) for name in names}
        frames = {each for pair in sides.values() for each in pair}
        there = at_frames(frames, character.values)
        character.set_values(now)
        ends = {name: [there[each][name] for each in pair] for name, pair in sides.items() if pair}
        return {name: a + self.share * (b - a) for name, (a, b) in ends.items()}


class KeyControls(OnControls, bpy.types.Operator):
    """Insert keyframes for controls at the current frame."""

    bl_idname = "usdrigui.insert_keys"
    bl_label = "Key Controls"
    icon = "KEY_HLT"

    def act(self, character, names):
        """Key them."""
        character.insert_keys(names)
        return len(names)


class KeyHovered(bpy.types.Operator):
    """Insert keyframes for the controls under the pointer."""

    bl_idname = "usdrigui.key_hovered"
    bl_label = "Key Control Under Pointer"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        """Only over a handle; elsewhere the key means what it always means."""
        return context.scene.usdrigui.show and Hand.hot is not None

    def execute(self, context):
        """Key what the pointer is over."""
        Hand.chosen = (Hand.hot,)
        return bpy.ops.usdrigui.insert_keys(everything=False)


class RigPanel(bpy.types.Panel):
    """The controls of the scene in the sidebar of the 3-D view."""

    bl_idname = "USDRIGUI_PT_controls"
    bl_label = "In-situ Rig Controls"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Rig UI"

    def draw(self, context):
        """Settings, then the element used last."""
        column = self.layout.column()
        buttons = [(LayOutFace, "MESH_MONKEY"), (LoadLayout, "IMPORT")]
        if holders():
            if said := lost():
                column.label(text=said, icon="ERROR")
            for name in Settings.__annotations__:
                column.prop(context.scene.usdrigui, name)
            self._draw_active(column.box())
            _draw_row(column, True, (KeyControls, "Key All"), (ResetControls, "Reset All"))
            column.operator_menu_enum(MirrorPose.bl_idname, "side", icon="MOD_MIRROR")
            buttons = [
                (SwitchBones, "BONE_DATA"),
                (SaveAnimation, "EXPORT"),
                *buttons,
                (RemoveLayout, "X"),
            ]
        for kind, icon in buttons:
            column.operator(kind.bl_idname, icon=icon)

    def _draw_active(self, box):
        character, element = active()
        if element is None:
            box.label(text="Drag a handle on the face")
            return
        box.label(text=element.label)
        for member in element.members:
            control = character.controls[member.control]
            keys = character.keys_of(control) if control.plain else ()
            if keys:
                box.prop(keys[0], "value", text=control.label, slider=True)
            else:
                box.label(text=f"{control.label}  {character.values()[control.name]:.3f}")
        if element.reason:
            box.label(text=element.reason, icon="INFO")
        act = (KeyControls, "Key"), (ResetControls, "Reset"), (Breakdown, "Breakdown")
        _draw_row(box, False, *act)
        row = box.row(align=True)
        for place, text in (("", "Pin to Vertex"), ("board", "To Board"), ("free", "Unpin")):
            row.operator(PinElement.bl_idname, text=text).place = place


def lost():
    """The line on controls of which shape keys or bones are gone; empty where there are none."""
    names = [name for holder in holders() for name in Character(holder).missing()]
    return names and (
        f"a shape key or bone of {', '.join(names)} is gone or has another name: lay the face out"
        " again, places are kept"
    )


def _warn(operator):
    if said := lost():
        operator.report({"WARNING"}, said)


def _draw_row(layout, everything, *buttons):
    row = layout.row(align=True)
    for kind, text in buttons:
        row.operator(kind.bl_idname, text=text, icon=kind.icon).everything = everything


def _export_menu(self, _context):
    self.layout.operator(SaveAnimation.bl_idname, text="Rig UI Animation (.usda)")


def _file_menu(self, _context):
    self.layout.operator(LoadLayout.bl_idname, text="Rig UI Layout for This Scene (.usd)")


_register_classes, _unregister_classes = bpy.utils.register_classes_factory(
    (
        Settings,
        Preferences,
        MakeEnvironment,
        LayOutFace,
        PinElement,
        LoadLayout,
        RemoveLayout,
        SaveAnimation,
        SwitchBones,
        ResetControls,
        MirrorPose,
        Breakdown,
        KeyControls,
        KeyHovered,
        RigPanel,
    )
)
_keymaps = []


def register():
    """Settings, panel, operators, the menu entry and the key I over a handle."""
    _register_classes()
    bpy.types.Scene.usdrigui = bpy.props.PointerProperty(type=Settings)
    bpy.types.TOPBAR_MT_file_import.append(_file_menu)
    bpy.types.TOPBAR_MT_file_export.append(_export_menu)
    configuration = bpy.context.window_manager.keyconfigs.addon
    if configuration is not None:
        # Blender's own I stands in the keymaps of the modes, which come before that of the view.
        for mode in ("Object Mode", "Pose"):
            keymap = configuration.keymaps.new(name=mode)
            _keymaps.append((keymap, keymap.keymap_items.new(KeyHovered.bl_idname, "I", "PRESS")))


def unregister():
    """Take them away."""
    for keymap, item in _keymaps:
        keymap.keymap_items.remove(item)
    _keymaps.clear()
    bpy.types.TOPBAR_MT_file_import.remove(_file_menu)
    bpy.types.TOPBAR_MT_file_export.remove(_export_menu)
    del bpy.types.Scene.usdrigui
    _unregister_classes()
