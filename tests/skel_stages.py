"""Small UsdSkel stages written to disk, for tests of reading.

`character` writes one that has everything at once: two Skeletons, linear, dual-quaternion and rigid skins,
shared tokens in different orders, in-betweens below 0 and above 1, geomBindTransforms, a joint subset, a
rotated and scaled SkelRoot, Z up, metres.  `head` is a plain one to break or vary.
"""

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, Vt

SIDE = 5


def grid(side=SIDE, size=1.0, seed=0):
    """Points (side^2, 3) of a bumpy sheet and its quads."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.linspace(-size, size, side), np.linspace(-size, size, side))
    points = np.stack([x, y, 0.2 * rng.normal(size=x.shape)], axis=-1).reshape(-1, 3)
    return points, quads(side)


def quads(side):
    """The quads of a sheet of side^2 points, row by row."""
    corner = np.arange(side * side).reshape(side, side)[:-1, :-1].ravel()
    return np.stack([corner, corner + 1, corner + side + 1, corner + side], axis=1)


def matrix(rotation=(0.0, 0.0, 0.0), translation=(0.0, 0.0, 0.0), scale=(1.0, 1.0, 1.0)):
    """Gf.Matrix4d that scales, rotates by an axis times degrees, and translates."""
    angle = float(np.linalg.norm(rotation))
    axis = Gf.Vec3d(*rotation) if angle else Gf.Vec3d(1, 0, 0)
    turned = Gf.Matrix4d().SetRotate(Gf.Rotation(axis, angle))
    return Gf.Matrix4d().SetScale(Gf.Vec3d(*scale)) * turned * Gf.Matrix4d().SetTranslate(Gf.Vec3d(*translation))


def add_mesh(stage, path, skeleton=None, seed=0, transform=None, side=SIDE):
    """A grid mesh bound to a Skeleton."""
    points, quads = grid(side, seed=seed)
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points.astype(np.float32)))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray([4] * len(quads)))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(quads.ravel().astype(np.int32)))
    if transform is not None:
        mesh.AddTransformOp().Set(transform)
    if skeleton is not None:
        UsdSkel.BindingAPI.Apply(mesh.GetPrim()).CreateSkeletonRel().SetTargets([skeleton])
    return mesh


EVEN = np.ones((SIDE**2, 3))
"""Every point of a mesh by one unit along each axis."""


def add_shape(mesh, token, offsets=EVEN, indices=None, inbetweens=None):
    """Append a BlendShape of `offsets` (p, 3); `inbetweens` maps weights to offsets."""
    prim = mesh.GetPrim()
    api = UsdSkel.BindingAPI.Apply(prim)
    path = prim.GetPath().AppendChild("s_" + "".join(c if c.isalnum() else "_" for c in token))
    shape = UsdSkel.BlendShape.Define(prim.GetStage(), path)
    shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(np.asarray(offsets, dtype=np.float32)))
    if indices is not None:
        shape.CreatePointIndicesAttr(Vt.IntArray([*map(int, indices)]))
    for i, (weight, between) in enumerate((inbetweens or {}).items()):
        each = shape.CreateInbetween(f"b{i}")
        each.SetWeight(weight)
        each.SetOffsets(Vt.Vec3fArray.FromNumpy(np.asarray(between, dtype=np.float32)))
    api.CreateBlendShapesAttr(Vt.TokenArray([*(api.GetBlendShapesAttr().Get() or ()), token]))
    api.CreateBlendShapeTargetsRel().AddTarget(path)
    return shape


def add_skin(mesh, indices, weights, width, geom_bind=None, method=None, joints=None, rigid=False):
    """Joint influences; `joints` is the mesh's own joint order."""
    api = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    api.CreateJointIndicesPrimvar(rigid, width).Set(Vt.IntArray([*map(int, np.ravel(indices))]))
    api.CreateJointWeightsPrimvar(rigid, width).Set(Vt.FloatArray([*map(float, np.ravel(weights))]))
    if geom_bind is not None:
        api.CreateGeomBindTransformAttr(geom_bind)
    if method is not None:
        api.CreateSkinningMethodAttr(method)
    if joints is not None:
        api.CreateJointsAttr(Vt.TokenArray(joints))


def add_even_skin(mesh, count, *more):
    """Each of the SIDE**2 points follows the first `count` joints alike."""
    indices, weights = [range(count)] * SIDE**2, [[1.0 / count] * count] * SIDE**2
    add_skin(mesh, indices, weights, count, *more)


