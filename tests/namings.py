"""Other names for the controls of a rig: what tools count, what studios prefix, and names that are wrong."""

import numpy as np
import rig_copies

_SYLLABLES = ("ka", "lo", "mi", "tu", "ren", "pas", "dor", "vi", "nel", "gash")
_IDEOGRAPHS = "天地玄黄宇宙洪荒日月盈昃辰宿列张寒来暑往"


def counted(names, rng):
    """``Key 1``, ``Key 2`` and so on, but for a few that were deleted."""
    head = rng.choice(["Key ", "target", "shape_0", ""])
    numbers = np.sort(rng.choice(np.arange(1, len(names) + 9), len(names), replace=False))
    return [f"{head}{number}" for number in numbers]


def lettered(names, _):
    """As the columns of a sheet: ``targetA`` to ``targetZ``, ``targetAA`` and on."""
    return [f"target{chr(64 + i // 26) if i > 25 else ''}{chr(65 + i % 26)}" for i, _ in enumerate(names)]


def permuted(names, rng):
    """Each name that of another control."""
    return [names[i] for i in rng.permutation(len(names))]


def upper_case(names, _):
    """As a tool of capitals writes them."""
    return [name.upper() for name in names]


def prefixed(names, rng):
    """One of three deformers in front, up to a dot or a colon."""
    heads = [f"{rng.choice(_SYLLABLES)}{rng.choice(_SYLLABLES)}{rng.choice(['.', ':'])}" for _ in range(3)]
    return [f"{rng.choice(heads)}{name}" for name in names]


def suffixed(names, rng):
    """The version of a sculpt behind."""
    return [f"{name}_v{rng.integers(1, 4)}" for name in names]


def in_ideographs(names, rng):
    """Words of a language that no table has."""
    return ["".join(rng.choice(list(_IDEOGRAPHS), 3)) + str(i) for i, _ in enumerate(names)]


def other_words(names, rng):
    """Made-up words."""
    return [
        "".join(rng.choice(_SYLLABLES, 3)).capitalize() + _SYLLABLES[i % 10] + "x" * (i // 10)
        for i, _ in enumerate(names)
    ]


def mixed(names, rng):
    """Some as they are, some counted, some of made-up words."""
    others = (names, counted(names, rng), other_words(names, rng))
    return [others[k][i] for i, k in enumerate(rng.integers(0, 3, len(names)))]


HINTS = (counted, lettered, upper_case, prefixed, suffixed, in_ideographs, other_words, mixed)
"""Names that say less than the usual ones, or the same in another way."""


def renamed(rig, naming, rng):
    """The rig with names that `naming` gives to its controls of shapes."""
    of_shapes = [control.name for control in rig.controls if control.kind == "blendShape"]
    names = dict(zip(of_shapes, naming(of_shapes, rng), strict=True))
    assert len({*names.values()}) == len(names)
    return rig_copies.renamed(rig, lambda name: names.get(name, name))[0]


def places(rig, layout):
    """Of every control, by its index, the points of the character that have its handles."""
    index = rig.control_indices
    found = {}
    for element in layout.elements:
        anchor = element.anchor
        if not anchor.on_board:
            for member in element.members:
                found.setdefault(index[member.control], []).append(rig.body.point_of(anchor.mesh, anchor.point))
    return found


def lost(before, after, points, reach):
    """Controls, by index, of places `before` with no handle `after` within `reach`, on a character of `points`."""

    def near(one, other):
        return np.linalg.norm(points[one] - points[other]) <= reach

    return {
        control
        for control, handles in before.items()
        if not any(near(one, other) for one in handles for other in after.get(control, ()))
    }
