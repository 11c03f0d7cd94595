"""Draw what a layout is made of, one picture per kind, and write the page about them.

    python docs/pictures.py [WORD ...] [--check]

Everything is made by the package itself from the sample character and from the blossom below: each
panel is a run of ``usdrigui process`` with the configuration that the page shows.  With words only
the scenes whose names hold one of them are drawn; with ``--check`` nothing is written and the exit
code is 1 where page or pictures are missing or older.  The same installation gives the same
bytes.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import tomllib
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image
from pxr import Sdf, Usd, UsdGeom, UsdSkel, Vt

from usdrigui.pipeline import process
from usdrigui.report.run_report import CharacterReport
from usdrigui.settings import load
from usdrigui.view.picture import Wanted, render

DOCS = Path(__file__).resolve().parent
SAMPLE = DOCS.parent / "sample_assets" / "char.usda"
FOLDER = DOCS / "images" / "elements"
PAGE = DOCS / "internals" / "elements.md"
PANEL = (560, 500)
QUALITY = 84
GAP = 8


@dataclass(frozen=True)
class Panel:
    """One run, drawn once."""

    title: str
    config: str = ""
    """TOML besides what keeps the controls of the scene."""
    pose: tuple[tuple[str, float], ...] = ()
    """Control values at which it is drawn."""
    azimuth: float = 0.0
    """Of the view, degrees from the front toward the character's left."""


@dataclass(frozen=True)
class Scene:
    """One picture of the page and its text."""

    name: str
    heading: str
    text: str
    panels: tuple[Panel, ...]
    controls: tuple[str, ...] = ()
    """Parts of the names of the controls that are laid out; all others are excluded.  Empty keeps
    all."""
    asset: str = "char.usda"
    joints: bool = False
    """Whether joints are controls."""
    labels: bool = True