def add_skeleton(stage, path, joints=(), rest=(), bind=None, transform=None):
    """A Skeleton; bind transforms default to the accumulated rest transforms."""
    skeleton = UsdSkel.Skeleton.Define(stage, path)
    if joints:
        world = {}
        for name, local in zip(joints, rest, strict=True):
            parent = name.rpartition("/")[0]
            world[name] = local * world[parent] if parent else local
        skeleton.CreateJointsAttr(Vt.TokenArray(joints))
        skeleton.CreateRestTransformsAttr(Vt.Matrix4dArray(list(rest)))
        skeleton.CreateBindTransformsAttr(Vt.Matrix4dArray(bind or list(world.values())))
    if transform is not None:
        skeleton.AddTransformOp().Set(transform)
    return skeleton


def add_animation(stage, path, skeleton=None, tokens=(), weights=None, joints=(), transforms=None):
    """A SkelAnimation; `weights` and `transforms` map times (None for the default) to values."""
    animation = UsdSkel.Animation.Define(stage, path)
    if tokens:
        animation.CreateBlendShapesAttr(Vt.TokenArray(tokens))
        attribute = animation.CreateBlendShapeWeightsAttr()
        for time, values in (weights or {None: [0.0] * len(tokens)}).items():
            attribute.Set(Vt.FloatArray([float(v) for v in values]), _code(time))
    if joints:
        animation.CreateJointsAttr(Vt.TokenArray(joints))
        for time, values in (transforms or {}).items():
            animation.SetTransforms(Vt.Matrix4dArray(list(values)), _code(time))
    if skeleton is not None:
        UsdSkel.BindingAPI.Apply(stage.GetPrimAtPath(skeleton)).CreateAnimationSourceRel().SetTargets([path])
    return animation


def _code(time):
    return Usd.TimeCode.Default() if time is None else Usd.TimeCode(time)


def new_stage(path, root="/Char"):
    """An empty stage to be saved at `path`, with a SkelRoot as default prim."""
    stage = Usd.Stage.CreateNew(str(path))
    prim = UsdSkel.Root.Define(stage, root).GetPrim()
    stage.SetDefaultPrim(stage.GetPrimAtPath(Sdf.Path(root).GetPrefixes()[0]))
    return stage, prim


def head(path, tokens=("smile", "frown"), edit=None):
    """One mesh, one Skeleton without joints, one dense shape per token; `edit(stage)` may spoil it."""
    stage, _ = new_stage(path)
    add_skeleton(stage, "/Char/Skel")
    mesh = add_mesh(stage, "/Char/Face", "/Char/Skel")
    rng = np.random.default_rng(3)
    for token in tokens:
        add_shape(mesh, token, rng.normal(size=(SIDE * SIDE, 3)))
    add_animation(stage, "/Char/Anim", "/Char/Skel", tokens)
    if edit is not None:
        edit(stage)
    stage.GetRootLayer().Save()
    return path


JOINTS = ("neck", "neck/jaw", "neck/jaw/lip")


def posed(path, names):
    """A mesh on two joints with a pose on each of four frames, named by `names`."""
    stage, _ = new_stage(path)
    rest = (matrix(), matrix(translation=(0, 1, 0)))
    add_skeleton(stage, "/Char/Skel", ("a", "a/b"), rest)
    mesh = add_mesh(stage, "/Char/Face", "/Char/Skel")
    add_even_skin(mesh, 2)
    frames = {
        0.0: rest,
        1.0: (rest[0], matrix((0, 0, 30), (0, 1, 0))),
        2.0: (matrix((0, 0, 0), (0, 0, 2)), rest[1]),
        3.0: rest,
    }
    add_animation(stage, "/Char/Anim", "/Char/Skel", (), None, ("a", "a/b"), frames)
    if names is not None:
        stage.GetRootLayer().customLayerData = {"framemapping": names}
    stage.GetRootLayer().Save()
    return path


def character(path):
    """Everything at once; see the module's docstring."""
    stage, root = new_stage(path, "/World/Char")
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    UsdGeom.Xform(stage.DefinePrim("/World", "Xform")).AddTransformOp().Set(matrix((0, 0, 40), (1, 2, 3)))
    UsdGeom.Xformable(root).AddTransformOp().Set(matrix((30, 10, 0), (-4, 0, 1), (2, 2, 2)))
    _first_skeleton(stage)
    _second_skeleton(stage)
    rng = np.random.default_rng(7)
    _face(stage, rng)
    _teeth(stage, rng)
    _tongue(stage, rng)
    eye = add_mesh(stage, "/World/Char/Geo/Eye", seed=4, transform=matrix((0, 20, 0), (0, 1, 0)))
    add_skin(eye, [1, 2], [0.25, 0.75], 2, matrix((0, 0, 15), (0.1, 0, 0)), rigid=True)
    hat = add_mesh(stage, "/World/Char/Geo/Hat", seed=5, transform=matrix((0, 50, 0), (0, 3, 0), (1, 2, 1)))
    add_shape(hat, "smile", rng.normal(size=(SIDE**2, 3)))
    hair = add_mesh(stage, "/World/Char/Geo/Hair", seed=6, transform=matrix((10, 50, 0), (0, 3, 1)))
    hair.CreateOrientationAttr(UsdGeom.Tokens.leftHanded)
    hair.CreateVisibilityAttr(UsdGeom.Tokens.invisible)
    stage.GetRootLayer().Save()
    return path


