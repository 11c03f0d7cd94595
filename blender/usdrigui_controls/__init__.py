"""In-situ rig controls: handles on the face, from the layout layer that usdrigui writes beside a
character."""


def register():
    """Called by Blender when the add-on is switched on."""
    from . import gizmos, importing, interface, visibility

    # Settings first: everything else asks for them.
    for room in (interface, visibility, gizmos, importing):
        room.register()


def unregister():
    """Called by Blender when the add-on is switched off."""
    from . import gizmos, importing, interface, visibility

    for room in (importing, gizmos, visibility, interface):
        room.unregister()
