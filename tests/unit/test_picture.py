"""Pictures: what is where, what is hidden, and that both ways of casting rays give the same picture."""

from __future__ import annotations

import io
from dataclasses import replace

import chain
import laid_out
import limbs
import makers
import numpy as np
import pytest
from PIL import Image

from usdrigui import palette
from usdrigui.errors import RigUIError
from usdrigui.pipeline.stages import joined
from usdrigui.pose.evaluate import elements_at, evaluate, prepare, values_of
from usdrigui.rays import GridCaster
from usdrigui.view import lettering, overlay, picture, shading, sheet
from usdrigui.view import sheet as view_sheet
from usdrigui.view.complexion import complexion
from usdrigui.view.picture import contact_sheet, render
from usdrigui.view.sections import cut_away, sections

SMALL = (640, 400)
BLUE, RED, VIOLET = palette.SIDES["left"], palette.SIDES["right"], palette.BOARD


def sided(rig, **given):
    """A layout of the mask whose elements know on which side they are."""
    layout = laid_out.layout_of(rig, **given)
    elements = tuple(
        replace(each, look=replace(each.look, side="left" if each.anchor.position[0] > 0 else "right"))
        for each in layout.elements
    )
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
    return render(rig, layout, views=["front"], size=SMALL)


def pixels_like(image, colour, tolerance=60):
    """Columns of the pixels of a colour, above the legend."""
    away = np.abs(np.asarray(image, dtype=np.int64)[: image.height - 60] - np.array(colour)).max(axis=2)
    return np.nonzero(away < tolerance)[1]


def test_the_picture_has_the_size_asked_for_and_shows_skin_on_a_light_ground(front):
    assert front.size == SMALL
    assert front.mode == "RGB"
    pixels = np.asarray(front, dtype=np.float64)
    assert pixels[150, 30].min() > 215
    skin = pixels[200, 320]
    assert 60 < skin.mean() < 235
    assert skin[0] > skin[2]


def test_the_same_input_gives_the_same_pixels(rig, layout, front):
    assert render(rig, layout, views=["front"], size=SMALL).tobytes() == front.tobytes()


def test_the_characters_left_is_on_the_right_and_blue(front):
    blue, red = pixels_like(front, BLUE), pixels_like(front, RED)
    assert len(blue) > 100
    assert len(red) > 100
    assert blue.min() > red.max() - 40
    assert np.median(blue) > 320 > np.median(red)


def test_a_view_of_one_side_shows_that_side(rig, layout):
    left = render(rig, layout, views=["left"], size=(960, 600))
    right = render(rig, layout, views=["right"], size=(960, 600))
    assert len(pixels_like(left, BLUE)) > 3 * len(pixels_like(left, RED))
    assert len(pixels_like(right, RED)) > 3 * len(pixels_like(right, BLUE))


def aside(layout, place):
    """The layout with its elements on the board moved to a place, their tracks three units long."""
    moved = []
    for each in layout.elements:
        if each.anchor.on_board:
            line = np.array(place) + np.linspace(0.0, 0.4, len(each.manipulator.members[0].values))[:, None] * [
                1.0,
                0.0,
                0.0,
            ]
            members = (replace(each.manipulator.members[0], track=line),)
            each = replace(
                each,
                anchor=replace(each.anchor, position=np.array(place)),
                manipulator=replace(each.manipulator, members=members),
            )
        moved.append(each)
    return replace(layout, elements=tuple(moved))