def _first_skeleton(stage):
    """Bound by inheritance: the relationship stands on the Scope above the meshes."""
    rest = (matrix((0, 0, 10), (0, 0, 1)), matrix((20, 0, 0), (0, 0.5, 0.2)), matrix((0, 5, 5), (0.3, 0, 0)))
    bind = [matrix((0, 0, 12), (0, 0, 1)), matrix((22, 0, 3), (0, 0.6, 1.2)), matrix((20, 5, 9), (0.3, 0.7, 1.2))]
    add_skeleton(stage, "/World/Char/Skel", JOINTS, rest, bind, matrix((0, 0, 90), (0, 0, 0.5)))
    add_animation(
        stage,
        "/World/Char/Anim",
        None,
        ("blink", "smile", "jaw", "unused"),
        {0.0: [0, 0, 0, 0], 10.0: [1, -0.7, 0.3, 1]},
        JOINTS[:2],
        {
            0.0: rest[:2],
            10.0: (matrix((0, 40, 10), (0, 0, 1)), matrix((60, 0, 0), (0, 0.5, 0.4), (1.25, 1, 0.5))),
        },
    )
    scope = UsdGeom.Scope.Define(stage, "/World/Char/Geo").GetPrim()
    UsdSkel.BindingAPI.Apply(scope).CreateSkeletonRel().SetTargets(["/World/Char/Skel"])
    # The animation source is inherited too: it stands on the SkelRoot, above the Skeleton.
    root = stage.GetPrimAtPath("/World/Char")
    UsdSkel.BindingAPI.Apply(root).CreateAnimationSourceRel().SetTargets(["/World/Char/Anim"])


def _second_skeleton(stage):
    rest = (matrix((0, 15, 0), (0, 1, 0)), matrix((0, 0, 30), (0, 0.5, 0)))
    add_skeleton(stage, "/World/Char/Skel2", ("root", "root/tip"), rest, None, matrix((45, 0, 0), (1, 0, 0)))
    add_animation(
        stage,
        "/World/Char/Anim2",
        "/World/Char/Skel2",
        ("tongueOut", "smile"),
        None,
        ("root/tip",),
        {0.0: rest[1:], 10.0: (matrix((80, 0, 30), (0, 0.5, 0)),)},
    )


def _face(stage, rng):
    face = add_mesh(stage, "/World/Char/Geo/Face", seed=1, transform=matrix((0, 0, 33), (5, 5, 5)))
    add_shape(face, "smile", rng.normal(size=(4, 3)), [9, 2, 17, 2])
    between = {weight: rng.normal(size=(SIDE**2, 3)) for weight in (-0.5, 0.5, 1.5)}
    add_shape(face, "jaw", rng.normal(size=(SIDE**2, 3)), inbetweens=between)
    add_shape(face, "blink", rng.normal(size=(3, 3)), [1, 5, 7], {0.25: rng.normal(size=(3, 3))})
    weights = rng.dirichlet([1, 1, 1], SIDE**2)
    add_skin(face, [[0, 1, 2]] * SIDE**2, weights, 3, matrix((0, 25, 0), (0, 0, 0.7)))


def _teeth(stage, rng):
    teeth = add_mesh(stage, "/World/Char/Geo/Teeth", seed=2)
    add_shape(teeth, "jaw", rng.normal(size=(SIDE**2, 3)))
    add_shape(teeth, "smile", rng.normal(size=(SIDE**2, 3)))
    weights = rng.dirichlet([1, 1], SIDE**2)
    add_skin(teeth, [[1, 0]] * SIDE**2, weights, 2, matrix((9, 0, 0)), "dualQuaternion", ["neck/jaw", "neck/jaw/lip"])


def _tongue(stage, rng):
    tongue = add_mesh(stage, "/World/Char/Tongue", "/World/Char/Skel2", seed=3)
    add_shape(tongue, "tongueOut", rng.normal(size=(SIDE**2, 3)))
    add_shape(tongue, "smile", rng.normal(size=(SIDE**2, 3)))
    weights = rng.dirichlet([1, 1], SIDE**2)
    add_skin(tongue, [[0, 1]] * SIDE**2, weights, 2, None, "dualQuaternion")
