"""An animation layer that pages and programs write in turn: what a page is told of it, and how what
a page saves is put into it.

A page owns what pages have written, the samples of their keys and what binds these; the layer lists
each with a digest, by which an edit of a program is known.  All else is kept
(docs/decisions/079).
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from hashlib import sha256
from typing import Any

from pxr import Sdf, Tf, UsdUtils

from usdrigui.errors import refuse
from usdrigui.stages.opening import spec_paths, usd_message

_OWN = re.compile(
    r"blendShapes|blendShapeWeights|joints|rotations|scales|translations|rigUI:control:\w+:value"
)
"""Attributes that a page writes."""


def told(name: object, held: str) -> str:
    """What a page needs of the layer with the text `held`, as JSON: ``work``, what pages keep in
    it; ``changed``, the text by path of each attribute of a page's kind that is not as pages have
    ``written`` it; ``names``, the texts of those that list names.

    Raises FILE_NOT_USD, naming `name`.
    """
    layer = _read(held, name)
    written, there = _written(layer), _texts(layer)
    now = _digests(there)
    whole = {
        "work": _kept(layer).get("work", ""),
        "changed": {
            path: there.get(path, "")
            for path in written.keys() | now.keys()
            if written.get(path) != now.get(path)
        },
        "written": [*written],
        "names": {path: there[path] for path in there if path.endswith(("joints", "blendShapes"))},
    }
    return json.dumps(whole, sort_keys=True)


def merged(name: object, held: str, part: str) -> str:
    """The layer with the text `held` with the layer that a page saves, `part`, in place of what
    pages have written there before at paths that begin as the page's ``own`` do.

    Raises FILE_NOT_USD, naming `name`.
    """
    layer, given = _read(held, name), _read(part, name)
    kept, written, new = _kept(given), _written(layer), _digests(_texts(given))
    # A program's value is in the page's keys, also where the page cannot write samples of it.
    values = {path for path in _texts(layer) if path.endswith(":value")}
    old = {path for path in values.union(written) if path.startswith(tuple(kept["own"]))}
    for path in old.union(new):
        if attribute := layer.GetAttributeAtPath(path):
            for key in ("default", "timeSamples", "spline"):
                attribute.ClearInfo(key)
            layer.RemovePropertyIfHasOnlyRequiredFields(attribute)
    UsdUtils.StitchLayers(given, layer)
    others = {path: digest for path, digest in written.items() if path not in old}
    given.customLayerData = {
        **layer.customLayerData,
        "usdrigui": {"work": kept["work"], "written": {**others, **new}},
    }
    return str(given.ExportToString())


def _read(text: str, name: object) -> Sdf.Layer:
    layer = Sdf.Layer.CreateAnonymous(".usda")
    try:
        layer.ImportFromString(text or "#usda 1.0")
    except (Tf.ErrorException, UnicodeError) as error:
        raise refuse("FILE_NOT_USD", name, usd_message(error)) from None
    return layer


def _kept(layer: Sdf.Layer) -> dict[str, Any]:
    found = layer.customLayerData.get("usdrigui")
    return found if isinstance(found, dict) else {}


def _texts(layer: Sdf.Layer) -> dict[str, str]:
    """Of the attributes of a page's kind, by path."""
    named = (each for each in spec_paths(layer) if _OWN.fullmatch(each.name))
    own = map(layer.GetAttributeAtPath, named)
    return {str(each.path): each.GetAsText() for each in own if each}


def _digests(texts: Mapping[str, str]) -> dict[str, str]:
    return {path: sha256(texts[path].encode()).hexdigest()[:16] for path in texts}


def _written(layer: Sdf.Layer) -> dict[str, str]:
    """Digests of what pages have written.  The first versions, and "Save animation layer", list
    nothing: all is as a page has written it."""
    kept = _kept(layer)
    return dict(kept.get("written", _digests(_texts(layer)) if kept else {}))
