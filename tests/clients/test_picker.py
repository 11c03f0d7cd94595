"""`usdrigui picker`: flat pickers with every element at its place."""

import json
import xml.etree.ElementTree as ElementTree
from dataclasses import replace

import numpy as np
import pytest

from usdrigui import pipeline
from usdrigui.cli import main
from usdrigui.clients import picker
from usdrigui.model import LayoutPart
from usdrigui.settings import Settings

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def layer(laid_out):
    return laid_out / "char.rigui.usda"


@pytest.fixture(scope="module")
def characters(layer):
    return pipeline.load_layer(layer, Settings()).characters


def test_writes_both_and_says_so(layer, tmp_path, capsys):
    svg, dwpicker = tmp_path / "out.svg", tmp_path / "out.json"
    assert main(["picker", str(layer), "--svg", str(svg), "--dwpicker", str(dwpicker)]) == 0
    assert svg.is_file()
    behind = tmp_path / "out.background.png"
    (image,) = {shape["image.path"] for shape in json.loads(dwpicker.read_text())["shapes"]} - {""}
    assert (image, behind.read_bytes()[:4]) == (f"$DWPICKER_PROJECT_DIRECTORY/{behind.name}", b"\x89PNG")
    assert capsys.readouterr().out.splitlines()[-1].startswith("usdrigui: picker of")
    before = svg.read_bytes()
    assert main(["picker", str(layer), "--svg", str(svg)]) == 0
    assert svg.read_bytes() == before
    assert main(["picker", str(layer)]) == 2


def test_every_element_and_track_is_in_the_picture(characters):
    made = picker.picker(characters)
    root = ElementTree.fromstring(picker.to_svg(made))
    groups = {group.get("id"): group for group in root.iter(f"{SVG}g")}
    (_, layout) = characters[0]
    assert set(groups) == {element.name for element in layout.elements}
    for element in layout.elements:
        group = groups[element.name]
        controls = [member.control for member in element.manipulator.members]
        assert json.loads(group.get("data-controls")) == controls
        assert [each.get("data-control") for each in group.iter(f"{SVG}polyline")] == controls
        assert group.get("data-anchor") == f"{element.anchor.mesh}#{element.anchor.point}"
    for spot in made.spots:
        points = np.vstack([spot.handle, *spot.tracks])
        assert (points >= 0.0).all()
        assert (points <= made.size).all()


def test_places_are_those_of_the_view(characters):
    """At one scale, but for what keeps handles apart; the character's left is on the right; up is up."""
    rig, layout = characters[0]
    made = {spot.element.name: spot for spot in picker.picker(characters).spots}
    plane = np.stack([np.cross(rig.skel_root.up, layout.frame.view), -rig.skel_root.up], axis=1)
    face = [element for element in layout.elements if not element.anchor.on_board]
    given = np.array([element.anchor.position @ plane for element in face])
    found = np.array([made[element.name].handle for element in face])
    given, found = given - given.mean(axis=0), found - found.mean(axis=0)
    scale = (given * found).sum() / (given * given).sum()
    assert 0.0 < scale <= 1.05 * picker._HANDLE / layout.frame.handle_width
    assert np.abs(found - scale * given).max() < 1.2 * picker._HANDLE


def test_a_dwpicker_file_has_a_button_for_every_element(characters):
    document = json.loads(picker.to_dwpicker(picker.picker(characters), "char"))
    _, layout = characters[0]
    buttons = [shape for shape in document["shapes"] if shape["action.targets"]]
    assert [shape["action.targets"] for shape in buttons] == [
        [member.control for member in element.manipulator.members] for element in layout.elements
    ]
    assert document["general"]["name"] == "char"
    keys = set(document["shapes"][0])
    assert all(set(shape) == keys for shape in document["shapes"])
    assert document["shapes"][0]["background"]
    assert not any(shape["background"] for shape in buttons)

    boxes = np.array([[shape[f"shape.{key}"] for key in ("left", "top", "width", "height")] for shape in buttons])
    assert_apart(boxes[:, :2] + 0.5 * boxes[:, 2:], boxes[:, 2:])
    assert [shape["text.content"] for shape in buttons] == [element.look.label for element in layout.elements]
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


def test_a_picker_shows_the_face_and_no_margin_beyond_it(characters):
    """The picture shades the face; all that is drawn fills the view box but for one margin; no handle hides another."""
    made = picker.picker(characters)
    (backdrop,) = made.backdrops
    grey = np.asarray(backdrop.image.convert("L"), dtype=float)[np.asarray(backdrop.image)[..., 3] == 255]
    assert np.ptp(np.quantile(grey, [0.02, 0.98])) > 15.0
    drawn = np.concatenate([*backdrop.outline, *(picker._drawn(spot) for spot in made.spots)])
    np.testing.assert_allclose(drawn.min(axis=0), picker._MARGIN, atol=0.1)
    np.testing.assert_allclose(made.size - drawn.max(axis=0), picker._MARGIN, atol=0.1)
    handles = np.array([spot.handle for spot in made.spots])
    assert_apart(handles, np.full(handles.shape, picker._HANDLE))


def test_characters_stand_side_by_side(characters):
    one, two = picker.picker(characters), picker.picker([*characters, *characters])
    np.testing.assert_allclose(two.size, one.size * [2, 1])
    shift = two.spots[len(one.spots)].handle - one.spots[0].handle
    np.testing.assert_allclose(shift, [one.size[0], 0.0], atol=1e-9)


