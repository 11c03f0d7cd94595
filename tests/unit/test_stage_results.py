"""What every stage makes of small characters is what it was: numbers that no other test looks at, by their digests.

A digest that differs says which functions return something else than before.  Where that is meant:
``USDRIGUI_GOLDEN=write pytest tests/unit/test_stage_results.py``, and a look at which functions changed.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import chain
import laid_out
import layout_problems
import limbs
import makers
import minimal_assets
import numpy as np
import pytest
import shot_stages
import skel_stages
import skinned_stages
import stage_digests
import traps
import valid_rigs
from pxr import Sdf, Usd
from rig_copies import resculpted

from usdrigui.animation import animation_facts
from usdrigui.cli import main
from usdrigui.errors import RigUIError
from usdrigui.examples import Examples
from usdrigui.layout.reuse.identity import match_layouts
from usdrigui.layout.review.difference import difference
from usdrigui.layout.review.improvement import improvements
from usdrigui.layout.review.review import review
from usdrigui.layout.review.shortfalls import shortfalls
from usdrigui.model import Performance
from usdrigui.pipeline.stages import build_problem, layout_of
from usdrigui.pose.drag import begin_drag, drag_to, values_at
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.settings import OutputSettings, ReadSettings, Settings, load
from usdrigui.solve import load_problem, save_problem, solve
from usdrigui.usd import reader_main, reader_process
from usdrigui.usd.clips import read_performances
from usdrigui.usd.faults import stage_faults
from usdrigui.usd.layer import layer_bytes, layer_for, stage_metadata
from usdrigui.usd.read_layout import composed_layouts, read_layout
from usdrigui.usd.reader_records import Request
from usdrigui.usd.rig import read_rigs

GOLDEN = Path(__file__).parent / "stage_results"
WRITE = os.environ.get("USDRIGUI_GOLDEN") == "write"
PACKAGES = ("layout", "pose", "solve", "usd")
SAMPLE = Path(__file__).resolve().parents[2] / "sample_assets" / "char.usda"


# --- characters -----------------------------------------------------------------------------------


def odd_face():
    """A face that is not symmetric, with shapes that others explain, tiny ones and ones of the whole head."""
    points, faces = makers.mask(19, 23)
    points = points * 1.7 + np.array([0.3, -2.0, 0.1])
    shapes = makers.face_shapes((points - np.array([0.3, -2.0, 0.1])) / 1.7)
    shapes |= {
        "smile": shapes["smile_L"] + shapes["smile_R"],
        "half": 0.5 * shapes["brow_L"],
        "nearly": shapes["blink_R"] + 0.05 * shapes["chin"],
        "corner": makers.bump(points, (1.2, -1.5), (1.0, -0.3, 0.2), 0.5, 0.2),
        "tiny": 1e-3 * shapes["chin"],
        "head": np.tile([0.2, 0.1, 0.0], (len(points), 1)),
        "bulge": 0.1 * (points - points.mean(axis=0)),
    }
    ranges = {"smile_L": (-1.0, 1.0), "head": (-0.5, 2.0), "chin": (0.0, 0.4)}
    return makers.rig(points, faces, shapes, ranges)


def lay_out(rig, examples=None, base_values=None, **parts):
    """A character laid out as the pipeline does, and its layout reviewed."""
    settings = load(parts)
    if base_values is not None:
        found = chain.lay_out(rig, settings, base_values)
        inputs, assignment, layout = found.inputs, found.assignment, found.layout
    else:
        inputs = build_problem(rig, settings, examples=Examples(**(examples or {})))
        assignment = solve(inputs.placement.problem, settings.solve)
        layout = layout_of(inputs, assignment)
    shortfalls(inputs.face, layout, settings)
    review(inputs.face, inputs.candidates, inputs.requests, inputs.settings, layout)
    return inputs, assignment, layout


ARROW = """#usda 1.0
def Mesh "Arrow" {
    point3f[] points = [(5, 7, -3), (4, 7, 0), (6, 7, 0)]
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
}
"""
DECISIONS = {
    "controls": {"brow_L": {"anchor": "/Root/mesh#267"}, "sneer_R": {"place": "board"}},
    "groups": {"groups": {"mouth": ["pucker", "chin"]}},
}
TURNED = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From Y up to Z up."""


