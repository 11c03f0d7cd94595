"""Whether the handles of a layer are found in pictures of three renderers, left and right told
apart: ``BPY benchmarks/renders.py LAYER storm|cycles|eevee FOLDER [PART]``.

Runs in the Python of bpy 4.x, whose USD and Blender draw: Hydra Storm without a window, Cycles on
the processor, EEVEE (under ``xvfb-run`` without a screen).  The part, *face* by default, fills 700
pixels, guides on, the skin grey; seen from its viewer and from 40 degrees to either side, hands
also from the mirror image.  No code of usdrigui takes part.

A handle is *found* where, in the best picture, at least three tenths of its circle at its
projected place have the hue of its `displayColor`; *told apart* where no other side's hue has more
of it there.  Prints both counts with the names that fail, keeps the pictures, exits with 1 if any
fails.
"""

import ctypes
import os
import sys
from pathlib import Path

import bpy
import numpy as np

bpy.utils.expose_bundled_modules()
from pxr import Gf, Usd, UsdAppUtils, UsdGeom, Vt  # noqa: E402
from turned_views import bases  # noqa: E402

# Else Mesa's software GL refuses a frame buffer of Storm's second picture.
os.environ.setdefault("MESA_NO_ERROR", "1")
PIXELS, FOUND, COLOURFUL = 700, 0.3, 0.25
GREY = 0.5


def main():
    layer, engine, folder, *part = sys.argv[1:]
    Path(folder).mkdir(parents=True, exist_ok=True)
    stage = Usd.Stage.Open(layer)
    stage.SetEditTarget(stage.GetSessionLayer())
    scope = next(each for each in stage.Traverse() if has(each, "RigUILayoutAPI"))
    meshes = [each for each in scope.GetChildren() if each.IsA(UsdGeom.Mesh)]
    meshes = [each for each in meshes if UsdGeom.Imageable(each).ComputeVisibility() != "invisible"]
    found = [handle for mesh in meshes for handle in handles(mesh, *(part or ["face"]))]
    view, width = frame(scope, *(part or ["face"]))
    draw = storm if engine == "storm" else blender
    centres = np.array([each["centre"] for each in found])
    middle, size = 0.5 * (centres.min(0) + centres.max(0)), 1.15 * np.ptp(centres, axis=0).max()
    up = np.eye(3)["YZ".index(UsdGeom.GetStageUpAxis(stage)) + 1]
    shares = np.zeros((len(found), 2))
    plane = np.array(value(scope, "rigUI:layout:planeNormal", (0, 0, 0)))
    for number, basis in enumerate(bases(view, up, plane)):
        path = (
            Path(folder)
            / f"{Path(layer).name.split('.')[0]}_{(part or ['face'])[0]}_{engine}_{number}.png"
        )
        draw(stage, scope, engine, str(path), middle, size, basis)
        picture = pixels(path)
        palette = {tuple(handle["colour"]): hue(np.array(handle["colour"])) for handle in found}
        for row, handle in enumerate(found):
            seen = circle(picture, (handle["centre"] - middle) @ basis, width, size)
            shares[row] = max(tuple(shares[row]), score(seen, palette, tuple(handle["colour"])))
    lost = [each["name"] for each, (own, _) in zip(found, shares, strict=True) if own < FOUND]
    mixed = [
        each["name"] for each, (own, lead) in zip(found, shares, strict=True) if own and lead < 0.0
    ]
    print(
        f"{Path(layer).name} {engine}: {len(found) - len(lost)} of {len(found)} handles found, the"
        f" least {shares[:, 0].min():.2f}, median {np.median(shares[:, 0]):.2f};"
        f" {len(found) - len(mixed)} told apart"
    )
    if lost or mixed:
        print("  not found:", ", ".join(lost) or "-", "  not told apart:", ", ".join(mixed) or "-")
    return int(bool(lost or mixed))


# --- the layer ------------------------------------------------------------------------------------


def has(prim, api):
    return api in prim.GetPrimTypeInfo().GetAppliedAPISchemas()


def value(prim, name, otherwise=None):
    attribute = prim.GetAttribute(name)
    found = attribute.Get() if attribute else None
    return otherwise if found is None else found


def frame(scope, part):
    """The direction to the viewer of a part, in the space of the world, and its handle width."""
    view, width = (
        value(scope, "rigUI:layout:viewDirection", (0, 0, 1)),
        value(scope, "rigUI:layout:handleWidth"),
    )
    for each in scope.GetPrimTypeInfo().GetAppliedAPISchemas():
        instance = each.partition("RigUIPartAPI:")[2]
        if instance and value(scope, f"rigUI:part:{instance}:name", instance) == part:
            view = value(scope, f"rigUI:part:{instance}:viewDirection", (0, 0, 1))
            width = value(scope, f"rigUI:part:{instance}:handleWidth", width)
    matrix = UsdGeom.XformCache().GetLocalToWorldTransform(scope.GetParent())
    towards = np.array(matrix.TransformDir(Gf.Vec3d(*view)))
    return towards / np.linalg.norm(towards), width * np.linalg.norm(towards)


