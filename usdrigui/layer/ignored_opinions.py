"""Opinions about a layout that say nothing, as no prim is where they are."""

from __future__ import annotations

from pxr import Sdf, Usd

from usdrigui.errors import Issue, issue, listed, meant
from usdrigui.layer.properties import element_name, instances_applied
from usdrigui.layer.read_layout import element_prims, layout_scopes
from usdrigui.stages import schema
from usdrigui.stages.opening import spec_paths


def ignored_opinions(stage: Usd.Stage) -> tuple[Issue, ...]:
    """OPINION_IGNORED for each prim of the stage's own layers with properties of our schemas where
    nothing is defined, with the element that is likely meant."""
    known = _elements(stage)
    specs = [
        layer.GetPrimAtPath(path)
        for layer in stage.GetLayerStack(includeSessionLayers=False)
        for path in spec_paths(layer)
        if path.IsPrimPath()
    ]
    defined = {_plain(spec) for spec in specs if spec.specifier == Sdf.SpecifierDef}
    found: dict[Issue, None] = {}
    for spec in specs:
        path = _plain(spec)
        prim = stage.GetPrimAtPath(path)
        # Views of Sdf iterate over specs, not over names.
        names = [each for each in spec.properties.keys() if each.startswith("rigUI:")]  # noqa: SIM118
        if names and path not in defined and not (prim and prim.IsDefined()):
            likely, layer = known.get(spec.name), spec.layer.realPath or spec.layer.identifier
            hint = f"; {likely} is likely meant" if likely else meant(spec.name, known)
            what = f"has {listed(names)} in {layer}, and no prim is there{hint}"
            found[issue("OPINION_IGNORED", path, what)] = None
    return tuple(found)


def _elements(stage: Usd.Stage) -> dict[str, str]:
    """The path of an element by each name for it: those of its controls, its prim's and its own;
    the stronger the later."""
    prims = [prim for scope in layout_scopes(stage) for prim in element_prims(scope)]
    controls = {
        name: str(prim.GetPath())
        for prim in prims
        for name in instances_applied(prim, schema.CONTROL)
    }
    own = {n: str(p.GetPath()) for p in prims for n in (p.GetName(), element_name(p))}
    return controls | own


def _plain(spec: Sdf.PrimSpec) -> Sdf.Path:
    return spec.path.StripAllVariantSelections()