def main() -> int:
    """Draw and write; returns 1 when ``--check`` finds something amiss."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("words", nargs="*")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    if arguments.check:
        found = amiss()
        print("\n".join(found) or "page and pictures are there")
        return int(bool(found))
    FOLDER.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        place = prepared(Path(folder))
        for scene in SCENES:
            if not arguments.words or any(word in scene.name for word in arguments.words):
                drawn(scene, place).save(
                    FOLDER / f"{scene.name}.jpg", quality=QUALITY, subsampling=0
                )
                print(FOLDER / f"{scene.name}.jpg", flush=True)
    PAGE.write_text(page(), encoding="utf-8")
    return 0


def amiss() -> list[str]:
    """What `main` would have to write anew, as far as known without drawing."""
    found = (
        []
        if PAGE.is_file() and PAGE.read_text(encoding="utf-8") == page()
        else [f"{PAGE} is out of date"]
    )
    names = {scene.name for scene in SCENES}
    there = {each.stem for each in FOLDER.glob("*.jpg")}
    return found + [
        f"{FOLDER / name}.jpg is missing or left over" for name in sorted(names ^ there)
    ]


def drawn(scene: Scene, folder: Path) -> Image.Image:
    """The panels of a scene side by side."""
    panels = [_panel(scene, panel, folder) for panel in scene.panels]
    size = sum(each.width + GAP for each in panels) - GAP, max(each.height for each in panels)
    strip = Image.new("RGB", size, (250, 250, 251))
    for at, each in enumerate(panels):
        strip.paste(each, (at * (PANEL[0] + GAP), 0))
    return strip


def laid_out(scene: Scene, panel: Panel, folder: Path) -> CharacterReport:
    """The run of one panel."""
    asset = folder / scene.asset
    settings = load(tomllib.loads(_whole_config(scene, panel, asset)))
    return process(asset, settings, output=folder / f"{scene.name}.rigui.usda").characters[0]


def _panel(scene: Scene, panel: Panel, folder: Path) -> Image.Image:
    made = laid_out(scene, panel, folder)
    values = np.array([dict(panel.pose).get(each.name, each.default) for each in made.rig.controls])
    given = values if panel.pose else None
    wanted = Wanted(panel.azimuth, PANEL, scene.labels, panel.title)
    return render(made.rig, made.layout, given, wanted)


def _whole_config(scene: Scene, panel: Panel, asset: Path) -> str:
    """The panel's own configuration, and the exclusion of every control that the scene does not
    show."""
    configured = tomllib.loads(panel.config)
    lines = [panel.config]
    if scene.asset == SAMPLE.name and not scene.joints and "read" not in configured:
        lines += ["[read]", 'joints = "none"']
    for name in _names(asset, scene.joints) if scene.controls else ():
        if not any(part in name for part in scene.controls) and name not in configured.get(
            "controls", {}
        ):
            lines += [f'[controls."{name}"]', "exclude = true"]
    return "\n".join(lines)


def _names(asset: Path, joints: bool) -> Iterable[str]:
    """Names of all controls of an asset."""
    from usdrigui.reader.reader_process import read_rigs_isolated

    settings = load({} if joints else {"read": {"joints": "none"}})
    return [each.name for each in read_rigs_isolated(asset, settings).rigs[0].controls]


# --- characters -----------------------------------------------------------------------------------


def prepared(folder: Path) -> Path:
    """A folder with the sample character, the blossom, and a package with a term of its own."""
    for each in SAMPLE.parent.glob("char*.usda"):
        (folder / each.name).write_bytes(each.read_bytes())
    blossom(folder / "blossom.usda")
    (folder / "my_terms.py").write_text(TERM, encoding="utf-8")
    about = folder / "my_terms-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text(
        "Metadata-Version: 2.1\nName: my_terms\nVersion: 1.0\n", encoding="utf-8"
    )
    (about / "entry_points.txt").write_text(
        "[usdrigui.terms]\nkeep_low = my_terms:KeepLow\n", encoding="utf-8"
    )
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))
    return folder


TERM = '''"""Lower places are better."""


class KeepLow:
    @staticmethod
    def linear(context, motion, points):
        heights = context.trajectories.surface.points[points] @ context.rig.up
        return 4.0 * (heights - heights.min()) / context.trajectories.surface.face_size
'''
PETALS = 5


def blossom(target: Path) -> None:
    """A disc with five petals that can be raised, and a middle: five-fold symmetry, no face."""
    rings, sectors = 24, 80
    turn, out = np.meshgrid(
        np.linspace(0, 2 * np.pi, sectors, endpoint=False), np.linspace(0.05, 1.0, rings)
    )
    petal = 0.65 + 0.35 * np.cos(PETALS * turn)
    points = np.stack(
        [out * petal * np.sin(turn), out * petal * np.cos(turn), 0.3 * (1.0 - out**2)], axis=-1
    )
    points = points.reshape(-1, 3)
    index = np.arange(rings * sectors).reshape(rings, sectors)
    after = np.roll(index, -1, axis=1)
    quads = np.stack([index[:-1], after[:-1], after[1:], index[1:]], axis=-1)[..., ::-1].reshape(
        -1, 4
    )
    shapes = {f"petal{k + 1}": _raised(points, 2 * np.pi * k / PETALS) for k in range(PETALS)}
    _write_character(target, points, quads, shapes)


def _raised(points: np.ndarray, angle: float) -> np.ndarray:
    tip = 0.75 * np.array([np.sin(angle), np.cos(angle), 0.0])
    fall = np.clip(1.0 - np.linalg.norm((points - tip)[:, :2], axis=1) / 0.4, 0.0, 1.0) ** 2
    outward = np.array([0.9 * np.sin(angle), 0.9 * np.cos(angle), 0.45])
    return 0.35 * fall[:, None] * outward


def _write_character(
    target: Path, points: np.ndarray, quads: np.ndarray, shapes: dict[str, np.ndarray]
) -> None:
    stage = Usd.Stage.CreateNew(str(target))
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    root = UsdSkel.Root.Define(stage, "/Blossom")
    stage.SetDefaultPrim(root.GetPrim())
    UsdSkel.Skeleton.Define(stage, "/Blossom/Skel")
    mesh = UsdGeom.Mesh.Define(stage, "/Blossom/petals")
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points.astype(np.float32)))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(quads), 4, dtype=np.int32)))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(quads.reshape(-1).astype(np.int32)))
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets([Sdf.Path("/Blossom/Skel")])
    binding.CreateBlendShapesAttr(Vt.TokenArray(list(shapes)))
    targets = binding.CreateBlendShapeTargetsRel()
    for name, offsets in shapes.items():
        shape = UsdSkel.BlendShape.Define(stage, f"/Blossom/petals/{name}")
        shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(offsets.astype(np.float32)))
        targets.AddTarget(shape.GetPath())
    stage.Save()


# --- the page -------------------------------------------------------------------------------------


def page() -> str:
    """docs/internals/elements.md."""
    parts = [
        "<!-- Made by docs/pictures.py; do not edit. -->\n",
        "# What a layout is made of, in pictures\n",
        (
            "Every picture below is drawn by `python docs/pictures.py` from the sample character"
            " (`sample_assets/char.usda`) with the configuration below it, as `usdrigui"
            " process char.usda --preview picture.png --labels` would. To show one thing at a time,"
            ' the controls that a picture is not about are excluded (`[controls."x"] exclude ='
            ' true`), and joints are left out (`read.joints = "none"`) unless it is about them.'
            " Blue is the character's left, red its right, yellow its middle, violet what has no"
            " side.\n"
        ),
    ]
    for scene in SCENES:
        parts += [
            f"## {scene.heading}\n",
            f"{scene.text}\n",
            f"![{scene.heading}](../images/elements/{scene.name}.jpg)\n",
        ]
        parts += [_said(panel) for panel in scene.panels]
    return "\n".join(parts)


def _said(panel: Panel) -> str:
    """What makes one panel."""
    pose = ", ".join(f"{name} = {value:g}" for name, value in panel.pose)
    shown = f" Drawn at {pose}." if pose else ""
    if not panel.config:
        return f"*{panel.title}*: nothing is configured.{shown}\n"
    return f"*{panel.title}*:{shown}\n\n```toml\n{panel.config.strip()}\n```\n"


MOUTH = ("mouth",)
OPEN = (("jawOpen", 1.0), ("mouthSmileLeft", 0.6), ("mouthSmileRight", 0.6))
TINY = tuple(
    f"{name}{side}"
    for name in ("browOuterUp", "mouthUpperUp", "mouthSmile")
    for side in ("Left", "Right")
)
SCENES: tuple[Scene, ...] = (
    Scene(
        "view",
        "1 · Only what can be seen",
        "Anchors are points that the front or a three-quarter view sees, with trajectories that do"
        " not run inside or behind the model. `--view` names one view instead: seen from the"
        " character's left side, the elements of the right side of the face have no place there and"
        " go beside it. A layout is drawn from the view it was made for.",
        (
            Panel("front and three-quarter views", azimuth=90.0),
            Panel("side view only", '[candidates]\nview = "side"'),
        ),
        (
            "mouthSmile",
            "mouthStretch",
            "browOuterUp",
            "cheekSquint",
            "noseSneer",
            "eyeBlink",
            "jawOpen",
        ),
        labels=False,
    ),
    Scene(
        "flat",
        "2 · Flat layouts",
        "Elements of a head and of a standing body are measured as the viewer sees them, the"
        " handles of the body and all of hands in space; `--space object` measures all in space."
        " `--space view` measures their tracks in the picture plane as well: what runs toward the"
        " viewer is anchored where it can still be seen to move.",
        (
            Panel("in space", '[candidates]\nspace = "object"'),
            Panel("by default"),
            Panel("as seen from the front", '[candidates]\nspace = "view"\nview = "front"'),
        ),
        ("mouthPucker", "mouthFunnel", "jawForward", "cheekPuff", "mouthShrug", "mouthRoll"),
    ),
    Scene(
        "mirror",
        "3 · Symmetry",
        "Pairs are found from the geometry and laid out once, so that both halves are exact mirror"
        ' images. With `twin = "none"` the two are laid out by themselves.',
        (
            Panel("pairs"),
            Panel(
                "pairs broken up",
                "\n".join(
                    f'[controls.{name}Left]\ntwin = "none"'
                    for name in ("mouthSmile", "mouthFrown", "mouthDimple", "mouthStretch")
                ),
            ),
        ),
        ("mouthSmile", "mouthFrown", "mouthDimple", "mouthStretch"),
        labels=False,
    ),
    Scene(
        "orbit",
        "3 · Symmetry about an axis",
        "An orbit is laid out once: one petal is placed, all five copies count. The blossom is made"
        " by the script.",
        (
            Panel(
                "five-fold, by annotation",
                "[controls.petal1]\norbit = "
                + str([f"petal{k + 1}" for k in range(PETALS)]).replace("'", '"'),
            ),
        ),
        asset="blossom.usda",
    ),
    Scene(
        "board",
        "4 · Global and hidden controls on the board",
        "Controls that move the whole head, or only geometry hidden in all views, are on a board"
        " beside the face, under a heading. On request a hidden control is at the nearest"
        " visible place instead.",
        (
            Panel("by default"),
            Panel("the tongue at its proxy", '[controls.tongueOut]\nplace = "proxy"'),
        ),
        ("headSquash", "tongueOut", "Head:", "jawOpen", "mouthSmile", "eyeBlink"),
        joints=True,
    ),
    Scene(
        "exclude",
        "4 · Without an element",
        "A helper shape that no animator should touch gets no element. Its motion still defines"
        " what the face is.",
        (Panel("by default"), Panel("excluded", "[controls.cheekPuff]\nexclude = true")),
        ("cheekPuff", "cheekSquint", "noseSneer", "mouthShrugLower", "browInnerUp"),
    ),
    Scene(
        "locality",
        "5 · Kept near something",
        "A control can be held near a joint, a prim, a GeomSubset or a point.",
        (
            Panel("free"),
            Panel(
                "near the eyes",
                "\n".join(
                    f'[controls.{name}]\nnear = "joint:Eye{side}"\nwithin = 0.22'
                    for name, side in (
                        ("noseSneerLeft", "Left"),
                        ("noseSneerRight", "Right"),
                        ("cheekPuff", "Left"),
                    )
                ),
            ),
        ),
        ("cheekPuff", "noseSneer", "browInnerUp"),
    ),
    Scene(
        "anchor",
        "5 · Exactly at a point",
        "An anchor of the configuration is kept to the point; the twin moves to the mirror image."
        " Everything else is optimal given that.",
        (
            Panel("free"),
            Panel(
                "mouthSmileLeft at a point of the cheek",
                '[controls.mouthSmileLeft]\nanchor = "/Char/Geometry/Head#491"',
            ),
        ),
        ("mouthSmile", "mouthFrown", "cheekPuff", "jawOpen"),
    ),
    Scene(
        "pose",
        "6 · Any base pose",
        "A layout is made once and follows the face. It can be made for any pose: solved with the"
        " jaw open, anchors are those that serve there.",
        (
            Panel("made and drawn at rest"),
            Panel("made at rest, drawn with the jaw open", pose=OPEN),
            Panel(
                "made with the jaw open",
                '[read]\njoints = "none"\n[read.pose]\njawOpen = 1.0\nmouthSmileLeft = 0.6',
                pose=OPEN,
            ),
        ),
        ("jaw", "mouthLowerDown", "mouthUpperUp", "mouthSmile", "mouthShrugLower"),
        labels=False,
    ),
    Scene(
        "term",
        "7 · A term of your own",
        "A package can add costs to the objective ([terms.md](terms.md)). Here it prefers low"
        " places, at 4 for a whole face's height.",
        (Panel("without"), Panel("with keep_low", '[objective]\nterms = ["keep_low"]')),
        ("browOuterUp", "cheekSquint", "mouthSmile", "jawOpen", "noseSneer"),
        labels=False,
    ),
    Scene(
        "shared",
        "8 · Patches and fans",
        "Several controls of one region can share a handle: two make a patch, more a fan, in the"
        " order of their directions. Groups come from the configuration or from overlapping"
        " candidates (`groups.patches`).",
        (
            Panel("sliders", "[groups]\nopposed = false"),
            Panel(
                "a patch a side",
                '[groups.groups]\ncornerLeft = ["mouthSmileLeft", "mouthStretchLeft"]\n'
                'cornerRight = ["mouthSmileRight", "mouthStretchRight"]',
            ),
            Panel(
                "a fan a side",
                '[groups.groups]\ncornerLeft = ["mouthSmileLeft", "mouthStretchLeft",'
                ' "mouthFrownLeft"]\ncornerRight = ["mouthSmileRight", "mouthStretchRight",'
                ' "mouthFrownRight"]',
            ),
        ),
        ("mouthSmile", "mouthStretch", "mouthFrown"),
        labels=False,
    ),
    Scene(
        "curves",
        "9 · Curved sliders and pose controls",
        "Tracks are the trajectories themselves: in-betweens and joints bend them. A frame of a"
        " clip, or weights, can be a control: its slider leads from pose to pose.",
        (
            Panel(
                "in-betweens and a joint",
                '[controls."Jaw:rx"]\nplace = "face"\nmaximum = 25',
                azimuth=90.0,
            ),
            Panel(
                "a pose control",
                "[poses.grin]\nweights = { mouthSmileLeft = 1.0, mouthSmileRight = 1.0, jawOpen ="
                ' 0.3 }\n[controls.grin]\nplace = "face"',
            ),
        ),
        ("eyeBlink", "Jaw:rx"),
        joints=True,
    ),
    Scene(
        "range",
        "9 · The range of a control",
        "A track leads from the least value to the greatest, 0 to 1 for most shapes. `minimum` and"
        " `maximum` shorten it, or let it go further, below zero as well.",
        (
            Panel("0 to 1"),
            Panel(
                "jawOpen to 0.5, smiles from -0.5 to 1.5",
                "[controls.jawOpen]\nmaximum = 0.5\n"
                + "\n".join(
                    f"[controls.mouthSmile{side}]\nminimum = -0.5\nmaximum = 1.5"
                    for side in ("Left", "Right")
                ),
            ),
        ),
        ("jawOpen", "mouthSmile", "browOuterUp"),
    ),
    Scene(
        "joints",
        "9 · Which joints are controls",
        "Of a body every joint with skin is one, by the kind of its place; of a bust like the"
        " sample those that the animation of the asset rotates, about the axes that it uses"
        ' ([joints.md](joints.md)). With `"all"` every joint turns about all of its axes, with'
        ' `"none"` none does.',
        (
            Panel("those that the animation turns"),
            Panel("all joints", '[read]\njoints = "all"'),
        ),
        ("Jaw:", "Eye", "Head:", "Neck:"),
        joints=True,
    ),
    Scene(
        "opposed",
        "10 · Opposed controls share an element",
        "Two controls that go opposite ways become one two-way slider, two such axes of one region"
        " a joystick.",
        (Panel("one slider each", "[groups]\nopposed = false"), Panel("by default")),
        (
            "jawLeft",
            "jawRight",
            "jawOpen",
            "eyeBlink",
            "eyeWide",
            "mouthLeft",
            "mouthRight",
            "mouthRoll",
        ),
        labels=False,
    ),
    Scene(
        "crowd",
        "11 · Every handle can be grabbed",
        "No two handles are nearer than a handle's width. Where the face is too crowded for that,"
        " the elements that lose least stand on the board, under their own heading. Handles are"
        " four and twelve times as wide here as usual, and may not shrink as they otherwise do on a"
        " crowded face.",
        (
            Panel("four times as wide", "[objective]\nhandle_size = 0.08\nmax_neighbours = 0"),
            Panel("twelve times as wide", "[objective]\nhandle_size = 0.24\nmax_neighbours = 0"),
        ),
        MOUTH,
        labels=False,
    ),
    Scene(
        "double",
        "11 · Middle or double",
        "Elements that are their own mirror image prefer the mid-plane, at a penalty; on request"
        " they are doubled.",
        (
            Panel("on the plane", '[symmetry]\ndouble_middle = "never"'),
            Panel("doubled", '[symmetry]\ndouble_middle = "always"'),
        ),
        ("mouthRoll", "mouthShrug", "mouthFunnel", "browInnerUp", "cheekPuff"),
        labels=False,
    ),
    Scene(
        "tiny",
        "12 · Tiny trajectories",
        "A trajectory too short to be used is drawn longer, with the magnification recorded in the"
        " layer. These controls move a fifteenth of what they usually do.",
        tuple(
            Panel(
                title,
                config + "\n".join(f"[controls.{name}]\nmaximum = 0.07" for name in TINY),
            )
            for title, config in (("as they are", "[output]\nmin_track = 0\n"), ("enlarged", ""))
        ),
        TINY,
        labels=False,
    ),
    Scene(
        "adapt",
        "12 · Elements that follow, elements that stay",
        'Elements are on the skin and go where it goes. With `adapt = "static"` they stay where'
        " they were made.",
        (
            Panel("deform", pose=(("jawOpen", 1.0),)),
            Panel("static", '[output]\nadapt = "static"', pose=(("jawOpen", 1.0),)),
        ),
        ("mouthLowerDown", "mouthShrugLower", "mouthSmile", "jawOpen"),
        labels=False,
    ),
)


if __name__ == "__main__":
    raise SystemExit(main())