def test_the_board_has_a_panel_of_its_own_below_the_others(rig):
    """Nothing of the character is in it, and nothing of it in the picture of the character, wherever it stands."""
    layout = aside(sided(rig, beside=("chin",)), (0.2, 0.2, 0.5))
    assert [each.caption for each in scene_of(rig, layout, ["front", "left34"]).panels] == [
        "front",
        "three-quarter, character's left",
        "board",
    ]
    shown = render(rig, layout, views=["front"], size=SMALL)
    scene = picture._set_up(rig, layout, evaluate(prepare(rig, layout)), ["front"], SMALL, False)
    top, board = scene.corners[1][1], scene.cameras[1]
    assert shown.size == (SMALL[0], SMALL[1] + board.height + 24)
    assert len(pixels_like(shown.crop((0, 0, SMALL[0], top + 60)), VIOLET, 40)) == 0
    below = shown.crop((0, top, SMALL[0], top + board.height + 60))
    assert len(pixels_like(below, VIOLET, 40)) > 10
    assert np.ptp(np.asarray(below, dtype=int)[board.height // 2, 400:600], axis=0).max() < 3
    assert len(pixels_like(render(rig, layout, views=["left34"], size=SMALL), VIOLET, 40)) == 0


def test_names_on_a_board_are_large_enough_to_read(rig):
    """However wide the character is beside its handles."""
    layout = with_width(aside(sided(rig, beside=("chin", "jawLeft")), (1.4, 0.5, 0.5)), 0.01)
    scene = scene_of(rig, layout, ["front"])
    assert 0.01 * scene.cameras[1].scale == pytest.approx(picture._ON_BOARD)


@pytest.mark.parametrize("height", [400, 640])
def test_the_heading_of_a_board_at_the_upper_edge_is_not_cut(rig, monkeypatch, height):
    """The board stands higher than anything else: its heading needs room above it."""
    tops, headings = [], lettering._headings

    def spied(*given):
        tops.extend(y for _, _, y in headings(*given))
        return headings(*given)

    monkeypatch.setattr(lettering, "_headings", spied)
    render(rig, aside(sided(rig, beside=("chin",)), (1.4, 1.9, 0.5)), views=["front"], size=(640, height))
    assert len(tops) == 1
    assert tops[0] > 8.0


def test_the_line_below_the_title_ends_where_the_picture_does(rig, layout):
    wide, narrow = (picture._numbers(len(rig.controls), layout, width) for width in (2000.0, 300.0))
    assert wide.startswith(narrow)
    assert lettering.font(14).getlength(narrow) <= 300.0 < lettering.font(14).getlength(wide)
    assert "12 controls" in narrow


def test_names_beside_the_face_are_cut_to_their_room():
    face = lettering.font(12)
    assert lettering.cut("chin", face, 100.0) == "chin"
    short = lettering.cut("Pupil_Constriction_Left", face, 90.0)
    assert face.getlength(short) <= 90.0
    assert short.startswith("Pupil")
    assert short.endswith("Left")


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
            replace(layout.elements[0], look=replace(layout.elements[0].look, label="まばたき")),
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


def test_what_the_face_hides_is_drawn_faintly(rig, layout):
    camera = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)
    subject = shading.subject_of(rig.body.meshes, np.concatenate([mesh.points for mesh in rig.body.meshes]))
    depth = shading.shade(subject, camera).depth
    element, at = layout.elements[0], elements_at(prepare(rig, layout), layout.character.base_values)[0]
    behind = replace(
        at, tracks=tuple(track - [0.0, 0.0, 1.0] for track in at.tracks), handle=at.handle - [0.0, 0.0, 1.0]
    )
    seen = overlay.mark(element, at, camera, depth, 0.06)
    hidden = overlay.mark(element, behind, camera, depth, 0.06)
    assert seen.handle_seen
    assert not hidden.handle_seen
    assert not hidden.seen[0].any()
    ground = Image.new("RGB", (300, 300), (255, 255, 255))
    faint = np.asarray(overlay.draw(ground, [hidden]))
    strong = np.asarray(overlay.draw(ground, [seen]))
    assert strong.min() < 60 < faint.min() < 220


def test_each_handle_is_as_wide_as_those_of_its_part(rig, layout):
    """Also in a picture of parts of several widths."""
    camera = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)
    element, at = layout.elements[0], elements_at(prepare(rig, layout), layout.character.base_values)[0]
    ground, nothing = Image.new("RGB", (300, 300), (255, 255, 255)), np.full((300, 300), -np.inf)
    inked = [
        (np.asarray(overlay.draw(ground, [overlay.mark(element, at, camera, nothing, width)])) < 255).any(axis=2).sum()
        for width in (0.1, 0.3)
    ]
    assert inked[1] > 3 * inked[0]


