"""`usdrigui picker`: flat pickers with every element at its place."""

import json
import xml.etree.ElementTree as ElementTree
from dataclasses import replace

import laid_out
import numpy as np
import pytest
from laid_out import on_face

from usdrigui import pipeline
from usdrigui.cli import main
from usdrigui.clients import picker
from usdrigui.settings import Settings
from usdrigui.view.flat.scene import Label
from usdrigui.view.flat.svg import svg

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def layer(laid_out):
    return laid_out / "char.rigui.usda"


@pytest.fixture(scope="module")
def characters(layer):
    return pipeline.load_layer(layer, Settings()).characters


def test_writes_both(layer, tmp_path):
    svg, dwpicker = tmp_path / "out.svg", tmp_path / "out.json"
    assert main(["picker", str(layer), "--svg", str(svg), "--dwpicker", str(dwpicker)]) == 0
    assert svg.is_file()
    behind = tmp_path / "out.background.png"
    (image,) = {shape["image.path"] for shape in json.loads(dwpicker.read_text())["shapes"]} - {""}
    assert (image, behind.read_bytes()[:4]) == (f"$DWPICKER_PROJECT_DIRECTORY/{behind.name}", b"\x89PNG")
    before = svg.read_bytes()
    assert main(["picker", str(layer), "--svg", str(svg)]) == 0
    assert svg.read_bytes() == before
    assert main(["picker", str(layer)]) == 2


@pytest.fixture(scope="module")
def page(characters):
    return picker.picker(characters, labels=True)


def placed(page):
    """By name, where the handle of an element is on the page, with its mark."""
    return {element.name: (handle, mark) for element, mark, handle in picker._elements(page)}


def test_every_element_track_and_name_is_in_the_picture(characters, page):
    root = ElementTree.fromstring(svg(page))
    groups = {group.get("id"): group for group in root.iter(f"{SVG}g") if group.get("id")}
    (_, layout) = characters[0]
    assert set(groups) == {element.name for element in layout.elements}
    for element in layout.elements:
        group = groups[element.name]
        controls = [member.control for member in element.members]
        assert json.loads(group.get("data-controls")) == controls
        assert [each.get("data-control") for each in group.iter(f"{SVG}g")][1:] == controls
        assert all(len(list(each.iter(f"{SVG}polyline"))) == 1 for each in group.iter(f"{SVG}g") if each is not group)
        assert group.get("data-anchor") == f"{element.anchor.mesh}#{element.anchor.point}"
    texts = {each.text for each in root.iter(f"{SVG}text")}
    assert {element.label for element in layout.elements} <= texts
    for panel in page.panels:
        for mark in panel.marks:
            points = np.vstack([mark.handle, *mark.tracks])
            assert (points >= 0.0).all()
            assert (points <= panel.size).all()


def test_places_are_those_of_the_view(characters, page):
    """At one scale, but for what keeps handles apart; the character's left is on the right; up is up."""
    rig, layout = characters[0]
    made, face = placed(page), on_face(layout)
    plane = np.stack([np.cross(rig.up, layout.frame.view), -rig.up], axis=1)
    given = np.array([element.anchor.position @ plane for element in face])
    found = np.array([made[element.name][0] for element in face])
    assert_apart(found, np.full(found.shape, 2.0 * picker._RADIUS))
    given, found = given - given.mean(axis=0), found - found.mean(axis=0)
    scale = (given * found).sum() / (given * given).sum()
    assert 0.0 < scale <= 1.05 * 2.0 * picker._RADIUS / layout.frame.handle_width
    assert np.abs(found - scale * given).max() < 2.4 * picker._RADIUS


def test_a_track_that_its_handle_would_hide_is_drawn_longer(page):
    (made,) = picker._apart([page.panels[0].marks[0].placed(0.1, np.zeros(2))], np.zeros(2))
    ways = np.concatenate(made.tracks) - made.handle
    assert np.hypot(*ways.T).max() == pytest.approx(2.0 * picker._RADIUS)


