"""Pictures: what is where, what is hidden, what is named, and that both ways of casting rays give the same picture."""

import io
import itertools
from dataclasses import replace

import chain
import laid_out
import limbs
import makers
import numpy as np
import pytest
from PIL import Image

from usdrigui.character import palette
from usdrigui.character.deform import deform
from usdrigui.errors import RigUIError
from usdrigui.pipeline.joining import joined
from usdrigui.pose.evaluate import elements_at, evaluate, prepare
from usdrigui.view import directions, picture, sheet
from usdrigui.view.body import shading
from usdrigui.view.body.complexion import complexion
from usdrigui.view.flat import callouts, framing, lettering, marks, scene as flat
from usdrigui.view.flat.columns import board
from usdrigui.view.flat.pillow import painted
from usdrigui.view.picture import Wanted, contact_sheet, render
from usdrigui.view.sections import sections

SMALL = (640, 400)
BLUE, RED = palette.SIDES["left"], palette.SIDES["right"]
CAMERA = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)


def sided(rig, **given):
    """A layout of the mask whose elements know on which side they are."""
    layout = laid_out.layout_of(rig, **given)
    elements = tuple(replace(each, side="left" if each.anchor.position[0] > 0 else "right") for each in layout.elements)
    return with_width(replace(layout, elements=elements), 0.06)


def seen_from(layout, view):
    return replace(layout, frame=replace(layout.frame, view=view))


def with_width(layout, width):
    return replace(layout, frame=replace(layout.frame, handle_width=width))


@pytest.fixture(scope="module")
def rig():
    return makers.face()


@pytest.fixture(scope="module")
def layout(rig):
    return sided(rig)


@pytest.fixture(scope="module")
def front(rig, layout):
    return render(rig, layout, wanted=Wanted(0.0, SMALL))


def pixels_like(image, colour, tolerance=60):
    """Columns of the pixels of a colour, above the legend."""
    away = np.abs(np.asarray(image, dtype=np.int64)[: image.height - 60] - np.array(colour)).max(axis=2)
    return np.nonzero(away < tolerance)[1]


def test_the_characters_left_is_on_the_right_and_blue(front):
    blue, red = pixels_like(front, BLUE), pixels_like(front, RED)
    assert len(blue) > 100
    assert len(red) > 100
    assert blue.min() > red.max() - 40
    assert np.median(blue) > 320 > np.median(red)


def captions(page):
    """What the views of a page are called."""
    return [panel.labels[0].text for panel in page.panels if not panel.grounded and panel.size[1] == picture._CAPTION]


def crowded(layout, count):
    """The layout with many elements close to each other and one on the board, all with names of their own."""
    one, rng = layout.elements[0], np.random.default_rng(7)
    (member, *_), shifts = one.members, rng.uniform(-0.05, 0.05, (count, 3))
    crowd = [
        replace(
            one,
            name=f"e{i}",
            anchor=replace(one.anchor, position=one.anchor.position + shift),
            members=(replace(member, track=member.track + shift),),
            label=f"e{i}",
        )
        for i, shift in enumerate(shifts)
    ]
    aside = replace(one, name="aside", anchor=replace(one.anchor, on_board=True))
    return replace(layout, elements=(*layout.elements[1:], *crowd, aside))


@pytest.mark.parametrize("count", [3, 110])
def test_every_element_is_named_once_and_those_that_crowd_in_an_inset(rig, layout, count):
    """As large as can be read, however many there are, and nothing covers anything."""
    given = crowded(layout, count)
    page = picture.scene(rig, given, None, Wanted(labels=True))
    named = [label for panel in page.panels if panel.grounded for label in panel.labels if label.ink == flat.INK]
    assert min(label.size for label in named) >= 11
    for one, other in itertools.combinations(page.panels, 2):
        apart = np.subtract(other.corner, one.corner)
        assert ((apart >= one.size) | (-apart >= other.size)).any()
    coloured = {(mark.element.side, mark.colour) for panel in page.panels for mark in panel.marks if mark.element}
    assert coloured <= {*palette.SIDES.items()}, "on the board too"
    assert sorted(label.text for label in named) == sorted(
        [*(each.label for each in layout.elements), *(f"e{i}" for i in range(count))]
    )
    assert ("front, enlarged" in captions(page)) == (count > 12)
    assert captions(picture.scene(rig, given, None, Wanted(0.0, SMALL))) == ["front", "board"]


