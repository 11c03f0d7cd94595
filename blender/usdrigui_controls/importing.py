"""From a stage to controls: by Blender's USD hook on what was imported, or on what is in the scene
already."""

from __future__ import annotations

import atexit
import importlib

import bpy

from . import inbetweens
from .character import SOURCE, bind
from .layout import LayoutError
from .matching import match, names_of


def add_controls(stage, imported=None):
    """Build the controls of every layout on a stage, on the objects of the scene that it means.

    Objects that were ``imported`` just now, by prim path, are put where USD has them; all others
    are left as they are, but for in-betweens that they lack.  Returns the `Character` of each.
    Raises LayoutError when the stage holds no layout, or one that does not fit the scene.
    """
    from .reading import read_layouts

    layouts = read_layouts(stage)
    if not layouts:
        raise LayoutError("this file holds no layout: choose the .rigui.usda of the character")
    objects = imported or match(
        stage, layouts, [each for each in bpy.context.scene.objects if not each.library]
    )
    built = []
    for layout in layouts:
        character = bind(layout, objects, names_of(stage, layout, objects))
        character.holder[SOURCE] = stage.GetRootLayer().realPath
        inbetweens.build(stage, character)
        if imported:
            character.place_meshes()
        # The layer's own drawn handles, if they were imported as well: the controls are drawn.
        for path, thing in objects.items():
            if path.startswith(f"{layout.root}/RigUI/"):
                thing.hide_viewport = thing.hide_render = True
        built.append(character)
    return built


def has_usd():
    """Whether Python can import the USD that this Blender brings along; some builds leave its
    Python modules out."""
    bpy.utils.expose_bundled_modules()  # bpy as a module does not do so by itself
    try:
        importlib.import_module("pxr.Usd")
    except ImportError:
        return False
    return True


def need_usd():
    """Raise LayoutError unless Python can import USD."""
    if not has_usd():
        raise LayoutError("this Blender comes without USD: use one from blender.org")


def open_stage(path):
    """A USD stage.  Raises LayoutError without USD, or for a file that is none."""
    need_usd()
    from pxr import Tf, Usd

    try:
        return Usd.Stage.Open(path)
    except Tf.ErrorException as error:
        raise LayoutError(f"{path} is no USD file that can be opened: choose another") from error


if hasattr(bpy.types, "USDHook"):

    class RigControlsHook(bpy.types.USDHook):
        """Builds the controls of characters whose layout is imported with them."""

        bl_idname = "usdrigui_controls"
        bl_label = "In-situ rig controls"

        @staticmethod
        def on_import(import_context):
            """Called by the importer when the scene is built; never fails the import."""
            imported = {
                str(path): each
                for path, made in import_context.get_prim_map().items()
                for each in made
                if isinstance(each, bpy.types.Object)
            }
            try:
                built = add_controls(import_context.get_stage(), imported)
            except LayoutError as error:
                print(f"In-situ rig controls: {error}")
                return False
            for character in built:
                print(f"In-situ rig controls: built on {character.holder.name}")
            return True


def register():
    """Listen to imports, where this Blender tells of them and Python has USD.

    Without USD's Python modules Blender cannot hand a hook its stage: it aborts in any import.
    """
    if hasattr(bpy.types, "USDHook") and has_usd():
        bpy.utils.register_class(RigControlsHook)
        # Blender 4.5 deadlocks at exit in a class that it still knows while Python goes away.
        atexit.register(unregister)


def unregister():
    """Listen no more; doing so twice is harmless."""
    if hasattr(bpy.types, "USDHook") and RigControlsHook.is_registered:
        bpy.utils.unregister_class(RigControlsHook)
    atexit.unregister(unregister)