def test_a_pose_moves_face_and_elements(rig, layout, front):
    posed = render(rig, layout, values_of(rig, {"smile_L": 1.0, "jawLeft": 1.0}), views=["front"], size=SMALL)
    assert (np.asarray(posed) != np.asarray(front)).any(axis=2).mean() > 0.01


def test_labels_are_drawn_on_request(rig, layout, front):
    named = render(rig, layout, views=["front"], size=SMALL, labels=True)
    assert (np.asarray(named) != np.asarray(front)).any(axis=2).mean() > 0.01


def test_long_names_leave_the_face_its_room(rig, layout):
    first, *others = layout.elements
    long = replace(
        layout, elements=(replace(first, look=replace(first.look, label="Mouth_Closed_Move_Right / " * 5)), *others)
    )

    def scale(given):
        posed = evaluate(prepare(rig, given))
        return picture._set_up(rig, given, posed, ["front", "left34", "right34"], (1800, 1000), True).cameras[0].scale

    assert scale(long) > 0.75 * scale(layout)


def test_captions_end_where_their_panels_do(rig, layout, monkeypatch):
    written = []
    real = lettering.cut
    monkeypatch.setattr(lettering, "cut", lambda *given: written.append((given, real(*given))) or written[-1][1])
    render(rig, layout, views=["left34"] * 4, size=SMALL)
    captions = [(given[1], given[2], text) for given, text in written if given[0].startswith("three")]
    assert len(captions) == 4
    assert all(type_.getlength(text) <= free for type_, free, text in captions)


def test_pictures_without_embree_look_the_same(rig, layout, front, monkeypatch):
    monkeypatch.setattr(shading, "make_caster", GridCaster)
    other = render(rig, layout, views=["front"], size=SMALL)
    apart = np.abs(np.asarray(front, dtype=np.int64) - np.asarray(other, dtype=np.int64)).max(axis=2)
    assert (apart > 8).mean() < 0.005


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
    at = crossed(elements_at(prepare(rig, layout), layout.character.base_values)[0], ends)
    camera = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)
    fields = overlay.mark(layout.elements[0], at, camera, np.full((300, 300), -np.inf), 0.06).fields
    assert len(fields) == count
    assert sum(surface(each) for each in fields) == pytest.approx(area * 100.0**2)


def surface(outline):
    """Area of a closed outline (k, 2)."""
    x, y = outline.T
    return 0.5 * abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


SIDE = np.array([1.0, 0.0, 0.0])


def scene_of(rig, layout, views=None):
    return picture._set_up(rig, layout, evaluate(prepare(rig, layout)), views, (1800, 1000), False)


@pytest.mark.parametrize(
    ("view", "captions"),
    [
        ((0, 0, 1), ["front", "three-quarter, character's left", "three-quarter, character's right"]),
        ((1, 0, 0), ["side, character's left", "three-quarter, character's left", "front"]),
        ((0, 0, -1), ["back"]),
        ((0.6, 0, 0.8), ["azimuth 36.9°, elevation 0°", "front", "three-quarter, character's right"]),
        (
            (0, 1, 0),
            ["azimuth 0°, elevation 90°", "three-quarter, character's left", "three-quarter, character's right"],
        ),
    ],
)
def test_captions_say_from_where_the_layout_is_seen(rig, layout, view, captions):
    """Whatever view a layout was made for: that comes first, then what shows the same."""
    scene = scene_of(rig, seen_from(layout, np.array(view, dtype=np.float64)))
    assert [each.caption for each in scene.panels] == captions
    assert scene.cameras[0].rows[2] == pytest.approx(view)


def test_views_turned_from_the_side_are_captioned_as_what_they_show(rig, layout):
    scene = scene_of(rig, seen_from(layout, SIDE), ["front", "left", "right"])
    assert [each.caption for each in scene.panels] == ["side, character's left", "back", "front"]