def test_words_can_be_read_on_every_ground():
    """WCAG 2.1: contrast 4.5."""

    def luminance(colour):
        shares = np.array(colour) / 255.0
        return np.where(shares <= 0.03928, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4) @ [0.2126, 0.7152, 0.0722]

    for ink in (flat.INK, flat.QUIET):
        for ground in (flat.PAPER, flat.GROUND):
            assert (luminance(ground) + 0.05) / (luminance(ink) + 0.05) >= 4.5


@pytest.mark.parametrize(
    ("given", "short"),
    [
        (["h_expressions.AE_h", "h_expressions.AA_h", "h_expressions.Oh_h"], ["AE", "AA", "Oh"]),
        (["rig_face_browUp", "rig_face_browDown", "rig_face_jaw"], ["browUp", "browDown", "jaw"]),
        (["AU_01", "AU_02", "jawOpen", "AU_12"], ["AU_01", "AU_02", "jawOpen", "AU_12"]),
        (
            ["J_Hair_07:spread", "J_Hair_08:spread", "J_Hair_08:curl"],
            ["Hair_07:spread", "Hair_08:spread", "Hair_08:curl"],
        ),
        (["eye-a", "eye-b", "eye-c", "x-a", "y-a", "z-a"], ["eye-a", "eye-b", "eye-c", "x-a", "y-a", "z-a"]),
        (["AU_01", "AU_02"], ["AU_01", "AU_02"]),
        (["a_x", "a_y", "a_z", "x"], ["a_x", "y", "z", "x"]),
        (["mouthLeft", "mouthRight", "mouthUp"], ["mouthLeft", "mouthRight", "mouthUp"]),
        (["a_b", "a_b", "a_b"], ["a_b", "a_b", "a_b"]),
        (["arm_L:rx", "arm_R:rx", "arm_L: ry/rz"], ["arm_L:rx", "arm_R:rx", "arm_L: ry/rz"]),
    ],
)
def test_names_leave_out_what_their_family_shares(given, short):
    assert callouts.shortened(given) == short


def test_a_frame_holds_the_elements_and_the_head_near_them_but_no_arm():
    tracks = [np.array([[-0.3, -0.3, 0.0], [0.3, 0.3, 0.0]])]
    head = np.array([[-0.4, 0.0, 0.0], [0.42, 0.1, 0.0], [0.0, 0.36, 0.0]])
    low, high = framing.framed(tracks, head, np.eye(3), 0.01)
    assert (low < [-0.4, -0.3]).all()
    assert (high > [0.42, 0.36]).all()
    assert (high - low).max() < 1.5 * 0.6, "the elements fill the picture"
    far = np.concatenate([head, [[9.0, 0.0, 0.0], [0.0, -9.0, 0.0]]])
    assert np.array(framing.framed(tracks, far, np.eye(3), 0.01)) == pytest.approx(np.array([low, high]))
    outermost = framing.corners(tracks, far, np.eye(3))
    assert {*map(tuple, head), *map(tuple, tracks[0])} == {*map(tuple, outermost)}, "so does a camera that turns"


@pytest.mark.parametrize("width", [300, 900, 1700])
def test_a_board_fills_its_box_in_columns(rig, layout, width):
    """All elements once, in rows that do not touch, under headings that never end a column."""
    words, posed = ("global", "viseme", "emotion"), elements_at(prepare(rig, layout), layout.base_values)
    elements = [replace(each, category=words[i % 3]) for i, each in enumerate(layout.elements)]
    pairs = [(each, marks.mark(each, at, CAMERA, 0.06)) for each, at in zip(elements, posed, strict=True)]
    panel = board(pairs, (5, 6, width))
    assert (panel.corner, panel.size[0], len(panel.marks)) == ((5, 6), width, len(elements))
    places = np.array([label.place for label in panel.labels])
    assert len(places) == len(elements) + len(set(words))
    assert (places >= 0.0).all()
    assert (places <= panel.size).all()
    headings = [label.place for label in panel.labels if label.ink == flat.QUIET]
    assert len(headings) == len(words)
    assert headings[0] == (14.0, 25.0)
    for heading in headings:  # a row above the first of its names, which stand behind their symbols
        assert np.isclose(places - heading, [48.0, 22.0]).all(axis=1).any()
    for mark in panel.marks:
        points = np.concatenate([*mark.tracks, mark.handle[None]])
        assert (points >= 0.0).all()
        assert np.ptp(points[:, 1]) <= 22.0