def test_a_dwpicker_file_has_a_button_for_every_element(characters):
    document = json.loads(picker.to_dwpicker(picker.picker(characters), "char"))
    _, layout = characters[0]
    buttons = [shape for shape in document["shapes"] if shape["action.targets"]]
    boxes = np.array([[shape[f"shape.{key}"] for key in ("left", "top", "width", "height")] for shape in buttons])
    assert_apart(boxes[:, :2] + 0.5 * boxes[:, 2:], boxes[:, 2:])
    labels = [element.label for element in layout.elements]
    assert sorted(shape["text.content"] for shape in buttons) == sorted(labels)
    assert (boxes[:, 2] >= [5.5 * len(shape["text.content"]) for shape in buttons]).all(), "names fit on their buttons"
    assert (boxes[:, :2] >= 0.0).all()
    assert (boxes[:, :2] + boxes[:, 2:] <= [document["general"]["width"], document["general"]["height"]]).all()


def assert_apart(centres, sizes):
    first, second = np.triu_indices(len(centres), 1)
    missing = 0.5 * (sizes[first] + sizes[second]) - np.abs(centres[first] - centres[second])
    assert not (missing > 1e-6).all(axis=1).any()


def test_crowded_rectangles_are_spread_until_none_overlaps():
    """A hundred names around a mouth, some of them at one place; what has room stays where it is."""
    rng = np.random.default_rng(7)
    centres = np.concatenate([rng.normal(scale=40.0, size=(97, 2)), np.zeros((3, 2)), [[5000.0, 0.0]]])
    sizes = np.stack([rng.uniform(20.0, 120.0, 101), np.full(101, 18.0)], axis=1)
    spread = picker.spread(centres, sizes)
    assert_apart(spread, sizes)
    assert spread[-1].tolist() == [5000.0, 0.0]
    assert np.array_equal(picker.spread(spread, sizes), spread)


def test_a_picker_shows_the_face_pale_and_its_background_has_nothing_else(page):
    (body,) = (panel.body for panel in page.panels if panel.body is not None)
    pixels = np.asarray(body, dtype=float)
    assert pixels[..., 3].max() == round(255 * picker._VEIL)
    assert np.ptp(np.quantile(pixels[pixels[..., 3] > 0][:, :3], [0.02, 0.98])) > 30.0
    assert b"IHDR" in picker.background_png(page)[:32]


def test_characters_and_parts_are_side_by_side(characters, page):
    two = picker.picker([*characters, *characters], labels=True)
    assert two.size == (2 * page.size[0], page.size[1])
    rig, layout = characters[0]
    widths = {"face": layout.frame.handle_width, "hands": 2.0 * layout.frame.handle_width}
    parts = ["hands", *["face"] * len(layout.elements)]
    made = picker.picker([(rig, laid_out.parted(layout, widths, parts))])
    titles = [label.text for panel in made.panels if not panel.grounded for label in panel.labels]
    assert titles == ["face", "hands"]
    assert set(placed(made)) == {element.name for element in layout.elements}


@pytest.mark.parametrize(
    ("name", "read"),
    [
        ('a"<b>&', 'a"<b>&'),
        ("a\tb\nc\rd", "a\tb\nc\rd"),
        ("smi\x1b[31mle\0\uffff", r"smi\x1b[31mle\x00\uffff"),
        ("眉𝄞", "眉𝄞"),
    ],
)
def test_names_stand_in_the_picture(page, name, read):
    panel = next(panel for panel in page.panels if panel.marks)
    mark, first = panel.marks[0], panel.marks[0].element
    member = replace(first.members[0], control=name)
    odd = replace(first, name=name, label=name, members=(member, *first.members[1:]))
    shown = replace(panel, marks=(replace(mark, element=odd),), labels=(Label(name, (0.0, 0.0)),))
    root = ElementTree.fromstring(svg(replace(page, panels=(shown,))))
    group, track = list(root.iter(f"{SVG}g"))[:2]
    assert (group.get("id"), track.get("data-control"), next(root.iter(f"{SVG}text")).text) == (read, read, read)
    assert json.loads(group.get("data-controls"))[0] == name, "JSON spells what XML cannot hold"