def test_a_frame_holds_the_whole_head_and_no_arm():
    """Elements in a corner of the face do not cut the head on the other side, nor its crown."""
    low, high = (np.array(each) for each in ((-0.3, -0.3), (0.3, 0.3)))
    head = np.array([[-0.5, 0.0], [0.6, 0.0], [0.0, 0.5], [0.0, -0.4]])
    found_low, found_high = picture._around_head(low, high, (0.8 * low, 0.8 * high), head)
    assert (found_low < head.min(axis=0)).all()
    assert (found_high > head.max(axis=0)).all()
    arms = np.array([[-9.0, 0.0], [9.0, 0.0], [0.0, -9.0]])
    assert picture._around_head(low, high, (0.8 * low, 0.8 * high), arms) == (pytest.approx(low), pytest.approx(high))


def test_patches_and_fans_span_fields_and_axes_do_not(rig):
    layout = laid_out.layout_of(rig, groups=[("jawLeft", "chin"), ("jawLeft", "jawRight"), ("brow_L",)])
    posed = list(elements_at(prepare(rig, layout), layout.character.base_values))
    posed[0] = crossed(posed[0], [(0.0, 0.1), (0.0, 0.1)])
    camera = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)
    depth = np.full((300, 300), -np.inf)
    marks = [overlay.mark(*pair, camera, depth, 0.06) for pair in zip(layout.elements, posed, strict=True)]
    assert [len(each.fields) for each in marks] == [1, 0, 0]
    assert [each.form for each in marks] == ["patch", "patch", "slider"]


def test_the_two_ends_of_an_axis_span_no_field_however_bent_it_is(rig):
    layout = laid_out.layout_of(rig, groups=[("jawLeft", "jawRight")])
    at = crossed(elements_at(prepare(rig, layout), layout.character.base_values)[0], [(0.0, 0.1), (0.0, 0.1)])
    camera = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)
    stick = replace(layout.elements[0], manipulator=replace(layout.elements[0].manipulator, opposed=((0, 1),)))
    assert overlay.mark(stick, at, camera, np.full((300, 300), -np.inf), 0.06).fields == ()


def test_a_field_is_the_parallelogram_of_its_members(rig):
    layout = laid_out.layout_of(rig, groups=[("jawLeft", "chin")])
    at = crossed(elements_at(prepare(rig, layout), layout.character.base_values)[0], [(0.0, 0.1), (0.0, 0.1)])
    camera = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)
    outline = overlay.mark(layout.elements[0], at, camera, np.full((300, 300), -np.inf), 0.06).fields[0]
    corner = at.tracks[0][-1] + at.tracks[1][-1] - at.rest
    assert np.linalg.norm(outline - camera.project(corner)[:2], axis=1).min() < 1e-6


def test_camera_turns_points_to_pixels_and_back():
    rows = shading.look(np.array([0.3, -0.2, 0.9]), np.array([0.0, 1.0, 0.0]))
    assert rows @ rows.T == pytest.approx(np.eye(3), abs=1e-12)
    camera = shading.Camera(rows, np.array([1.0, 2.0, 3.0]), 50.0, 200, 100)
    at = camera.project(camera.unproject(np.array([[13.0, 77.0]]), 0.4))
    assert at[0] == pytest.approx([13.0, 77.0, 0.4])
    above = shading.look(np.array([0.0, 1.0, 0.0]), np.array([0.0, 1.0, 0.0]))
    assert above @ above.T == pytest.approx(np.eye(3), abs=1e-12)


def test_a_body_with_collapsed_and_missing_points_is_still_drawn(rig):
    points = np.concatenate([mesh.points for mesh in rig.body.meshes])
    points[5] = np.nan
    points[100:140] = 0.0
    camera = shading.Camera(np.eye(3), np.zeros(3), 60.0, 120, 120)
    shaded = shading.shade(shading.subject_of(rig.body.meshes, points), camera)
    assert np.isfinite(shaded.colour).all()
    assert shaded.cover.max() == 1.0


def test_rows_of_names_never_touch():
    rows = lettering.spread(np.sort(np.random.default_rng(2).normal(100, 3, 12)), 10.0, 0.0, 300.0)
    assert np.diff(rows).min() >= 10.0 - 1e-9
    assert abs(rows.mean() - 100) < 3
    assert lettering.spread(np.array([5.0, 200.0]), 10.0, 0.0, 300.0) == pytest.approx([5.0, 200.0])