@pytest.fixture
def typefaces(monkeypatch):
    """Files of further typefaces, none unless a test adds some."""
    files = []
    monkeypatch.setattr(lettering, "_fallbacks", lambda: tuple(files))
    caches = (lettering._number, lettering._shown, lettering._drawable)
    for each in caches:
        each.cache_clear()
    yield files
    for each in caches:
        each.cache_clear()


def test_a_name_turns_to_the_first_typeface_that_has_all_of_its_letters(typefaces, monkeypatch):
    letters = {0: "brow[U+609]", 1: "brow怒り", 2: "brow龙"}
    monkeypatch.setattr(lettering, "_drawable", lambda letter, number=0: letter in letters[number])
    monkeypatch.setattr(lettering, "_face", lambda *given: given[0])
    typefaces += ["a.ttf", "b.ttf"]
    lettering._number.cache_clear()
    assert [lettering.font(12, name) for name in ("brow", "怒り", "brow龙", "怒龙")] == [0, 1, 2, 0]
    assert [lettering.legible(name) for name in ("brow怒り", "怒龙")] == ["brow怒り", "[U+6012][U+9F99]"]


@pytest.mark.usefixtures("typefaces")
def test_a_picture_whose_names_are_spelt_out_says_how_to_draw_them(rig, layout, monkeypatch):
    named = replace(
        layout,
        elements=(
            replace(layout.elements[0], label="まばたき"),
            *layout.elements[1:],
        ),
    )
    monkeypatch.setattr(lettering, "_fallbacks", tuple)
    (line,) = sheet.spelt_out([(rig, named)])
    assert "pip install weblate-fonts" in line
    assert "まばたき" in line
    assert sheet.spelt_out([(rig, layout)]) == ()
    monkeypatch.setattr(lettering, "_fallbacks", lambda: ("one.ttf",))
    assert sheet.spelt_out([(rig, named)]) == ()


def test_letters_that_the_typeface_lacks_are_drawn_without_accents():
    assert lettering.legible("öffnen_Élevé smile-L") == "offnen_Eleve smile-L"
    assert lettering.legible("ウィンク_あ") == "uinku_a"
    assert lettering.legible("눈") == "nun"
    assert lettering.legible("怒り") == "[U+6012]ri"
    assert lettering.legible("line\nbreak\t") == r"line\nbreak\t"
    box = bytes(lettering.font(12).getmask("\uffff"))
    assert all(bytes(lettering.font(12).getmask(each)) != box for each in lettering.legible("äčñå"))


def test_names_are_cut_to_their_room():
    assert lettering.cut("chin", 12, 100.0) == "chin"
    short = lettering.cut("Pupil_Constriction_Left", 12, 90.0)
    assert lettering.width_of(short, 12) <= 90.0
    assert (short[:5], short[-4:]) == ("Pupil", "Left")


def drawn(mark):
    """A mark alone on the ground of a panel."""
    page = flat.Page((300, 300), (flat.Panel((0, 0), (300, 300), None, (mark,)),))
    return np.asarray(painted(page)).astype(int)


def test_what_the_face_hides_is_drawn_faintly(rig, layout):
    subject = shading.subject_of(rig.body.meshes, deform(rig), complexion(rig, layout))
    depth = shading.shade(subject, CAMERA).depth
    element, at = layout.elements[0], elements_at(prepare(rig, layout), layout.base_values)[0]
    back = np.array([0.0, 0.0, 1.0])
    behind = replace(at, tracks=tuple(track - back for track in at.tracks), handle=at.handle - back)
    seen, hidden = (marks.mark(element, posed, CAMERA, 0.06, depth) for posed in (at, behind))
    assert (seen.hidden, hidden.hidden, bool(hidden.seen[0].any())) == (False, True, False)
    strong, faint = (drawn(mark).min() for mark in (seen, hidden))
    assert strong < 80 < faint < 220