# --- scenes ---------------------------------------------------------------------------------------


def of_a_face():
    lay_out(makers.face(17, 21))
    lay_out(makers.face_with_teeth(0.1))


def of_an_odd_face():
    rig = odd_face()
    lay_out(rig)
    lay_out(rig, base_values=np.linspace(0.1, 0.6, len(rig.controls)))
    lay_out(rig, candidates={"space": "view", "view": "25,10"}, objective={"handle_size": 0.05})


def as_configured():
    rig = makers.face(17, 21)
    controls = {
        "brow_L": {"importance": 2.0, "place": "face", "label": "Brow"},
        "chin": {"place": "board"},
        "pucker": {"exclude": True},
        "smile_L": {"near": "/Root/mesh.point[200]", "within": 0.3},
    }
    lay_out(
        rig, controls=controls, groups={"groups": {"odd": ["sneer_L", "brow_R"]}}, symmetry={"double_middle": "always"}
    )
    lay_out(rig, levels={"members": {"pucker": ["smile_R", "chin"]}}, groups={"patches": True, "fan_size": 4})


def of_requests():
    rig = makers.face_with_teeth(0.1)
    fan = {"fan": ["sneer_L", "sneer_R", "pucker", "blink_L", "chin"]}
    controls = {
        "teeth": {"place": "proxy", "adapt": "static"},
        "jawLeft": {"near": "/Root/teeth", "within": 0.4, "minimum": -0.5},
        "brow_L": {"anchor": "/Root/mesh#914", "follow_twin": False},
        "brow_R": {"near": "/Root/mesh.point[700]"},
    }
    lay_out(rig, controls=controls, groups={"groups": fan})
    star = makers.star(5)
    lay_out(star, controls={"arm0": {"orbit": [f"arm{k}" for k in range(5)]}}, candidates={"occlusion": False})
    ramp = np.array([0.0, 0.5, 1.0, 0.5, 0.0, 0.0, 0.0, 0.0])
    weights = np.stack([ramp, 0.9 * ramp, ramp[::-1], 0.2 * ramp], axis=1)
    tokens = ("chin", "pucker", "smile_L", "brow_R")
    clip = Performance("clip.usda", "/Anim", np.arange(8.0), tokens, weights, (), np.zeros((8, 0, 3, 3)))
    inputs = lay_out(makers.face(17, 21), {"clips": (clip,)}, animation={"weight": 0.7})[0]
    animation_facts(inputs.face, inputs.candidates, inputs.similarity, inputs.requests, inputs.settings, (clip,))


def of_the_paper():
    rig = makers.face(17, 21)
    settings = load(preset="paper")
    chain.solved(chain.problem_of(rig, settings), settings.solve)


def of_limbs():
    chain.laid_parts(limbs.whole_body())
    lay_out(limbs.with_default_controls(limbs.flattened(limbs.hand_rig())))
    lay_out(limbs.chain_rig(late=0.2))
    lay_out(limbs.with_default_controls(limbs.posed_body()))


def of_layouts_that_exist():
    rig = makers.face(17, 21)
    first = lay_out(rig)[2]
    some = replace(rig, controls=tuple(each for each in rig.controls if each.name not in ("chin", "sneer_L")))
    named = replace(
        rig,
        controls=tuple(
            replace(each, name=each.name.replace("smile", "grin"), label=each.name) for each in rig.controls
        ),
    )
    numbered = replace(rig, controls=as_numbers(rig.controls))
    decided = lay_out(rig, **DECISIONS)[2]
    other = makers.moved(makers.face(23, 25, height=30.0), TURNED, (3.0, 1.0, -40.0))
    unnamed = replace(other, controls=as_numbers(other.controls[::-1]))
    for ours, examples in (
        (some, {"previous": {rig.root: first}}),
        (named, {"previous": {rig.root: first}}),
        (numbered, {"previous": {rig.root: decided}}),
        (resculpted(rig, 1), {"previous": {rig.root: decided}}),
        (other, {"like": ((rig, decided),)}),
        (unnamed, {"like": ((rig, first),)}),
        (rig, {"fixed": {rig.root: first}}),
    ):
        inputs, assignment, layout = lay_out(ours, examples)
        better = improvements(inputs.face, inputs.requests, inputs.placement, assignment.labels)
        difference(first, layout, better, next(iter(inputs.matchings.values()), None))
        match_layouts(first, layout)