def handles(mesh, part):
    """Of the elements on the skin whose handles a mesh draws: name, the middle of the drawn dome in
    the world at rest, and its colour in linear light."""
    if value(mesh, "rigUI:drawing:part", "") not in ("", part):
        return
    counts = np.array(mesh.GetAttribute("faceVertexCounts").Get())
    corners = np.split(
        np.array(mesh.GetAttribute("faceVertexIndices").Get()), np.cumsum(counts)[:-1]
    )
    to_world = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(mesh))
    bind = np.array(value(mesh, "primvars:skel:geomBindTransform", Gf.Matrix4d(1)))
    points = np.array(mesh.GetAttribute("points").Get(), dtype=float)
    placed = np.c_[points, np.ones(len(points))] @ bind @ to_world
    roles, colours = (per_face(mesh, name, len(counts)) for name in ("rigUI:role", "displayColor"))
    for subset in mesh.GetChildren():
        if (
            has(subset, "RigUIElementAPI")
            and subset.GetRelationship("rigUI:anchor:prim").GetTargets()
        ):
            faces = [
                each for each in subset.GetAttribute("indices").Get() if roles[each] == "handle"
            ]
            dome = sorted({int(corner) for each in faces for corner in corners[each]})
            yield {
                "name": subset.GetName(),
                "centre": placed[dome[1:], :3].mean(axis=0),
                "colour": colours[faces[0]],
            }


def per_face(mesh, name, count):
    primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar(name)
    held = list(primvar.Get())
    return (
        [held[i] for i in primvar.GetIndices()]
        if primvar.IsIndexed()
        else held * (count // len(held))
    )


# --- the pictures ---------------------------------------------------------------------------------


def storm(stage, scope, _, target, middle, size, basis):
    """By Hydra Storm, with the skin in grey."""
    gl_context()
    for prim in stage.Traverse():
        if prim.IsA(UsdGeom.Mesh) and prim.GetParent() != scope:
            UsdGeom.Gprim(prim).CreateDisplayColorAttr(Vt.Vec3fArray([Gf.Vec3f(GREY)]))
            UsdGeom.PrimvarsAPI(prim).GetPrimvar("displayColor").SetInterpolation("constant")
            UsdGeom.PrimvarsAPI(prim).GetPrimvar("displayColor").BlockIndices()
            for each in (prim, *prim.GetChildren()):
                if each.GetRelationship("material:binding"):
                    each.GetRelationship("material:binding").SetTargets([])
    camera = UsdGeom.Camera.Define(stage, "/RendersCamera")
    camera.CreateProjectionAttr("orthographic")
    camera.CreateHorizontalApertureAttr(size * 10.0)
    camera.CreateVerticalApertureAttr(size * 10.0)
    camera.CreateClippingRangeAttr(Gf.Vec2f(0.01 * size, 20.0 * size))
    matrix = np.eye(4)
    matrix[:3, :3], matrix[3, :3] = basis.T, middle + 5.0 * size * basis[:, 2]
    camera.ClearXformOpOrder()
    camera.MakeMatrixXform().Set(Gf.Matrix4d(matrix.tolist()))
    recorder = UsdAppUtils.FrameRecorder()
    recorder.SetRendererPlugin("HdStormRendererPlugin")
    recorder.SetImageWidth(PIXELS)
    recorder.SetIncludedPurposes(["guide"])
    recorder.Record(stage, camera, Usd.TimeCode.Default(), target)


def gl_context(made=[]):  # noqa: B006
    """A current OpenGL context of EGL that draws on no surface."""
    if made:
        return
    egl = ctypes.CDLL("libEGL.so.1")
    for name in ("eglGetPlatformDisplay", "eglCreateContext"):
        getattr(egl, name).restype = ctypes.c_void_p
    display = ctypes.c_void_p(egl.eglGetPlatformDisplay(0x31DD, None, None))
    egl.eglInitialize(display, None, None)
    egl.eglBindAPI(0x30A2)
    wanted = (ctypes.c_int * 5)(0x3040, 0x0008, 0x3033, 0x0001, 0x3038)
    config, count = ctypes.c_void_p(), ctypes.c_int()
    egl.eglChooseConfig(display, wanted, ctypes.byref(config), 1, ctypes.byref(count))
    version = (ctypes.c_int * 7)(0x3098, 4, 0x30FB, 5, 0x30FD, 2, 0x3038)
    made.append(ctypes.c_void_p(egl.eglCreateContext(display, config, None, version)))
    egl.eglMakeCurrent(display, None, None, made[0])


def blender(stage, scope, engine, target, middle, size, basis):
    """By Cycles or EEVEE, as Blender imports the layer, at its first frame."""
    from mathutils import Matrix

    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.usd_import(
        filepath=stage.GetRootLayer().realPath, import_guide=True, apply_unit_conversion_scale=False
    )
    scene, names = bpy.context.scene, {each.GetName() for each in scope.GetChildren()}
    shown = {True: colours("displayColor"), False: colours("")}
    for each in bpy.data.objects:
        if each.type == "MESH":
            guide = each.name.partition(".")[0] in names
            each.hide_render = guide and each.hide_get()
            each.data.materials.clear()
            each.data.materials.append(shown[guide])
    # Blender has the up axis of the stage along z.
    turned = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
    turned = turned if UsdGeom.GetStageUpAxis(stage) == "Y" else Matrix.Identity(4)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = basis, middle + 5.0 * size * basis[:, 2]
    lens = bpy.data.cameras.new("camera")
    lens.type, lens.ortho_scale, lens.clip_start, lens.clip_end = (
        "ORTHO",
        size,
        0.01 * size,
        20 * size,
    )
    camera, sun = bpy.data.objects.new("camera", lens), bpy.data.lights.new("sun", "SUN")
    camera.matrix_world = turned @ Matrix(matrix.tolist())
    light, sun.energy = bpy.data.objects.new("sun", sun), 2.0
    light.matrix_world = (
        camera.matrix_world @ Matrix.Rotation(0.5, 4, "X") @ Matrix.Rotation(0.4, 4, "Y")
    )
    for each in (camera, light):
        scene.collection.objects.link(each)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.4, 0.4, 0.4, 1.0)
    scene.camera, scene.view_settings.view_transform = camera, "Standard"
    scene.render.resolution_x = scene.render.resolution_y = PIXELS
    scene.render.engine = "CYCLES" if engine == "cycles" else "BLENDER_EEVEE_NEXT"
    scene.cycles.samples, scene.eevee.taa_render_samples = 8, 4
    scene.render.filepath = target
    bpy.ops.render.render(write_still=True)