def test_each_handle_is_as_wide_as_those_of_its_part(rig, layout):
    """Also in a picture of parts of several widths."""
    element, at = layout.elements[0], elements_at(prepare(rig, layout), layout.base_values)[0]
    inked = [(drawn(marks.mark(element, at, CAMERA, width)) < 200).any(axis=2).sum() for width in (0.1, 0.3)]
    assert inked[1] > 3 * inked[0]


def test_a_fan_has_the_handle_of_four_corners():
    ((outline,), _) = marks.handle_outlines(flat.Mark("fan", flat.INK, np.zeros(2), 1.0))
    assert len(outline) == 4


def crossed(at, ends):
    """A posed element whose two straight tracks run to the right and up, from the first to the second of `ends`."""
    axes = np.eye(3)[:2]
    return replace(at, tracks=tuple(at.rest + np.outer(pair, axis) for pair, axis in zip(ends, axes, strict=True)))


@pytest.mark.parametrize(
    ("ends", "count", "area"),
    [
        ([(-0.2, 0.2), (-0.1, 0.1)], 4, 0.08),
        ([(-0.05, 0.2), (-0.1, 0.3)], 4, 0.1),
        ([(0.0, 0.2), (-0.1, 0.1)], 2, 0.04),
        ([(0.0, 0.2), (0.0, 0.1)], 1, 0.02),
    ],
)
def test_signed_axes_span_every_quadrant_once(rig, ends, count, area):
    layout = laid_out.layout_of(rig, groups=[("jawLeft", "chin")])
    at = crossed(elements_at(prepare(rig, layout), layout.base_values)[0], ends)
    fields = marks.mark(layout.elements[0], at, CAMERA, 0.06).fields
    assert len(fields) == count
    assert sum(map(surface, fields)) == pytest.approx(area * 100.0**2)


def surface(outline):
    """Area of a closed outline (k, 2)."""
    x, y = outline.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


@pytest.mark.parametrize(
    ("view", "expected"),
    [
        ((0, 0, 1), ["front", "three-quarter, character's left", "three-quarter, character's right"]),
        ((1, 0, 0), ["side, character's left", "three-quarter, character's left", "front"]),
        ((0, 0, -1), ["back"]),
        ((0.6, 0, 0.8), ["azimuth 36.9°, elevation 0°", "front", "three-quarter, character's right"]),
        (np.array([-1, 1, -1]) / np.sqrt(3), ["three-quarter back, character's right, from above"]),
        (
            (0, 1, 0),
            ["above", "three-quarter, character's left", "three-quarter, character's right"],
        ),
    ],
)
def test_captions_say_from_where_the_layout_is_seen(rig, layout, view, expected):
    """Whatever view a layout was made for: that comes first, then what shows the same."""
    page = picture.scene(rig, seen_from(layout, np.array(view, dtype=np.float64)), None, Wanted())
    assert captions(page) == expected


def test_camera_turns_points_to_pixels_and_back(rig, layout):
    up = rig.up
    rows = directions.camera_rows(layout, up, np.array([0.3, -0.2, 0.9]))
    assert rows @ rows.T == pytest.approx(np.eye(3), abs=1e-12)
    camera = shading.Camera(rows, np.array([1.0, 2.0, 3.0]), 50.0, 200, 100)
    at = camera.project(camera.unproject(np.array([[13.0, 77.0]]), 0.4))
    assert at[0] == pytest.approx([13.0, 77.0, 0.4])
    above = directions.camera_rows(layout, up, up)
    assert above[1:] == pytest.approx(np.stack([-directions.ahead_of(layout, up), up])), "as on a table"


def test_a_body_with_collapsed_and_missing_points_is_still_drawn(rig, layout):
    points = np.concatenate([mesh.points for mesh in rig.body.meshes])
    points[5] = np.nan
    points[100:140] = 0.0
    camera = shading.Camera(np.eye(3), np.zeros(3), 60.0, 120, 120)
    shaded = shading.shade(shading.subject_of(rig.body.meshes, points, complexion(rig, layout)), camera)
    assert np.isfinite(shaded.colour).all()
    assert shaded.cover.max() == 1.0
    assert shaded.colour[shaded.cover == 0.25].sum() > 0.8, "where one sample of four meets the skin, it is as light"


