"""A person's decision is never lost without a word: random chains of versions of a rig, with decisions in any round."""

from dataclasses import dataclass, field, replace

import makers
import numpy as np
import pytest
from laid_out_again import lay_out
from rig_copies import renamed, reordered, resculpted, spelt_otherwise, split

from usdrigui.layout.reuse.pinned import with_rest_places
from usdrigui.model import Correction
from usdrigui.settings import load

MESHES = ((65, 81), (73, 91), (81, 101))
ROOT = "/Root"
SPIN = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From a scene whose y axis is up to one whose z axis is."""
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


def somewhere(version, control, random):
    """A point that a control moves by half of its peak at least: its mesh, its number and its position in the scene."""
    names = [each.name for each in version.rig.controls]
    drive = version.rig.controls[names.index(version.names[control])].drive
    shapes = [(m, s) for m in version.rig.body.meshes for s in m.binding.shapes if s.channel == int(drive.channels[0])]
    far = [np.linalg.norm(shape.offsets[-1], axis=1) for _, shape in shapes]
    large = [lengths >= 0.5 * np.concatenate(far).max() for lengths in far]
    places = [(mesh, int(point)) for (mesh, shape), ok in zip(shapes, large, strict=True) for point in shape.points[ok]]
    mesh, point = places[random.integers(len(places))]
    return mesh, point, mesh.points[point]


def element_of(layout, name):
    return next((e for e in layout.elements if name in e.manipulator.controls), None)


def with_opinion(layout, version, control, mesh, point):
    """The layout where a stronger layer names another point for an element, and nothing else."""
    own = element_of(layout, version.names[control])
    placement = replace(own.placement, pinned=("anchor",), pinned_position=(np.nan,) * 3)
    anchor = replace(own.anchor, mesh=mesh.path, point=point, topology_hash=mesh.topology.hash, on_board=False)
    edited = replace(own, placement=placement, anchor=anchor)
    elements = tuple(edited if each is own else each for each in layout.elements)
    return with_rest_places(replace(layout, elements=elements), version.rig)


@pytest.mark.parametrize("seed", [0, 1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(2, 20))])
def test_every_decision_stands_or_is_told(seed):
    random = np.random.default_rng(seed)
    version = Version().made()
    plain = load({"solve": {"gap": 1e-2}})
    _, _, before = lay_out(version.rig, plain)
    standing, made, lost = {}, 0, 0
    for number in range(10):
        earlier, version = version, changed(version, random)
        settings, corrections = plain, ()
        control = str(random.choice(DECIDED))
        way = str(random.choice(["correction", "earlier correction", "opinion", "configuration", "board", "none"]))
        at = version if way in ("correction", "configuration") else earlier
        if way != "none" and control not in version.gone | earlier.gone:
            mesh, point, position = somewhere(at, control, random)
            made += 1
            standing[control] = None if way == "board" else at.canonical(position)
            said = Correction(ROOT, at.names[control], "point", tuple(position), tuple(at.rig.skel_root.up), at.unit)
            if way == "board":
                corrections = (replace(said, place="board"),)
            elif way == "configuration":
                settings = load(
                    {"solve": {"gap": 1e-2}, "controls": {at.names[control]: {"anchor": f"{mesh.path}#{point}"}}}
                )
            elif way == "opinion":
                before = with_opinion(before, earlier, control, mesh, point)
            else:
                corrections = (said,)
        inputs, _, layout = lay_out(
            version.rig,
            settings,
            previous={ROOT: before},
            corrections=corrections,
            unit=version.unit,
            units={ROOT: earlier.unit},
        )
        told = [each for each in inputs.issues if each.code in ("PIN_LOST", "PIN_CARRIED")]
        for name, place in list(standing.items()):
            words = {name, earlier.names.get(name, name), version.names.get(name, name)}
            if any(word in f"{each.path} {each.message}" for each in told for word in words):
                del standing[name]
                lost += 1
                continue
            element = element_of(layout, version.names[name])
            assert element is not None, (number, way, name)
            if place is None:
                assert element.anchor.on_board, (number, way, name)
                continue
            assert not element.anchor.on_board, (number, way, name)
            width = inputs.face.handle_width * version.unit / 0.01
            apart = np.linalg.norm(version.canonical(element.anchor.position) - place)
            assert apart <= 0.5 * width * 1.001, (number, way, name, apart / width)
        before = layout
    assert lost <= made / 2, "most decisions stand"
