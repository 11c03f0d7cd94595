"""UsdSkel's own answer to where a rig's points are: the reference for `usdrigui.character.deform`.

`Oracle` asks UsdSkel's queries, pose after pose, without writing points; `baked` goes through
`UsdSkel.BakeSkinning`, the whole of UsdSkel, for small stages.  Both write the pose into SkelAnimations of
the session layer of their own stage.
"""

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, Vt


def _author_pose(stage, rig, weights, local, exact=False):
    """Bind a SkelAnimation with every channel and joint to each Skeleton, in the session layer.

    A SkelAnimation holds scales in half precision; `exact` puts the joints into the rest transforms instead.
    """
    stage.SetEditTarget(stage.GetSessionLayer())
    for index, skeleton in enumerate(rig.body.skeletons):
        path = Sdf.Path(rig.path).AppendChild(f"OracleAnimation{index}")
        animation = UsdSkel.Animation.Define(stage, path)
        mine = [i for i, each in enumerate(rig.body.channels) if each.animation in ("", skeleton.animation)]
        animation.CreateBlendShapesAttr(Vt.TokenArray([rig.body.channels[i].token for i in mine]))
        animation.CreateBlendShapeWeightsAttr(Vt.FloatArray.FromNumpy(weights[mine].astype(np.float32)))
        joints = [i for i, each in enumerate(rig.body.joints) if each.skeleton == index]
        matrices = Vt.Matrix4dArray([Gf.Matrix4d(local[i].tolist()) for i in joints])
        if joints and exact:
            UsdSkel.Skeleton(stage.GetPrimAtPath(skeleton.path)).GetRestTransformsAttr().Set(matrices)
        elif joints:
            animation.CreateJointsAttr(Vt.TokenArray([rig.body.joints[i].path for i in joints]))
            animation.SetTransforms(matrices)
        binding = UsdSkel.BindingAPI.Apply(stage.GetPrimAtPath(skeleton.path))
        binding.CreateAnimationSourceRel().SetTargets([path])


def _placed(points, matrix):
    m = np.array(matrix)
    return np.asarray(points, dtype=np.float64) @ m[:3, :3] + m[3, :3]


def baked(path, rig, weights, local):
    """(n, 3) points of `rig.body.meshes` in root space at a pose, from `UsdSkel.BakeSkinning`."""
    stage = Usd.Stage.Open(str(path))
    _author_pose(stage, rig, weights, local, exact=True)
    root = UsdSkel.Root(stage.GetPrimAtPath(rig.path))
    assert UsdSkel.BakeSkinning(root, Gf.Interval(1, 1))
    cache = UsdGeom.XformCache(Usd.TimeCode(1))
    world_to_root = cache.GetLocalToWorldTransform(root.GetPrim()).GetInverse()
    found = []
    for mesh in rig.body.meshes:
        prim = stage.GetPrimAtPath(mesh.path)
        points = UsdGeom.Mesh(prim).GetPointsAttr().Get(1)
        found.append(_placed(points, cache.GetLocalToWorldTransform(prim) * world_to_root))
    return np.concatenate(found)