def test_several_characters_are_each_named_once(rig, layout, front, monkeypatch):
    """By the picture itself; the sheet adds nothing below it."""
    monkeypatch.setattr(sheet, "render", lambda *_, **__: front)
    page = Image.open(io.BytesIO(sheet.sheet_png([(rig, layout), (rig, layout)])))
    assert page.height == contact_sheet([front, front]).height < contact_sheet([front, front], ["a", "b"]).height


def test_refuses_what_it_cannot_draw(layout):
    with pytest.raises(RigUIError, match="LAYOUT_STALE"):
        render(makers.face(columns=21), layout)


def test_a_layout_without_elements_shows_the_character(rig, layout):
    assert render(rig, replace(layout, elements=()), wanted=Wanted(0.0, SMALL)).size == SMALL


@pytest.mark.parametrize("count", [3, 12, 30])
def test_leader_lines_cross_no_other_and_no_name(count):
    """Handles in a crowd, in rows closer than those of their names, and names of every length."""
    random = np.random.default_rng(7)
    places = random.uniform([250.0, 20.0], [550.0, 180.0], (count, 2))
    texts = ["n" * random.integers(1, 30) for _ in range(count)]
    labels, leaders = callouts.called_out(places, texts, (800, 600))
    assert sorted(label.text for label in labels) == sorted(texts)
    assert sum(label.anchor[0] == "l" for label in labels) == count // 2
    assert {tuple(line[-1]) for line in leaders} == set(map(tuple, places))
    for anchor in "lr":
        lines = [line for line, label in zip(leaders, labels, strict=True) if label.anchor[0] == anchor]
        assert not any(crossing(a, b) for i, a in enumerate(lines) for b in lines[:i])
        assert len({line[1, 0] for line in lines}) == 1
    for label, line in zip(labels, leaders, strict=True):
        inward = 1.0 if label.anchor == "lm" else -1.0
        text_end = label.place[0] + inward * lettering.width_of(label.text, label.size)
        assert inward * text_end < inward * line[0, 0] < inward * line[1, 0]


def crossing(one, other):
    """Whether two lines (3, 2) cross."""

    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def apart(a, b, c, d):
        return turn(a, b, c) * turn(a, b, d) >= 0.0 or turn(c, d, a) * turn(c, d, b) >= 0.0

    return any(not apart(*one[i : i + 2], *other[j : j + 2]) for i in range(2) for j in range(2))


def test_a_character_in_parts_has_a_close_up_of_each_part_and_of_each_hand():
    """Hands lie apart and are shown one by one, from their own side; every element is in one section."""
    rig = limbs.whole_body()
    layout = joined(chain.laid_parts(rig))
    found = sections(rig, layout, evaluate(prepare(rig, layout)))
    assert [each.title for each in found] == ["face", "hands, character's left", "hands, character's right", "body"]
    shown = [element.name for each in found for element in each.layout.elements]
    assert sorted(shown) == sorted(element.name for element in layout.elements)
    np.testing.assert_allclose(found[2].views, np.array(found[1].views) * [-1.0, 1.0, 1.0], atol=1e-9)
    eyes = [next(element for element in each.layout.elements if element.side != "none") for each in found[1:3]]
    pair = replace(layout, elements=tuple(eyes))
    assert [each.title for each in sections(rig, pair, evaluate(prepare(rig, pair)))][1] == "hands"
    page = picture.scene(rig, layout, None, Wanted(size=(320, 240)))
    drawn = {mark.element.name for panel in page.panels for mark in panel.marks if mark.element and not mark.hidden}
    assert drawn == {element.name for element in layout.elements}, "each is unhidden in one view"
    # The inside of a mouth: a face that hides it need not be drawn again.
    aside = tuple(
        replace(each, anchor=replace(each.anchor, on_board=True)) if each.part == "body" else each
        for each in layout.elements
    )
    boards = picture.scene(rig, replace(layout, elements=aside), None, Wanted(size=(320, 240)))
    assert captions(boards)[-1] == "board"
    assert len(captions(boards)) < len(captions(page))