@pytest.mark.parametrize(
    ("name", "read"),
    [
        ('a"<b>&', 'a"<b>&'),
        ("a\tb\nc\rd", "a\tb\nc\rd"),
        ("smi\x1b[31mle\0\uffff", r"smi\x1b[31mle\x00\uffff"),
        ("眉𝄞", "眉𝄞"),
    ],
)
def test_names_stand_in_the_picture(characters, name, read):
    made = picker.picker(characters)
    first = made.spots[0].element
    member = replace(first.manipulator.members[0], control=name)
    odd = replace(
        first,
        name=name,
        look=replace(first.look, label=name),
        manipulator=replace(first.manipulator, members=(member, *first.manipulator.members[1:])),
    )
    svg = picker.to_svg(replace(made, spots=(replace(made.spots[0], element=odd), *made.spots[1:])))
    group = next(ElementTree.fromstring(svg).iter(f"{SVG}g"))
    assert (group.get("id"), next(group.iter(f"{SVG}polyline")).get("data-control")) == (read, read)
    assert json.loads(group.get("data-controls"))[0] == name, "JSON spells what XML cannot hold"


def aside(characters, down=0.0):
    """The characters with their first element far off on a board."""
    from dataclasses import replace

    rig, layout = characters[0]
    far = (
        60.0 * layout.frame.handle_width * np.cross(rig.skel_root.up, layout.frame.view)
        + down * layout.frame.handle_width * rig.skel_root.up
    )
    one = layout.elements[0]
    members = tuple(replace(each, track=each.track + far) for each in one.manipulator.members)
    anchor = replace(one.anchor, on_board=True, position=one.anchor.position + far)
    moved = replace(
        one,
        anchor=anchor,
        manipulator=replace(one.manipulator, members=members),
        look=replace(one.look, adapt="deform"),
    )
    others = [each for each in layout.elements[1:] if not each.anchor.on_board]
    return [(rig, replace(layout, elements=(moved, *others)))]


@pytest.mark.parametrize("down", [0.0, -90.0, 90.0])
def test_the_board_stands_next_to_the_silhouette(characters, down):
    made = picker.picker(aside(characters, down))
    board = next(spot for spot in made.spots if spot.element.anchor.on_board)
    outline = np.concatenate(made.backdrops[0].outline)
    left = min(track[:, 0].min() for track in board.tracks)
    face = np.concatenate([picker._drawn(spot) for spot in made.spots if not spot.element.anchor.on_board])
    right = max(outline[:, 0].max(), face[:, 0].max())
    assert left - right < 2.0 * picker._GAP
    drawn = picker._drawn(board)
    assert left > face[:, 0].max()
    assert outline[:, 1].min() - 1.0 <= drawn[:, 1].min()
    assert drawn[:, 1].max() <= outline[:, 1].max() + 3.0


def test_names_on_the_face_are_shown_on_request_and_stand_apart(characters):
    plain, named = (picker.picker(characters, labels=given) for given in (False, True))
    assert not any(spot.lead is not None for spot in plain.spots)
    root = ElementTree.fromstring(picker.to_svg(named))
    texts = {each.text for each in root.iter(f"{SVG}text")}
    assert {spot.element.look.label for spot in named.spots} <= texts
    for side in (True, False):
        rows = sorted(s.lead[0, 1] for s in named.spots if s.lead is not None and (s.lead[0, 0] < s.handle[0]) == side)
        assert all(step > 0.99 * picker._PITCH for step in np.diff(rows))
    one, other = (
        np.array([spot.handle for spot in made.spots if not spot.element.anchor.on_board]) for made in (plain, named)
    )
    np.testing.assert_allclose(np.diff(one, axis=0), np.diff(other, axis=0), atol=1e-9)


def test_each_part_has_a_panel_at_the_scale_of_its_own_handles(characters):
    rig, layout = characters[0]
    widths = {"face": layout.frame.handle_width, "hands": 2.0 * layout.frame.handle_width}
    parts = tuple(LayoutPart(name, width, layout.frame.view, "optimal", 0.0, 0.0) for name, width in widths.items())
    first, *others = layout.elements
    elements = (
        replace(first, placement=replace(first.placement, part="hands")),
        *(replace(each, placement=replace(each.placement, part="face")) for each in others),
    )
    made = picker.picker([(rig, replace(layout, elements=elements, frame=replace(layout.frame, parts=parts)))])
    assert [backdrop.title for backdrop in made.backdrops] == ["face", "hands"]
    wider = tuple(replace(each, low=each.low - [90.0, 0.0]) for each in made.backdrops)  # than what is seen of it
    root = ElementTree.fromstring(picker.to_svg(replace(made, backdrops=wider)))
    titles = {each.text: float(each.get("x")) for each in root.iter(f"{SVG}text") if each.text in ("face", "hands")}
    for backdrop in made.backdrops:
        assert titles[backdrop.title] == pytest.approx(np.concatenate(backdrop.outline)[:, 0].min(), abs=0.01)
    whole = {spot.element.name: np.ptp(spot.tracks[0], axis=0).max() for spot in picker.picker(characters).spots}
    shares = {
        spot.element.name: np.ptp(spot.tracks[0], axis=0).max() / max(whole[spot.element.name], 1e-9)
        for spot in made.spots
    }
    assert shares[first.name] < 0.6 * np.nanmax([shares[each.name] for each in others])
