"""The controls in the 3-D view: one gizmo that draws, finds and drags all elements."""

from __future__ import annotations

import bpy
import numpy as np

from . import visibility
from .character import Character, holders
from .drawing import draw_elements, draw_label
from .posing import with_partners
from .screen import FINE, Grab, Screen, pick


class Hand:
    """What the pointer is over, what is chosen and what is pinned, by names: references into
    Blender do not last."""

    hot = None
    """(holder, element) under the pointer."""
    chosen = ()
    """(holder, element) of the handles used last, that of the moment at the end."""


def chosen():
    """(`Character`, element) of the handles used last, without those that are gone."""
    held = {holder.name: Character(holder) for holder in holders()}
    return [
        (held[name], element)
        for name, chosen_one in Hand.chosen
        if name in held and (element := held[name].layout.element(chosen_one))
    ]


def active():
    """The character and the element used last; None and None where they are gone."""
    return (chosen() or [(None, None)])[-1]


def give(character, changed):
    """Set values of controls, and keyframes where Blender records."""
    character.set_values(changed)
    if bpy.context.scene.tool_settings.use_keyframe_insert_auto:
        character.insert_keys(changed)
    visibility.touch()


class RigControls(bpy.types.Gizmo):
    """All elements of all characters as one gizmo, so that the nearest handle wins and none
    steals."""

    bl_idname = "USDRIGUI_GT_controls"

    __slots__ = ("before", "grab", "item", "last", "way")

    def setup(self):
        """Called by Blender once per view."""
        self.grab = None

    def draw(self, context):
        """Draw everything; what is under the pointer, held, or chosen with others, in white."""
        lit = {Hand.hot} if self.is_highlight else set()
        if self.grab or len(Hand.chosen) > 1:
            lit.update(Hand.chosen)
        opacity = context.scene.usdrigui.opacity
        draw_elements(_screen(context), visibility.items(), _radii(context), opacity, lit)

    def test_select(self, context, location):
        """The number of the element under ``location``, or -1."""
        screen, found = _screen(context), visibility.items()
        pointer = np.array([location[0], screen.height - location[1]])
        index = pick(screen, [item.placed for item in found], pointer, _radii(context))
        hot = found[index].key if index >= 0 else None
        if hot != Hand.hot:
            Hand.hot = hot
            context.area.tag_redraw()
        return index

    def invoke(self, context, event):
        """Take hold, with Shift beside what is chosen; with Ctrl, put the element back to the base
        pose instead."""
        item = self.item = visibility.item(Hand.hot)
        if item is None:
            return {"CANCELLED"}
        kept = [each for each in Hand.chosen if event.shift and each != Hand.hot]
        Hand.chosen = (*kept, Hand.hot)
        screen = _screen(context)
        self.last, self.way = _pointer(event, screen), np.zeros(2)
        self.before = Character(bpy.data.objects[item.holder]).values()
        if event.ctrl:  # and nothing is held: Blender may tell that Ctrl is up before the button
            self._set(context, item.drawing.base)
        else:
            self.grab = Grab(screen, item.drawing, item.placed)
        return {"RUNNING_MODAL"}

    def modal(self, context, event, tweak):
        """Follow the pointer; Shift for fine steps."""
        pointer = _pointer(event, _screen(context))
        if self.grab is None or np.array_equal(pointer, self.last):
            return {"RUNNING_MODAL"}
        self.way = self.way + (FINE if event.shift else 1.0) * (pointer - self.last)
        self.last = pointer
        self._set(context, self.grab.to(self.way))
        return {"RUNNING_MODAL"}

    def exit(self, context, cancel):
        """Let go: one step of undo, and keyframes where Blender records; or everything as it
        was."""
        item, self.grab = self.item, None
        context.area.header_text_set(None)
        character = Character(bpy.data.objects[item.holder])
        after = character.values().items()
        changed = {name: each for name, each in after if abs(each - self.before[name]) > 1e-9}
        if cancel:
            character.set_values({name: self.before[name] for name in changed})
        elif changed:
            give(character, changed)
            bpy.ops.ed.undo_push(message=f"Drag {item.element.label}")
        elif len(Hand.chosen) == 1:
            visibility.toggle(item.holder, item.element, character.layout.elements)
        visibility.touch()

    def _set(self, context, values):
        character = Character(bpy.data.objects[self.item.holder])
        names = (member.control for member in self.item.element.members)
        changed = dict(zip(names, values, strict=True))
        if context.scene.usdrigui.symmetric:
            changed = with_partners(changed, character.layout)
        character.set_values(changed)
        visibility.touch()
        context.area.header_text_set(
            "   ".join(f"{name} {value:.3f}" for name, value in changed.items())
        )
        context.area.tag_redraw()


class RigControlsGroup(bpy.types.GizmoGroup):
    """Shows the controls wherever the scene has a character with a layout."""

    bl_idname = "USDRIGUI_GGT_controls"
    bl_label = "In-situ rig controls"
    bl_space_type = "VIEW_3D"
    bl_region_type = "WINDOW"
    bl_options = {"3D", "PERSISTENT", "SHOW_MODAL_ALL"}

    @classmethod
    def poll(cls, context):
        """Whether this view shows controls now."""
        return (
            context.scene.usdrigui.show
            and context.mode in ("OBJECT", "POSE")
            and bool(visibility.items())
        )

    def setup(self, context):
        """Called by Blender once per view."""
        self.gizmos.new(RigControls.bl_idname).use_draw_modal = True


def _draw_hot_label():
    context, settings = bpy.context, bpy.context.scene.usdrigui
    item = visibility.item(Hand.hot) if settings.show and settings.names else None
    if item is not None:
        screen = _screen(context)
        x, y = screen.project(item.placed.handle[None])[0]
        values = "  ".join(f"{value:.2f}" for value in item.placed.values)
        draw_label((x + 14.0, screen.height - y + 10.0), f"{item.element.label}  {values}")


def _screen(context):
    region, view = context.region, context.region_data
    back = view.view_matrix.inverted()
    eye = back.translation if view.is_perspective else back.col[2].xyz
    matrix = np.array(view.perspective_matrix)
    return Screen(matrix, region.width, region.height, np.array(eye), view.is_perspective)


def _radii(context):
    """Pixels of every handle: its true size times the setting, but never too small to be seen."""
    screen, size = _screen(context), context.scene.usdrigui.size
    return [
        max(screen.radius(item.placed, item.element.width * size), 3.0)
        for item in visibility.items()
    ]


def _pointer(event, screen):
    return np.array([event.mouse_region_x, screen.height - event.mouse_region_y])


_label = None
_register_classes, _unregister_classes = bpy.utils.register_classes_factory(
    (RigControls, RigControlsGroup)
)


def register():
    """Make the controls known to Blender."""
    global _label
    _register_classes()
    _label = bpy.types.SpaceView3D.draw_handler_add(_draw_hot_label, (), "WINDOW", "POST_PIXEL")


def unregister():
    """Take them away."""
    bpy.types.SpaceView3D.draw_handler_remove(_label, "WINDOW")
    _unregister_classes()