def as_numbers(controls):
    return tuple(replace(each, name=f"c{number}") for number, each in enumerate(controls))


def of_solvers():
    for seed in range(12):
        for method in ("highs", "enumerate", "paper"):
            solved(layout_problems.random_problem(seed), method, clusters=2)
    for seed in (0, 1):
        solved(layout_problems.crowd(seed, 4, 16), "highs")
        solved(layout_problems.crowd(seed, 5, 30), "highs", work_limit=2_000_000)
        save_problem(Path("problem.npz"), layout_problems.random_problem(seed))
        load_problem(Path("problem.npz"))
        solved(layout_problems.crowd(seed, 8, 20), "paper", linkage="sum", clusters=3)


def solved(problem, method, **options):
    with contextlib.suppress(RigUIError):  # some have no solution
        solve(problem, load({"solve": {"method": method, **options}}).solve)


def of_files():
    sources = [
        skel_stages.character(Path("all.usda")),
        skinned_stages.character(
            Path("skinned.usda"), moved=True, meshes=2, reordered=True, animated_joints=("Hips/Head",)
        ),
        *(valid_rigs.make_rig(seed, Path(f"valid{seed}.usda"), valid_rigs.SMALL) for seed in range(4)),
    ]
    for number, source in enumerate(sources):
        stage_faults(Usd.Stage.Open(str(source)))
        for rig in read_rigs(source, Settings()):
            posed(source, rig, number)
        with contextlib.suppress(RigUIError):  # some have no animation
            read_performances(source)


def of_small_assets():
    # Each in a folder of its own: USD may still hold the file that another one replaces.
    for number, code in enumerate(minimal_assets.EDITS):
        asked("rigs" if number % 4 else "faults", minimal_assets.character(folder(f"e{number}"), code))
    for number, name in enumerate(traps.TRAPS):
        asked("faults" if number % 4 else "rigs", traps.trapped(folder(f"t{number}"), name))
    for seed in range(4, 10):
        asked("rigs", valid_rigs.make_rig(seed, Path(f"valid{seed}.usda"), valid_rigs.SMALL))
    first = SAMPLE.parents[1] / "tests" / "first_format"
    shutil.copytree(first, "first")
    asked("layouts", Path("first/char.rigui.usda"))
    asked("composed", Path("first/char.rigui.usda"))
    frames = skel_stages.posed(Path("posed.usda"), json.dumps(["Rest", "turn", "shift", "same"]))
    asked("rigs", frames, poses={"story": {"clip": [0.0, 2.0]}}, read={"joints": "none"})
    asked("clips", frames)


def folder(name):
    Path(name).mkdir()
    return Path(name)


def of_random_characters():
    for seed in range(10, 22):
        for rig in read_rigs(valid_rigs.make_rig(seed, Path(f"valid{seed}.usda"), valid_rigs.SMALL), Settings()):
            with contextlib.suppress(RigUIError):  # some cannot be laid out
                lay_out(rig)


def asked(task, path, **parts):
    """What the reader responds, in this process."""
    limits = reader_process.Limits.of(ReadSettings())
    return reader_main.respond(Request(task, str(path.absolute()), load(parts), limits, os.getpid()))


