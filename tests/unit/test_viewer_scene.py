"""The packed scene and the page around it."""

import base64
import hashlib
import html
import json
import re
import zlib
from dataclasses import replace

import makers
import numpy as np
import pytest
from viewer_layouts import peak_layout

from usdrigui.layout.board.board import CATEGORIES
from usdrigui.view.body.complexion import complexion
from usdrigui.view.flat.columns import heading
from usdrigui.view.web import packing
from usdrigui.view.web.packing import pack
from usdrigui.view.web.page import page_html

KINDS = {"u1": "<u1", "u2": "<u2", "i2": "<i2", "u4": "<u4", "i4": "<i4", "f4": "<f4", "f8": "<f8"}


@pytest.fixture(scope="module")
def face():
    rig = makers.face()
    return rig, peak_layout(rig)


def unpacked(packed):
    """Header and a reader of its array entries, written anew from the format's description."""
    content = zlib.decompress(packed)
    length = int.from_bytes(content[:4], "little")
    body = content[4 + length :]

    def array(entry):
        kind = np.dtype(KINDS[entry["kind"]])
        count = int(np.prod(entry["shape"], dtype=np.int64))
        planes = np.frombuffer(body, np.uint8, count * kind.itemsize, entry["at"]).reshape(kind.itemsize, count)
        values = np.ascontiguousarray(planes.T).view(kind).reshape(entry["shape"])
        return np.cumsum(values.ravel(), dtype=np.int64).reshape(entry["shape"]) if entry.get("sum") else values

    return json.loads(content[4 : 4 + length]), array


def test_positions_and_offsets_survive_to_half_a_step(face):
    rig, layout = face
    header, array = unpacked(pack([(rig, layout)], "face"))
    packed, mesh = header["characters"][0]["meshes"][0], rig.body.meshes[0]
    low, step = np.array(packed["low"]), np.array(packed["step"])
    points = low + array(packed["points"]) * step
    assert np.abs(points - mesh.points).max() <= 0.51 * np.ptp(mesh.points, axis=0).max() / 65535
    for stored, shape in zip(packed["shapes"], mesh.shapes, strict=True):
        dense = np.zeros((1, len(mesh.points), 3))
        dense[:, array(stored["points"])] = array(stored["offsets"]) * stored["step"]
        true = np.zeros_like(dense)
        true[:, shape.points] = shape.offsets
        assert np.abs(dense - true).max() <= 0.51 * np.abs(true).max() / 32767


def test_gazes_survive(face, monkeypatch):
    gaze = np.linspace([-2.0, 0.0], [0.3, 2.9], len(face[0].body.meshes[0].points))
    monkeypatch.setattr(packing, "complexion", lambda *given: replace(complexion(*given), gaze=gaze))
    header, array = unpacked(packing.pack([face], "face"))
    assert np.allclose(array(header["characters"][0]["meshes"][0]["gaze"]) * 3 / 8192, gaze, atol=2e-4)


def test_triangles_survive(face):
    rig, layout = face
    header, array = unpacked(pack([(rig, layout)], "face"))
    corners = array(header["characters"][0]["meshes"][0]["triangles"])
    quads = rig.body.meshes[0].topology.face_indices.reshape(-1, 4)
    expected = np.stack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]], axis=1).reshape(-1, 3)
    assert np.array_equal(corners, expected)


def test_same_records_same_page(face):
    assert page_html([face], "face") == page_html([face], "face")


def test_work_belongs_to_a_character_not_to_its_layout(face):
    rig, layout = face
    meshes = (replace(rig.body.meshes[0], points=1.01 * rig.body.meshes[0].points), *rig.body.meshes[1:])

    def identity(rig, layout):
        return unpacked(pack([(rig, layout)], "face"))[0]["characters"][0]["identity"]

    assert identity(rig, replace(layout, elements=layout.elements[1:])) == identity(rig, layout)
    assert identity(makers.changed(rig, meshes=meshes), layout) != identity(rig, layout)
    assert identity(replace(rig, controls=rig.controls[::-1]), layout) != identity(rig, layout)


def test_title_is_escaped(face):
    title = "</title><script>alert('x')</script> & \"co\""
    page = page_html([face], title)
    assert title not in page
    assert html.escape(title) in page


def test_names_cannot_end_the_script(face):
    rig, layout = face
    element = replace(layout.elements[0], label="</script><script>alert(1)</script>")
    page = page_html([(rig, replace(layout, elements=(element, *layout.elements[1:])))], "face")
    assert "alert(1)" not in page
    assert page.count("</script>") == 2


def test_policy_allows_this_script_and_style_only(face):
    page = page_html([face], "face")
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page).group(1)
    for kind in ("script", "style"):
        text = re.findall(rf"<{kind}>(.*?)</{kind}>", page, re.DOTALL)[-1]
        digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
        assert f"{kind}-src 'sha256-{digest}'" in policy
    assert policy.startswith("default-src 'none'")
    assert "http" not in policy


def test_page_asks_for_nothing_from_the_network(face):
    assert not re.findall(r'(?:src|href)="(?!data:)[^"]*"', page_html([face], "face"))


def test_headings_of_the_board_come_in_the_order_of_the_layout(face):
    rig, layout = face
    words = ("theirs", *reversed(CATEGORIES))
    elements = [replace(layout.elements[0], name=word, category=word) for word in words]
    header, _ = unpacked(pack([(rig, replace(layout, elements=tuple(elements)))], "face"))
    packed = sorted(header["characters"][0]["layout"]["elements"], key=lambda each: each["rank"])
    assert [each["category"] for each in packed] == [*CATEGORIES, "theirs"]
    assert len({heading(word, "") for word in words}) == len(words)