class Oracle:
    """UsdSkel's queries over one rig."""

    def __init__(self, path, rig):
        self.rig = rig
        self.stage = Usd.Stage.Open(str(path))
        _author_pose(self.stage, rig, rig.body.base_weights, np.array([joint.base for joint in rig.body.joints]))
        self.root = UsdSkel.Root(self.stage.GetPrimAtPath(rig.path))
        self.cache = UsdSkel.Cache()
        self.cache.Populate(self.root, Usd.PrimDefaultPredicate)
        bindings = self.cache.ComputeSkelBindings(self.root, Usd.PrimDefaultPredicate)
        self.queries = {
            str(query.GetPrim().GetPath()): (binding.GetSkeleton(), query, _shapes(query))
            for binding in bindings
            for query in binding.GetSkinningTargets()
        }
        self.points = {mesh.path: _mesh_points(self.stage, mesh.path) for mesh in rig.body.meshes}

    def deformed(self, weights, local):
        """(n, 3) points in root space at channel weights (channels,) and local transforms (joints, 4, 4)."""
        for index, skeleton in enumerate(self.rig.body.skeletons):
            prim = self.stage.GetPrimAtPath(Sdf.Path(self.rig.path).AppendChild(f"OracleAnimation{index}"))
            animation = UsdSkel.Animation(prim)
            mine = [i for i, each in enumerate(self.rig.body.channels) if each.animation in ("", skeleton.animation)]
            animation.GetBlendShapeWeightsAttr().Set(Vt.FloatArray.FromNumpy(weights[mine].astype(np.float32)))
            joints = [i for i, each in enumerate(self.rig.body.joints) if each.skeleton == index]
            if joints:
                animation.SetTransforms(Vt.Matrix4dArray([Gf.Matrix4d(local[i].tolist()) for i in joints]))
        xforms = UsdGeom.XformCache()
        world_to_root = xforms.GetLocalToWorldTransform(self.root.GetPrim()).GetInverse()
        return np.concatenate([self._mesh(mesh.path, xforms, world_to_root) for mesh in self.rig.body.meshes])

    def _mesh(self, path, xforms, world_to_root):
        points = Vt.Vec3fArray(self.points[path])
        prim = self.stage.GetPrimAtPath(path)
        if path in self.queries:
            skeleton, query, shapes = self.queries[path]
            skel_query = self.cache.GetSkelQuery(skeleton)
            if shapes is not None:
                assert _blend(skel_query, query, shapes, points)
            if query.HasJointInfluences() and len(skel_query.GetJointOrder()):
                matrices = skel_query.ComputeSkinningTransforms(Usd.TimeCode.Default())
                assert query.ComputeSkinnedPoints(matrices, points, Usd.TimeCode.Default())
                prim = skeleton.GetPrim()
        return _placed(points, xforms.GetLocalToWorldTransform(prim) * world_to_root)


def deformed_points(stage, root, path, time):
    """(n, 3) points of any gprim in the space of its SkelRoot, as the stage animates it; instance proxies, too."""
    root, prim, everything = UsdSkel.Root(stage.GetPrimAtPath(root)), stage.GetPrimAtPath(path), _PROXIES
    cache, xforms = UsdSkel.Cache(), UsdGeom.XformCache(time)
    cache.Populate(root, everything)
    points = Vt.Vec3fArray(UsdGeom.PointBased(prim).GetPointsAttr().Get(time))
    for binding in cache.ComputeSkelBindings(root, everything):
        for query in binding.GetSkinningTargets():
            if query.GetPrim().GetPath() == prim.GetPath():
                skel_query, shapes = cache.GetSkelQuery(binding.GetSkeleton()), _shapes(query)
                if shapes is not None:
                    assert _blend(skel_query, query, shapes, points, time)
                if query.HasJointInfluences():
                    matrices = skel_query.ComputeSkinningTransforms(time)
                    assert query.ComputeSkinnedPoints(matrices, points, time)
                    prim = binding.GetSkeleton().GetPrim()
                break
    to_root = xforms.GetLocalToWorldTransform(root.GetPrim()).GetInverse()
    return _placed(points, xforms.GetLocalToWorldTransform(prim) * to_root)


_PROXIES = Usd.TraverseInstanceProxies()


def _mesh_points(stage, path):
    attribute = UsdGeom.Mesh(stage.GetPrimAtPath(path)).GetPointsAttr()
    points = attribute.Get()
    return attribute.Get(Usd.TimeCode.EarliestTime()) if points is None else points


def _shapes(query):
    if not query.HasBlendShapes():
        return None
    shapes = UsdSkel.BlendShapeQuery(UsdSkel.BindingAPI(query.GetPrim()))
    return shapes, shapes.ComputeBlendShapePointIndices(), shapes.ComputeSubShapePointOffsets()


def _blend(skel_query, query, shapes, points, time=None):
    shape_query, indices, offsets = shapes
    authored = skel_query.GetAnimQuery().ComputeBlendShapeWeights(Usd.TimeCode.Default() if time is None else time)
    mapper = query.GetBlendShapeMapper()
    weights = mapper.Remap(authored) if mapper is not None else authored
    sub = shape_query.ComputeSubShapeWeights(weights)
    return shape_query.ComputeDeformedPoints(*sub, indices, offsets, points)
