"""The controls in the 3-D view: one gizmo that draws, finds and drags all elements."""

from __future__ import annotations

import bpy
import numpy as np

from . import visibility
from .character import Character, holders
from .drawing import draw_elements, draw_label
from .screen import Grab, Screen, pick, with_partners


class Hand:
    """What the pointer is over and what it holds, for the label, the panel and the operators."""

    hot = None
    """(holder, element) under the pointer."""
    active = None
    """(holder, element) dragged or clicked last."""


def active():
    """The holder and the element dragged or clicked last; None and None where they are gone."""
    holder = bpy.data.objects.get(Hand.active[0]) if Hand.active else None
    if holder is None or holder not in holders(bpy.context.scene):
        return None, None
    return holder, Character(holder).layout.element(Hand.active[1])


class RigControls(bpy.types.Gizmo):
    """All elements of all characters as one gizmo, so that the nearest handle wins and none
    steals."""

    bl_idname = "USDRIGUI_GT_controls"

    __slots__ = ("before", "grab", "grabbed", "last")

    def setup(self):
        """Called by Blender once per view."""
        self.grab = None

    def draw(self, context):
        """Draw everything; what is under the pointer, or held, in white."""
        screen, found = _screen(context), visibility.items(context)
        hot = Hand.active if self.grab else Hand.hot if self.is_highlight else None
        settings = context.scene.usdrigui
        names = [(item.holder, item.element.name) for item in found]
        index = names.index(hot) if hot in names else -1
        draw_elements(screen, found, _radii(screen, found, settings), settings.opacity, index)

    def test_select(self, context, location):
        """The number of the element under ``location``, or -1."""
        screen, found = _screen(context), visibility.items(context)
        pointer = np.array([location[0], screen.height - location[1]])
        index = pick(
            screen,
            [item.placed for item in found],
            pointer,
            _radii(screen, found, context.scene.usdrigui),
        )
        hot = (found[index].holder, found[index].element.name) if index >= 0 else None
        if hot != Hand.hot:
            Hand.hot = hot
            context.area.tag_redraw()
        return index

    def invoke(self, context, event):
        """Take hold; with Ctrl, put the element back to the base pose instead."""
        if Hand.hot is None:
            return {"CANCELLED"}
        item = next(
            (
                each
                for each in visibility.items(context)
                if (each.holder, each.element.name) == Hand.hot
            ),
            None,
        )
        if item is None:
            return {"CANCELLED"}
        Hand.active = Hand.hot
        screen = _screen(context)
        pointer = _pointer(event, screen)
        self.grabbed = item
        self.before = Character(bpy.data.objects[item.holder]).values()
        self.grab = Grab(screen, item.drawing, item.placed, item.values, pointer)
        self.last = pointer
        if event.ctrl:
            self._set(context, item.drawing.base)
        return {"RUNNING_MODAL"}

    def modal(self, context, event, tweak):
        """Follow the pointer; Shift for fine steps."""
        pointer = _pointer(event, _screen(context))
        if self.grab is None or event.ctrl or np.array_equal(pointer, self.last):
            return {"RUNNING_MODAL"}
        self.last = pointer
        self._set(context, self.grab.to(pointer, fine=event.shift))
        return {"RUNNING_MODAL"}

    def exit(self, context, cancel):
        """Let go: one step of undo, and keyframes where Blender records; or everything as it
        was."""
        item, self.grab = self.grabbed, None
        context.area.header_text_set(None)
        character = Character(bpy.data.objects[item.holder])
        after = character.values()
        changed = [name for name, value in after.items() if abs(value - self.before[name]) > 1e-9]
        if cancel:
            character.set_values({name: self.before[name] for name in changed})
        elif changed:
            if context.scene.tool_settings.use_keyframe_insert_auto:
                character.insert_keys(changed)
            bpy.ops.ed.undo_push(message=f"Drag {item.element.label}")
        else:
            visibility.toggle(item.holder, item.element, character.layout.elements)
        visibility.touch()

    def _set(self, context, values):
        item = self.grabbed
        character = Character(bpy.data.objects[item.holder])
        changed = {
            member.control: float(v) for member, v in zip(item.element.members, values, strict=True)
        }
        if context.scene.usdrigui.symmetric:
            ranges = {
                each.name: (each.minimum, each.default, each.maximum)
                for each in character.layout.controls
            }
            changed = with_partners(changed, character.layout.partners(), ranges)
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
            and bool(visibility.items(context))
        )

    def setup(self, context):
        """Called by Blender once per view."""
        gizmo = self.gizmos.new(RigControls.bl_idname)
        gizmo.use_draw_modal = True


def _draw_hot_label():
    context = bpy.context
    hot = Hand.hot
    if hot is None or not context.scene.usdrigui.show or not context.scene.usdrigui.names:
        return
    item = next(
        (each for each in visibility.items(context) if (each.holder, each.element.name) == hot),
        None,
    )
    if item is not None:
        screen = _screen(context)
        x, y = screen.project(item.placed.handle[None])[0]
        values = "  ".join(f"{value:.2f}" for value in item.values)
        draw_label((x + 14.0, screen.height - y + 10.0), f"{item.element.label}  {values}")


def _screen(context):
    region, view = context.region, context.region_data
    back = view.view_matrix.inverted()
    eye = back.translation if view.is_perspective else back.col[2].xyz
    matrix = np.array(view.perspective_matrix, dtype=np.float64)
    return Screen(matrix, region.width, region.height, np.array(eye), view.is_perspective)


def _radii(screen, found, settings):
    """Pixels of every handle: its true size times the setting, but never too small to be seen."""
    layouts = _layouts()
    return [
        max(
            screen.radius(item.placed, layouts[item.holder].width_of(item.element) * settings.size),
            3.0,
        )
        for item in found
    ]


def _layouts():
    from .character import LAYOUT, parsed

    return {each.name: parsed(each[LAYOUT]) for each in bpy.data.objects if LAYOUT in each}


def _pointer(event, screen):
    return np.array([event.mouse_region_x, screen.height - event.mouse_region_y], dtype=np.float64)


_label = None


def register():
    """Make the controls known to Blender."""
    global _label
    bpy.utils.register_class(RigControls)
    bpy.utils.register_class(RigControlsGroup)
    _label = bpy.types.SpaceView3D.draw_handler_add(_draw_hot_label, (), "WINDOW", "POST_PIXEL")


def unregister():
    """Take them away."""
    bpy.types.SpaceView3D.draw_handler_remove(_label, "WINDOW")
    bpy.utils.unregister_class(RigControlsGroup)
    bpy.utils.unregister_class(RigControls)