def test_several_characters_are_each_named_once(rig, layout, front, monkeypatch):
    """By the picture itself; the sheet adds nothing below it."""
    monkeypatch.setattr(view_sheet, "render", lambda *_, **__: front)
    page = Image.open(io.BytesIO(view_sheet.sheet_png([(rig, layout), (rig, layout)])))
    assert page.height == contact_sheet([front, front]).height < contact_sheet([front, front], ["a", "b"]).height


def test_contact_sheets_hold_every_picture(front):
    sheet = contact_sheet([front, front, front], ["one", "two", "three"], columns=2, width=900)
    assert sheet.width == 900
    assert sheet.height > 2 * 400 * 430 / 640


def test_refuses_what_it_cannot_draw(rig, layout, front):
    with pytest.raises(RigUIError, match="CONFIG_VALUE views"):
        render(rig, layout, views=["above"])
    with pytest.raises(RigUIError, match="CONFIG_VALUE views"):
        render(rig, layout, views=[])
    with pytest.raises(RigUIError, match="CONFIG_VALUE size"):
        render(rig, layout, size=(100, 100))
    with pytest.raises(RigUIError, match="LAYOUT_STALE"):
        render(makers.face(columns=21), layout, size=SMALL)
    with pytest.raises(ValueError, match="contact sheet"):
        contact_sheet([front], ["one", "two"])
    with pytest.raises(ValueError, match="contact sheet"):
        contact_sheet([], [])


def test_a_layout_without_elements_shows_the_character(rig, layout):
    image = picture.render(rig, replace(layout, elements=()), views=["front"], size=SMALL)
    assert image.size == SMALL


def marked(element, box, outlines=()):
    left, top, right, bottom = box
    track = np.array([[left, top, 0.0], [right, bottom, 0.0]])
    return element, overlay.Mark(
        (0, 0, 0), "slider", (track,), (np.array([True, True]),), track[0], True, (), tuple(outlines)
    )


@pytest.mark.parametrize("left", [True, False])
def test_leader_lines_cross_no_other_and_no_name(layout, left):
    """Handles in a crowd, in rows closer than those of their names, and names of every length."""
    random = np.random.default_rng(7)
    for count in (3, 12, 30):
        named = [
            replace(
                layout.elements[0],
                name=f"{i}",
                look=replace(layout.elements[0].look, label="n" * random.integers(1, 30)),
            )
            for i in range(count)
        ]
        at = random.uniform([250.0, 20.0], [550.0, 180.0], (count, 2))
        shown = [marked(each, (*place, *place)) for each, place in zip(named, at, strict=True)]
        names = lettering._column((800, 600), shown, left)
        lines = [each.line for each in names]
        assert not any(crossing(a, b) for i, a in enumerate(lines) for b in lines[:i])
        assert {tuple(line[-1]) for line in lines} == set(map(tuple, at))
        ends = [each.line[1, 0] for each in names]
        assert ends == [ends[0]] * count
        wide = [each.type_.getlength(each.text) for each in names]
        assert all((6.0 + w < ends[0]) if left else (794.0 - w > ends[0]) for w in wide)


def crossing(one, other):
    """Whether two lines (3, 2) cross."""

    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def apart(a, b, c, d):
        return turn(a, b, c) * turn(a, b, d) >= 0.0 or turn(c, d, a) * turn(c, d, b) >= 0.0

    return any(not apart(*one[i : i + 2], *other[j : j + 2]) for i in range(2) for j in range(2))


def test_headings_stand_clear_of_the_row_and_of_large_handles(layout):
    one = replace(layout.elements[0], placement=replace(layout.elements[0].placement, category="global"))
    large = np.array([[0.0, 60.0, 0.0], [20.0, 140.0, 0.0]])
    tops = []
    for outlines in ((), (large,)):
        shown = [marked(one, (10.0, 100.0, 50.0, 100.0), outlines)]
        boxes = np.array([lettering._box(drawn) for _, drawn in shown])
        rows = np.array([lettering._row(drawn) for _, drawn in shown])
        assert rows == pytest.approx([100.0])
        ((text, _, y),) = lettering._headings(shown, boxes, rows, 15.0)
        assert text == "whole character"
        tops.append(y)
    assert tops[0] <= 100.0 - 16.0
    assert tops[1] <= 60.0 - 16.0


