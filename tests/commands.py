"""A command run in this process, and the JSON that it prints."""

import json

from usdrigui.cli import main


def run(capsys, *arguments, expected=0):
    capsys.readouterr()
    assert main([*map(str, arguments), "--json"]) == expected
    return json.loads(capsys.readouterr().out)
