"""A person's decision is never lost without a word: random chains of versions of a rig, with decisions in any round.

By command, page, configuration and stronger layer, through files as a studio keeps them.
"""

import base64
import re
from dataclasses import dataclass, field, replace

import makers
import numpy as np
import pytest
from commands import run
from page_in_node import corrections_of_the_page
from pxr import Sdf, Usd, UsdGeom, UsdSkel, Vt
from rig_copies import renamed, reordered, resculpted, spelt_otherwise, split
from skel_stages import add_animation, add_shape, add_skeleton, new_stage

from usdrigui.pipeline.reviewing import load_layer
from usdrigui.settings import Settings
from usdrigui.view.web.packing import pack

MESHES = ((65, 81), (73, 91), (81, 101))
ROOT = "/Root"
SPIN = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From a scene whose y axis is up to one whose z axis is."""
QUICK = ("--set", "solve.gap=1e-2")
DECIDED = ("brow_L", "smile_L", "sneer_L", "pucker", "chin", "jawLeft")
"""Of each pair and of each axis one: its other end follows it."""


@dataclass
class Version:
    """How a rig differs from the first one."""

    columns_rows: tuple = MESHES[0]
    gone: frozenset = frozenset()
    sculpted: int = 0
    order: int = 0
    respelt: bool = False
    called: dict = field(default_factory=dict)
    in_two: bool = False
    unit: float = 0.01
    z_up: bool = False
    rig: object = None
    names: dict = field(default_factory=dict)

    def made(self):
        points, quads = makers.mask(*self.columns_rows)
        shapes = {name: each for name, each in makers.face_shapes(points).items() if name not in self.gone}
        rig = makers.rig(points, quads, shapes)
        rig = resculpted(rig, self.sculpted) if self.sculpted else rig
        rig = makers.moved(rig, self.to_scene)
        rig = reordered(rig, self.order) if self.order else rig
        rig = split(rig) if self.in_two else rig
        self.rig, self.names = renamed(rig, self.name)
        return self

    def name(self, control):
        name = self.called.get(control, control)
        return spelt_otherwise(name) if self.respelt else name

    @property
    def to_scene(self):
        return (0.01 / self.unit) * (SPIN if self.z_up else np.eye(3))

    def canonical(self, position):
        """(3,) a position of the scene as it is on the first version."""
        return np.linalg.solve(self.to_scene, position)


def changed(version, random):
    """The next version."""
    change = random.choice(["gone", "back", "mesh", "sculpted", "order", "respelt", "unit", "z_up", "in_two", "called"])
    new = {
        "gone": {"gone": version.gone | {str(random.choice(["blink_L", "blink_R", "sneer_R", "jawRight", "chin"]))}},
        "back": {"gone": frozenset()},
        "mesh": {"columns_rows": MESHES[random.integers(len(MESHES))]},
        "sculpted": {"sculpted": int(random.integers(1, 9))},
        "order": {"order": int(random.integers(1, 9))},
        "respelt": {"respelt": not version.respelt},
        "unit": {"unit": float(random.choice([0.01, 1.0, 0.0254]))},
        "z_up": {"z_up": not version.z_up},
        "in_two": {"in_two": not version.in_two},
        "called": {"called": version.called | {str(random.choice(DECIDED)): f"shape{random.integers(99)}"}},
    }[str(change)]
    return replace(version, **new).made()


def written(version, path):
    """The rig of a version as a character in a file; the order of its controls is that of the SkelAnimation."""
    stage, _ = new_stage(path, ROOT)
    UsdGeom.SetStageMetersPerUnit(stage, version.unit)
    UsdGeom.SetStageUpAxis(stage, "Z" if version.z_up else "Y")
    add_skeleton(stage, f"{ROOT}/skeleton")
    called = {int(each.drive.channels[0]): each.name for each in version.rig.controls}
    for made in version.rig.body.meshes:
        mesh = UsdGeom.Mesh.Define(stage, made.path)
        mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(made.points.astype(np.float32)))
        mesh.CreateFaceVertexCountsAttr(made.topology.face_counts.tolist())
        mesh.CreateFaceVertexIndicesAttr(made.topology.face_indices.tolist())
        for shape in made.shapes:
            add_shape(mesh, called[shape.channel], shape.offsets[-1], shape.points)
        UsdSkel.BindingAPI.Apply(mesh.GetPrim()).CreateSkeletonRel().SetTargets([f"{ROOT}/skeleton"])
    add_animation(stage, f"{ROOT}/anim", f"{ROOT}/skeleton", list(called.values()))
    stage.GetRootLayer().Save()
    return path


def somewhere(version, control, random):
    """A point that a control moves by half of its peak at least: its mesh, its number and its position in the scene."""
    names = version.rig.control_names
    drive = version.rig.controls[names.index(version.names[control])].drive
    shapes = [(m, s) for m in version.rig.body.meshes for s in m.shapes if s.channel == int(drive.channels[0])]
    far = [np.linalg.norm(shape.offsets[-1], axis=1) for _, shape in shapes]
    large = [lengths >= 0.5 * np.concatenate(far).max() for lengths in far]
    places = [(mesh, int(point)) for (mesh, shape), ok in zip(shapes, large, strict=True) for point in shape.points[ok]]
    mesh, point = places[random.integers(len(places))]
    return mesh.path, point, mesh.points[point]


def loaded(layer):
    """The rig and the layout of a layer."""
    ((rig, layout),) = load_layer(layer, Settings()).characters
    return rig, layout


def element_of(layout, name):
    return next((e for e in layout.elements if name in e.controls), None)


def with_opinion(layer, control, mesh, point):
    """A stronger layer that names another point for the element of a control, and nothing else."""
    name = re.sub(r"\W", "_", element_of(loaded(layer)[1], control).name)
    over = Sdf.Layer.CreateNew(str(layer.with_suffix(".over.usda")))
    over.subLayerPaths.append(f"./{layer.name}")
    stage = Usd.Stage.Open(str(layer))
    (path,) = [
        prim.GetPath()
        for prim in stage.TraverseAll()
        if prim.GetName() == name and "RigUIElementAPI" in prim.GetPrimTypeInfo().GetAppliedAPISchemas()
    ]
    spec = Sdf.CreatePrimInLayer(over, path)
    Sdf.RelationshipSpec(spec, "rigUI:anchor:prim", False).targetPathList.explicitItems = [mesh]
    index = Sdf.AttributeSpec(spec, "rigUI:anchor:pointIndex", Sdf.ValueTypeNames.Int, Sdf.VariabilityUniform)
    index.default = point
    over.Save()
    return layer.with_suffix(".over.usda")


WAYS = ("command", "page", "configuration", "opinion", "board", "none")


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(40))
def test_every_decision_stands_or_is_told(seed, tmp_path, capsys):
    random = np.random.default_rng(seed)
    version = Version().made()
    layer = tmp_path / "0.rigui.usda"
    run(capsys, "process", written(version, tmp_path / "0.usda"), "-o", layer, *QUICK)
    standing, made, lost = {}, 0, 0
    for number in range(1, 6):
        earlier, version = version, changed(version, random)
        source, said = written(version, tmp_path / f"{number}.usda"), tmp_path / f"said{number}.usda"
        control, way, words = str(random.choice(DECIDED)), str(random.choice(WAYS)), []
        if way != "none" and control not in version.gone | earlier.gone:
            at = version if way == "configuration" else earlier
            mesh, point, position = somewhere(at, control, random)
            made += 1
            standing[control] = None if way == "board" else at.canonical(position)
            name, place = at.names[control], f"{mesh}#{point}"
            if way in ("board", "command"):
                run(capsys, "pin", layer, f"{name}={'board' if way == 'board' else place}", "-o", said)
            elif way == "page":
                scene = base64.b64encode(pack([loaded(layer)], "chain")).decode()
                said.write_text(corrections_of_the_page(scene, name, mesh, point))
            elif way == "configuration":
                (tmp_path / f"{number}.toml").write_text(f'[controls."{name}"]\nanchor = "{place}"\n')
                words = ["--config", tmp_path / f"{number}.toml"]
            else:
                layer = with_opinion(layer, name, mesh, point)
            words += ["--corrections", said] if said.exists() else []
        out = tmp_path / f"{number}.rigui.usda"
        report = run(capsys, "process", source, "--previous", layer, "-o", out, *words, *QUICK)
        told = [each for each in report["issues"] if each["code"] in ("PIN_LOST", "PIN_CARRIED")]
        _, layout = loaded(out)
        for name, place in list(standing.items()):
            known = {name, earlier.names.get(name, name), version.names.get(name, name)}
            if any(word in f"{each['path']} {each['message']}" for each in told for word in known):
                del standing[name]
                lost += 1
                continue
            element = element_of(layout, version.names[name])
            if place is None:
                assert element.anchor.on_board, (number, way, name)
                continue
            assert not element.anchor.on_board, (number, way, name)
            width = layout.frame.handle_width * version.unit / 0.01
            apart = np.linalg.norm(version.canonical(element.anchor.position) - place)
            assert apart <= 0.5 * width * 1.001, (number, way, name, apart / width)
        (difference,) = run(capsys, "diff", layer, out)["characters"]
        assert difference == report["characters"][0]["difference"], (number, way)
        came = ("added", "removed", "renamed")
        assert all(each["why"] for each in difference["changes"] if each["kind"] not in came), (number, way)
        layer = out
    assert lost <= made / 2, "most decisions stand"
