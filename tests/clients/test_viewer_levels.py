"""A layout of two levels in the viewer: coarse handles first, their members in their place on demand."""

from dataclasses import replace

import makers
import pytest
from viewer_layouts import MIRRORS, peak_layout

INNER = {"smile_L": ("sneer_L",), "smile_R": ("sneer_R",), "pucker": ("chin",)}


def characters():
    rig = makers.face()
    layout = peak_layout(rig, mirrors=MIRRORS)
    elements = tuple(replace(each, inner=INNER.get(each.name, ())) for each in layout.elements)
    return [(rig, replace(layout, elements=elements))]


def shown(viewer):
    viewer.settle()
    return {each["name"] for each in viewer.page.evaluate("usdrigui.elements()")}


def select(viewer, name):
    viewer.page.mouse.click(*viewer.on_page(viewer.element(name)["handle"]))
    viewer.settle()


def test_members_are_not_shown_at_first(viewer):
    assert not {"sneer_L", "sneer_R", "chin"} & shown(viewer)
    assert {"smile_L", "smile_R", "pucker", "brow_L"} <= shown(viewer)


def test_opening_shows_the_members_on_both_sides_and_closing_hides_them(viewer):
    first = shown(viewer)
    select(viewer, "smile_L")
    viewer.key("m")
    assert shown(viewer) == first - {"smile_L", "smile_R"} | {"sneer_L", "sneer_R"}
    select(viewer, "sneer_L")
    viewer.key("m")
    assert shown(viewer) == first


def test_the_inspector_opens_and_closes(viewer):
    select(viewer, "pucker")
    viewer.click("Open: 1 members")
    assert "chin" in shown(viewer)
    assert "pucker" not in shown(viewer)
    viewer.click("Close pucker")
    assert "pucker" in shown(viewer)


def test_a_member_works_like_any_handle(viewer):
    select(viewer, "pucker")
    viewer.key("m")
    viewer.settle()
    chin = viewer.element("chin")
    viewer.drag(chin["handle"], chin["tracks"][0][-1])
    assert viewer.moved() == pytest.approx({"chin": 1.0}, abs=1e-3)


def test_the_list_finds_a_member_and_tab_passes_by_what_is_not_shown(viewer):
    stops = ".stops [data-element=chin]"
    assert viewer.page.locator(stops).is_hidden()
    viewer.unfold()
    viewer.page.locator("[data-control=chin] .name").click()
    assert "chin" in shown(viewer)
    assert not viewer.page.locator(stops).evaluate("(node) => node.hidden")


def test_without_members_the_key_opens_nothing(viewer):
    first = shown(viewer)
    select(viewer, "brow_L")
    viewer.key("m")
    assert shown(viewer) == first
