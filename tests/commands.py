"""A command run in this process, the JSON that it prints, and the layout that it wrote."""

import json

from usdrigui.cli import main
from usdrigui.layer.read_layout import read_layout


def run(capsys, *arguments, expected=0):
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == expected
    return json.loads(capsys.readouterr().out)


def elements(layer):
    """By name, of the one layout of a layer."""
    (layout,) = read_layout(layer)
    return {element.name: element for element in layout.elements}


def contents(folder):
    """The files of a folder, by name."""
    return {each.name: each.read_bytes() for each in folder.iterdir()}
