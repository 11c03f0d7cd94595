"""Why UsdSkel moves a mesh by no Skeleton although one is named for it.

UsdSkel ignores a binding without a message, and the repairs differ: applying a schema,
giving a prim a type, or correcting a path.  Here the walk of `UsdSkel.Cache.Populate` is retraced
to name the cause.
"""

from __future__ import annotations

from collections.abc import Container, Iterable

from pxr import Sdf, Usd, UsdGeom, UsdSkel

from usdrigui.errors import Issue, issue

_SKELETON = "skel:skeleton"
_API = "SkelBindingAPI"


def why_unbound(prim: Usd.Prim) -> str:
    """What keeps the Skeleton that is named for a prim from it; empty where none is named.

    Only for prims below a SkelRoot that UsdSkel has bound to nothing.
    """
    chain = _up_to_skel_root(prim)
    named = [each for each in chain if each.GetRelationship(_SKELETON).HasAuthoredTargets()]
    if not named:
        return ""
    chosen = next((each for each in named if each.HasAPI(UsdSkel.BindingAPI)), None)
    if chosen is None:
        faults = [
            f"{_SKELETON} is authored on {named[0].GetPath()}, but {_API} is not applied there:"
            " apply it"
        ]
    else:
        faults = [_without_skeleton(chosen)]
    faults.append(_cut_off(chain[1:]))
    return "; ".join(filter(None, faults))


def bound_in_vain(
    stage: Usd.Stage, meshes: Iterable[str], bound: Container[Sdf.Path]
) -> tuple[Issue, ...]:
    """One for each of `meshes` that has joint influences and a Skeleton named, but none in `bound`.

    Meshes with blend shapes are left to `read_shapes`, which reports the same of them.
    """
    found = []
    for path in meshes:
        prim = stage.GetPrimAtPath(path)
        api = UsdSkel.BindingAPI(prim)
        if prim.GetPath() in bound or api.GetBlendShapeTargetsRel().HasAuthoredTargets():
            continue
        # Not asked of the API, whose primvars are invalid objects where it is not applied.
        indices = prim.GetAttribute("primvars:skel:jointIndices")
        if indices and indices.HasAuthoredValue() and (why := why_unbound(prim)):
            found.append(issue("MESH_UNBOUND", path, f"has joint influences; {why}"))
    return tuple(found)


def _up_to_skel_root(prim: Usd.Prim) -> list[Usd.Prim]:
    """The prim and those above it, the SkelRoot last: UsdSkel looks at nothing above that."""
    chain = [prim]
    while chain[-1].GetParent() and not chain[-1].IsA(UsdSkel.Root):
        chain.append(chain[-1].GetParent())
    return chain


def _without_skeleton(prim: Usd.Prim) -> str:
    """What is wrong with a binding that UsdSkel reads; empty if it leads to a Skeleton."""
    targets = prim.GetRelationship(_SKELETON).GetTargets()
    if not targets:
        return f"{_SKELETON} of {prim.GetPath()} has no target"
    skeleton = prim.GetStage().GetPrimAtPath(targets[0])
    if skeleton and skeleton.IsActive() and skeleton.IsA(UsdSkel.Skeleton):
        return ""
    return (
        f"{_SKELETON} of {prim.GetPath()} leads to {targets[0]}, which is not an active Skeleton:"
        " correct it"
    )


def _cut_off(above: list[Usd.Prim]) -> str:
    """Which of the prims above one, nearest first, UsdSkel does not look below; empty if none."""
    for prim in reversed(above):
        path, kind = prim.GetPath(), prim.GetTypeName()
        if not prim.IsA(UsdGeom.Imageable):
            what = f"is a {kind}, which is not imageable" if kind else "has no type"
            return f"{path} {what}, so that UsdSkel ignores all prims below it: make it an Xform"
        if prim.IsA(UsdGeom.PointBased):
            return (
                f"{path} is a {kind} itself, so that UsdSkel ignores all prims below it: move the"
                " mesh out"
            )
    return ""