def colours(attribute):
    """A material of a colour attribute, or grey."""
    material = bpy.data.materials.new(attribute or "skin")
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = 0.8
    shader.inputs["Base Color"].default_value = (GREY, GREY, GREY, 1.0)
    if attribute:
        node = material.node_tree.nodes.new("ShaderNodeAttribute")
        node.attribute_name = attribute
        material.node_tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    return material


# --- what is in them ------------------------------------------------------------------------------


def pixels(path):
    """(h, w, 3) in linear light, the lowest row first."""
    image = bpy.data.images.load(str(path))
    raw = np.array(image.pixels[:], dtype=float).reshape(image.size[1], image.size[0], -1)[..., :3]
    bpy.data.images.remove(image)
    return np.where(raw <= 0.04045, raw / 12.92, ((raw + 0.055) / 1.055) ** 2.4)


def circle(picture, place, width, size):
    """(n, 3) pixels of the circle of a handle."""
    scale = len(picture) / size
    x, y = 0.5 * len(picture) + scale * place[0], 0.5 * len(picture) + scale * place[1]
    rows, columns = np.mgrid[: len(picture), : len(picture)] + 0.5
    return picture[(rows - y) ** 2 + (columns - x) ** 2 <= (0.5 * width * scale) ** 2]


def hue(colour):
    """(..., 2) opponent axes over the lightest channel: zero for grey."""
    red, green, blue = np.moveaxis(np.asarray(colour, dtype=float), -1, 0)
    axes = np.stack([red - 0.5 * (green + blue), 0.866 * (green - blue)], axis=-1)
    return axes / np.maximum(np.max(colour, axis=-1), 1e-6)[..., None]


def score(seen, palette, own):
    """The share of pixels with the hue of a colour, and how much more that is than of any other."""
    if not len(seen):
        return 0.0, 0.0
    found, names = hue(seen), list(palette)
    towards = np.stack([palette[each] / np.linalg.norm(palette[each]) for each in names])
    nearest = (found @ towards.T).argmax(axis=1)
    nearest[np.linalg.norm(found, axis=1) < COLOURFUL] = -1
    shares = [float((nearest == i).mean()) for i in range(len(names))]
    mine = shares.pop(names.index(own))
    return mine, mine - max(shares, default=0.0)


if __name__ == "__main__":
    raise SystemExit(main())