def of_commands():
    """A character, its shot, its layouts added to and attached, read in this process."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(reader_process, "_from_reader", lambda request, _: reader_main.respond(request))
        Path("glyphs.usda").write_text(ARROW, encoding="utf-8")
        char = str(skinned_stages.character(Path("char.usda")))
        glyph = 'controls.chin.glyph="glyphs.usda</Arrow>"'
        for line in (
            f"process {char} --set {glyph}",
            f"process {char} --previous char.rigui.usda --set {glyph} -o again.usda",
            f"process {char} --bare -o bare.usda",
            "check char.rigui.usda",
            "diff char.rigui.usda again.usda",
            f"attach {char} bare.usda",
            f"inspect {char}",
        ):
            with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                main(line.split())
        shot_stages.shot(
            Path("shot.usda"), "./char.usda", "/World/Char/face0", {"ears": ((0.5, 0.2), (1.0, 0.0, 0.0), 0.3, 0.1)}
        )
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            main(["process", "shot.usda", "--base", "char.usda", "-o", "shot.rigui.usda"])
        for path in sorted(Path().glob("*.rigui.usda")):
            read_layout(path)


def posed(source, rig, seed):
    """A layout of a rig at random points, written, read and posed."""
    rng = np.random.default_rng(seed)
    names = [each.name for each in rig.controls][:24]
    sizes = np.cumsum([1, 2, 3, 1, 4])
    groups = [tuple(names[a:b]) for a, b in zip([0, *sizes[:-1]], sizes, strict=True) if names[a:b]]
    layout = laid_out.layout_of(
        rig, seed, groups, 0.3 * laid_out.random_values(rig, rng), beside=names[1:2], adapt="deform"
    )
    layer = layer_for(
        ((rig, layout),), source.name, OutputSettings(), stage_metadata(Sdf.Layer.FindOrOpen(str(source)))
    )
    layer_bytes(layer, ".usda")
    (again,) = read_layout(layer)
    poser = prepare(rig, layout)
    for _ in range(2):
        found = evaluate(poser, laid_out.random_values(rig, rng))
        assert len(found.elements) == len(again.elements)
    for element in layout.elements:
        dragged(rig, layout, element, rng)


def dragged(rig, layout, element, rng):
    """A handle dragged along a zigzag."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    owned = [index[member.control] for member in element.members]
    ranges = [(each.minimum, each.default, each.maximum) for each in (rig.controls[i] for i in owned)]
    base = layout.base_values[owned]
    tracks = [200.0 * member.track[:, :2] for member in element.members]
    drag = begin_drag(tracks, [member.values for member in element.members], element.axes, ranges, base, base)
    at = drag.start
    for to in rng.uniform(-150.0, 150.0, (4, 2)):
        at = drag_to(drag, at, to)
        values_at(drag, at)


def of_the_sample():
    (rig,) = read_rigs(SAMPLE, Settings())
    layout = lay_out(rig)[2]
    layer = layer_for(((rig, layout),), "char.usda", OutputSettings(), {})
    layer_bytes(layer, ".usda")
    composed_layouts(Usd.Stage.Open(layer))
    read_layout(layer)


SCENES: dict[str, Callable[[], object]] = {
    each.__name__: each
    for each in (
        of_a_face,
        of_an_odd_face,
        as_configured,
        of_the_paper,
        of_limbs,
        of_layouts_that_exist,
        of_solvers,
        of_requests,
        of_files,
        of_small_assets,
        of_random_characters,
        of_commands,
        of_the_sample,
    )
}


@pytest.mark.parametrize("scene", SCENES)
def test_every_function_returns_what_it_did(scene, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with stage_digests.returned(PACKAGES) as found:
        SCENES[scene]()
    digests = {name: each.read() for name, each in sorted(found.items())}
    file = GOLDEN / f"{scene}.json"
    if WRITE:
        lines = ",\n".join(f" {json.dumps(name)}: {json.dumps(each)}" for name, each in digests.items())
        file.write_text("{\n" + lines + "\n}\n", encoding="utf-8")
    golden = json.loads(file.read_text(encoding="utf-8"))
    changed = [name for name, each in digests.items() if name in golden and not stage_digests.alike(each, golden[name])]
    assert (changed, sorted(golden.keys() ^ digests.keys())) == ([], []), "USDRIGUI_GOLDEN=write if this is meant"


def digest_of(value):
    digest = stage_digests.Digest({})
    digest.add(value)
    return digest.read()


@pytest.mark.parametrize(
    ("value", "other"),
    [
        ((1, 2), (2, 1)),
        (((1,), 2), ((1, 2),)),
        (np.arange(3.0), np.arange(3.0)[::-1]),
        (np.zeros((2, 3)), np.zeros((3, 2))),
        ({"a": 1e-5}, {"a": 2e-5}),
        (np.append(np.ones(500), 0.01), np.append(np.ones(500), 0.011)),
        (np.inf, -np.inf),
    ],
)
def test_a_digest_tells_values_apart_but_not_their_last_digits(value, other):
    assert not stage_digests.alike(digest_of(value), digest_of(other))
    if isinstance(value, np.ndarray):
        assert stage_digests.alike(digest_of(value), digest_of(value * (1.0 + 1e-9)))
