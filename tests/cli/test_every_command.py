"""Laws of every command: its one closing line, its one document, and the page that tells of it."""

import json

import figures
import pytest
from folders import ROOT

from usdrigui.cli import main
from usdrigui.cli.parser import parser

DOCS = ROOT / "docs"
OTHERWISE = (
    "--set controls.chin.place='board' --set controls.pucker.exclude=true --set controls.brow_R.maximum=0.5"
    " --set groups.groups.far=['smile_L','brow_L'] --set objective.handle_size=0.05"
)
LINES = {
    "process": "char.usda",
    "inspect": "char.usda",
    "check": "char.rigui.usda",
    "pin": "char.rigui.usda jawLeft=board -o said.usda",
    "unpin": "char.rigui.usda jawLeft -o said.usda",
    "pins": "char.rigui.usda",
    "diff": "char.rigui.usda other.rigui.usda",
    "view": "char.rigui.usda --html page.html",
    "bake": "char.rigui.usda",
    "picture": "char.rigui.usda -o char.png",
    "picker": "char.rigui.usda --svg picker.svg --dwpicker picker.json",
    "study": "char.usda",
    "batch": f"char.usda --jobs 1 --again {OTHERWISE}",
    "openjd": "char.usda -o job.json",
    "attach": "char.usda char.rigui.usda",
    "detach": "char.usda char.rigui.usda",
    "conform": "cat",
}
"""One of each; those that are refused say so in a document too."""


def test_each_command_is_among_them_and_in_the_documents():
    commands = parser().commands
    told = "".join(page.read_text() for page in DOCS.rglob("*.md"))
    assert [each for each in commands if f"usdrigui {each}" not in told] == []
    printing = {name for name, command in commands.items() if "--json" in command.format_help()}
    assert printing == {*LINES}


@pytest.mark.parametrize("command", LINES)
def test_it_prints_its_closing_line_alone_or_one_document(command, folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    if command == "diff":
        main(["process", "char.usda", "-o", "other.rigui.usda", *OTHERWISE.split()])
        capsys.readouterr()
    line = [command, *LINES[command].split()]
    main([*line, "--quiet"])
    told = capsys.readouterr()
    (closing,) = told.out.splitlines() or told.err.splitlines()[-1:]
    assert closing.startswith("usdrigui: ")
    main([*line, "--json"])
    document = json.loads(capsys.readouterr().out)
    assert (document["format"][:9], document["version"]) == ("usdrigui.", 1)
    assert figures.other_than_kept(f"{command}_document", document) == {}
