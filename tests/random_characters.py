"""Random animated characters, and how far what the viewer shows of one is from what USD evaluates."""

import numpy as np
from pxr import Sdf, Usd, UsdSkel
from skel_stages import add_animation, add_mesh, add_shape, add_skeleton, add_skin, matrix, new_stage


def random_character(path, rng):
    """A character of one or two Skeletons, with and without joints and clips, and tokens that no animation lists.

    The file is read through a shot that may put it later, slower and at another rate.
    """
    stage, root = new_stage(path.with_name("asset.usda"))
    for index in range(rng.integers(1, 3)):
        _part(stage, root, index, rng)
    stage.SetTimeCodesPerSecond(float(rng.choice([24, 30])))
    stage.GetRootLayer().Save()
    shot = Sdf.Layer.CreateNew(str(path))
    shot.subLayerPaths = ["./asset.usda"]
    shot.subLayerOffsets[0] = Sdf.LayerOffset(float(rng.choice([0, 10])), float(rng.choice([1, 2])))
    shot.defaultPrim = "Char"
    shot.timeCodesPerSecond = float(rng.choice([24, 25]))
    shot.Save()


def _part(stage, root, index, rng):
    skeleton, animation = f"/Char/Skel{index}", f"/Clips/Anim{index}"
    joints = ("neck", "neck/jaw")[: rng.integers(0, 3)]
    scales = rng.choice([0.5, 1.0, 1.0, 2.0], (2, 3))
    rest = [_transform(rng, scales[i]) for i, _ in enumerate(joints)]
    add_skeleton(stage, skeleton, joints, rest)
    mesh = add_mesh(stage, f"/Char/Face{index}", skeleton, seed=index, side=3)
    if joints:
        add_skin(mesh, [[0, len(joints) - 1]] * 9, rng.dirichlet([1, 1], 9), 2)
    tokens = (f"a{index}", f"b{index}", "shared", f"lone{index}")
    for token in tokens:
        add_shape(mesh, token, rng.normal(size=(9, 3)))
    kind = rng.choice(["clip", "still", "none"], p=[0.7, 0.15, 0.15])
    if kind == "none":
        return
    times = [None] if kind == "still" else np.unique(rng.choice(np.arange(1, 13, 0.5), rng.integers(1, 6))).tolist()
    listed = [*rng.permutation(tokens[:3]).tolist(), "unused"]
    weights = {time: rng.uniform(-0.5, 1.5, len(listed)) * (rng.random(len(listed)) < 0.7) for time in times}
    turned = (
        {time: [_transform(rng, scales[i]) for i, _ in enumerate(joints)] for time in times}
        if rng.random() < 0.7
        else {}
    )
    add_animation(stage, animation, None, listed, weights, joints if turned else (), turned)
    bound = stage.GetPrimAtPath(skeleton) if index or rng.random() < 0.5 else root
    UsdSkel.BindingAPI.Apply(bound).CreateAnimationSourceRel().SetTargets([animation])


def _transform(rng, scale):
    return matrix(rng.uniform(-60, 60, 3), rng.uniform(-2, 2, 3), scale)


def composed(path, layer, source):
    """A stage of the saved layer, written to `path`, over its source."""
    path.write_text(layer)
    root = Sdf.Layer.CreateAnonymous(".usda")
    root.subLayerPaths = [str(path), str(source)]
    root.timeCodesPerSecond = Sdf.Layer.FindOrOpen(str(source)).timeCodesPerSecond
    return Usd.Stage.Open(root)


class Evaluated:
    """Weights by channel and local joint transforms as UsdSkel has them."""

    def __init__(self, stage, rig):
        self.rig = rig
        self.cache = UsdSkel.Cache()
        self.cache.Populate(UsdSkel.Root(stage.GetPrimAtPath(rig.path)), Usd.PrimDefaultPredicate)
        skeletons = [UsdSkel.Skeleton(stage.GetPrimAtPath(each.path)) for each in rig.body.skeletons]
        self.queries = [self.cache.GetSkelQuery(each) for each in skeletons]

    def weights(self, time):
        """(channels,) weights; 0 of those that no animation drives."""
        found, listed = {}, {(each.token, each.animation) for each in self.rig.body.channels}
        for skeleton, query in zip(self.rig.body.skeletons, self.queries, strict=True):
            animation = query.GetAnimQuery()
            if animation:
                values = animation.ComputeBlendShapeWeights(time) or []
                for token, value in zip(animation.GetBlendShapeOrder(), values, strict=bool(values)):
                    key = str(token), skeleton.animation
                    found[key if key in listed else (str(token), "")] = value
        return [found.get((each.token, each.animation), 0.0) for each in self.rig.body.channels]

    def locals(self, time):
        rows = [
            matrix for query in self.queries for matrix in query.ComputeJointLocalTransforms(Usd.TimeCode(time), False)
        ]
        return np.array(rows).reshape(-1, 16)


def off(shown, stage, rig, time):
    evaluated = Evaluated(stage, rig)
    locals_ = np.array(shown["locals"]).reshape(-1, 16)
    of_weights = np.abs(np.array(shown["weights"]) - evaluated.weights(time)).max(initial=0.0)
    of_joints = (np.abs(locals_ - evaluated.locals(time)) / np.maximum(1.0, np.abs(locals_))).max(initial=0.0)
    return of_weights, of_joints