def test_leader_lines_differ_from_any_ground():
    for grey in (90, 150, 240):
        ground = Image.new("RGB", (80, 30), (grey, grey, grey))
        drawn = np.asarray(overlay.leaders(ground, [np.array([[5.0, 15.0], [75.0, 15.0]])])).astype(int)
        across = drawn[:, 40, 0]
        assert np.ptp(across) > 80  # its own contrast carries it, whatever it crosses
        assert np.abs(across - grey).max() > 50


def test_axes_that_go_both_ways_are_joysticks_and_coarse_elements_have_a_ring(layout):
    one = layout.elements[0]
    patch = replace(one.manipulator, kind="patch", members=(one.manipulator.members[0],) * 3)
    joystick = replace(patch, opposed=((0, 1),))
    assert [overlay.form_of(each) for each in (patch, joystick)] == ["patch", "joystick"]
    coarse = replace(one, look=replace(one.look, inner=("finer",)))
    texts = [text for _, _, text, _ in picture._legend_entries([coarse])]
    assert texts[-1] == "coarse: opens into finer ones"
    assert not any(ringed for *_, ringed in picture._legend_entries([one]))
    aside = replace(one, look=replace(one.look, side="none"))
    on_board = replace(one, anchor=replace(one.anchor, on_board=True))
    for given, said in (([aside], "no side"), ([on_board], "board"), ([aside, on_board], "no side, board")):
        assert ("slider", VIOLET, said, False) in picture._legend_entries(given)
    plain, ringed = (np.asarray(overlay.knob("slider", (29, 98, 214), 8.0, given)) for given in (False, True))
    assert ringed.shape[0] > plain.shape[0]
    middle = ringed.shape[0] // 2
    beyond = ringed[middle, middle + round(1.75 * 8.0 * overlay._FINE)]
    assert beyond.tolist() == [29, 98, 214, 255]


def test_a_character_in_parts_has_a_close_up_of_each_part_and_of_each_hand():
    """Hands lie apart and are shown one by one, from their own side; every element is in one section."""
    rig = limbs.whole_body()
    layout = joined(chain.laid_parts(rig))
    found = sections(layout, evaluate(prepare(rig, layout)), rig.skel_root.up)
    assert [each.title for each in found] == ["face", "hands, character's left", "hands, character's right", "body"]
    shown = [element.name for each in found for element in each.layout.elements]
    assert sorted(shown) == sorted(element.name for element in layout.elements)
    side = np.cross(rig.skel_root.up, layout.frame.view)
    assert all(view @ side > -0.1 for view in found[1].views)
    assert all(view @ side < 0.1 for view in found[2].views)
    eyes = [next(element for element in each.layout.elements if element.look.side != "none") for each in found[1:3]]
    pair = replace(layout, elements=tuple(eyes))
    assert [each.title for each in sections(pair, evaluate(prepare(rig, pair)), rig.skel_root.up)][1] == "hands"
    boards = sum(any(element.anchor.on_board for element in each.layout.elements) for each in found)
    width, height = render(rig, layout, size=(320, 240)).size
    assert width == 320
    assert height - 4 * 240 >= boards * 34


def test_a_part_without_handles_on_the_character_is_shown_without_the_skin_that_hides_it():
    """The inside of a mouth: its controls are on the board, and its teeth alone are drawn."""
    rig = makers.face_with_teeth()
    whole = laid_out.layout_of(rig)
    (teeth,) = (each for each in whole.elements if each.manipulator.controls == {"teeth"})
    colours = complexion(rig, whole)
    board = replace(teeth, anchor=replace(teeth.anchor, on_board=True))
    hidden = cut_away(rig, replace(whole, elements=(board,)), colours).clear
    assert np.flatnonzero(~hidden).tolist() == [len(hidden) - 4 + i for i in range(4)]
    assert cut_away(rig, whole, colours) is colours
