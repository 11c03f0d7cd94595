"""Side by colour: apart from skin and from each other for every kind of colour vision, by measure."""

import re
from itertools import combinations

import numpy as np
import pytest
from folders import ROOT

from usdrigui.character import palette
from usdrigui.view.body import shading

LEAST = 25.0
"""CIE 1976 colour difference."""
SIDES = {side: np.array(colour) / 255.0 for side, colour in palette.SIDES.items()}
SKINS = [
    shading.encoded(np.array(albedo)) * light
    for albedo, lights in ((shading.SKIN, (1.0, 0.85, 0.7, 0.55)), ((0.87, 0.66, 0.55), (1.0, 0.8, 0.6)))
    for light in lights
]
"""Skin without colours of its own and the sample's, from light to shade."""
VISION = {
    "normal": np.eye(3),
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
}
"""Linear RGB as it is seen, after Machado, Oliveira and Fernandes 2009, severity 1."""


def lab(encoded, vision):
    """CIE L*a*b* (D65) of an sRGB colour as it is seen."""
    linear = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    rgb_to_xyz = [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.072175], [0.0193339, 0.119192, 0.9503041]]
    x, y, z = np.array(rgb_to_xyz) @ np.clip(vision @ linear, 0.0, 1.0) / [0.95047, 1.0, 1.08883]
    f, g, h = (np.cbrt(t) if t > 216 / 24389 else (24389 / 27 * t + 16) / 116 for t in (x, y, z))
    return np.array([116 * g - 16, 500 * (f - g), 200 * (g - h)])


@pytest.mark.parametrize("vision", VISION)
def test_sides_are_told_from_skin_and_from_each_other(vision):
    seen = {side: lab(colour, np.array(VISION[vision])) for side, colour in SIDES.items()}
    skins = [lab(skin, np.array(VISION[vision])) for skin in SKINS]
    apart = {side: min(np.linalg.norm(at - skin) for skin in skins) for side, at in seen.items()}
    apart |= {pair: np.linalg.norm(seen[pair[0]] - seen[pair[1]]) for pair in combinations(seen, 2)}
    assert min(apart.values()) >= LEAST, apart


def test_no_client_says_the_colours_again():
    sources = [*(ROOT / "viewer" / "src").iterdir(), *(ROOT / "blender").rglob("*.py")]
    again = [rf"#{bytes(colour).hex()}|{r', *'.join(map(str, colour))}" for colour in palette.SIDES.values()]
    said = re.compile("|".join(again), re.IGNORECASE)
    assert len(sources) > 50
    assert [path.name for path in sources if said.search(path.read_text(encoding="utf-8"))] == []


@pytest.mark.parametrize("side", palette.SIDES)
def test_layers_hold_the_colours_in_linear_light(side):
    assert np.abs(shading.encoded(np.array(palette.linear(side))) - SIDES[side]).max() < 0.002
