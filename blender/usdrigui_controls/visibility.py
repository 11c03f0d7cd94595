"""The elements that are on screen: placed once per change of the scene, asked by every view."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from .anchors import Anchors
from .character import Character, holders
from .layout import LayoutError
from .maths.visible import is_visible, opened_with


@dataclass(frozen=True)
class Item:
    """One element of one character, placed."""

    holder: str
    """Name of the object that holds the layout."""
    drawing: object
    placed: object

    @property
    def element(self):
        """The `layout.Element`."""
        return self.drawing.element

    @property
    def key(self):
        """(holder, element) by name."""
        return self.holder, self.element.name


opened = set()
"""(holder, name) of the coarse elements whose members are shown in their place."""
_anchors = {}
_items = None
"""Those that can be seen; None once something may have moved."""


def items():
    """All elements that can be seen, where they are now."""
    global _items
    if _items is None:
        _items = _placed()
    return _items


def item(key):
    """The one of a (holder, element), or None."""
    return next((each for each in items() if each.key == key), None)


@bpy.app.handlers.persistent
def forget(*_):
    """Everything may have changed, references into Blender too."""
    _anchors.clear()
    touch()


@bpy.app.handlers.persistent
def touch(*_):
    """Something may have moved."""
    global _items
    _items = None


def _placed():
    found = []
    for holder in holders():
        try:
            character = Character(holder)
            anchors = _anchors.get(holder.name)
            if anchors is None or anchors.layout is not character.layout:
                anchors = _anchors[holder.name] = Anchors(character)
            values = character.values()
            placed = anchors.place(bpy.context.view_layer.depsgraph, values)
        except (LayoutError, ReferenceError, KeyError, StopIteration):
            _anchors.pop(holder.name, None)
            continue
        members = _members(character.layout.elements)
        open_here = {name for where, name in opened if where == holder.name}
        for spot, where in zip(anchors.spots, placed, strict=True):
            element = spot.drawing.element
            if (
                where is not None
                and is_visible(element.name, members, open_here)
                and (element.mesh or bpy.context.scene.usdrigui.board)
            ):
                found.append(Item(holder.name, spot.drawing, where))
    return found


def toggle(holder, element, elements):
    """Open a coarse element, its mirror with it; or close the one that an element is a member
    of."""
    above = (each for each in elements if element.name in each.inner)
    coarse = element if element.inner else next(above, None)
    if coarse is not None:
        both = opened_with(coarse.name, coarse.mirror, _members(elements))
        opened.symmetric_difference_update((holder, name) for name in both)
        touch()


def _members(elements):
    """By the name of each coarse element, its members."""
    return {element.name: element.inner for element in elements if element.inner}


_HANDLERS = (
    ("depsgraph_update_post", touch),
    ("frame_change_post", touch),
    ("undo_post", forget),
    ("redo_post", forget),
    ("load_post", forget),
)


def register():
    """Hear of changes."""
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister():
    """Hear no more."""
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    forget()
