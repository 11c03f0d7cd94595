"""The conformance suite of the contract: it is current, our readers and the example pass it, a broken one does not."""

import importlib
import json
import shutil
import sys
import zipfile

import pytest
import scripts
from commands import contents
from folders import ROOT

from usdrigui.cli import main
from usdrigui.clients import blender_extension
from usdrigui.clients.conforming import agrees, conform

SUITE, READERS = ROOT / "schemas" / "conformance", ROOT / "tests" / "readers"
LIBRARY = (sys.executable, str(SUITE / "readers.py"))
REPLAYING = """
import json, pathlib, sys
layer, asked = pathlib.Path(sys.argv[1]), json.load(sys.stdin)
case = layer.with_name("drags.json") if asked[0]["ask"] == "drag" else layer.with_suffix(".json")
questions = json.loads(case.read_text())["questions"]
answers = [each["answer"] for each in questions]
if case.stem == "drags":
    answers = [[to or each["default"] for to in each["answer"]] for each in questions]
print({answers})
"""


@pytest.fixture(scope="module")
def readers(tmp_path_factory):
    """By name, the command of each reader of ours, and how many of the questions it leaves out at most."""
    if shutil.which("node") is None:
        pytest.skip("Node.js is not installed")
    folder = tmp_path_factory.mktemp("extension")
    blender_extension.write_extension(folder / "one.zip")
    zipfile.ZipFile(folder / "one.zip").extractall(folder)
    page, blender = ((sys.executable, str(READERS / f"{name}.py")) for name in ("page", "blender"))
    example = (sys.executable, str(SUITE / "reader.py"))
    return {
        "library": (LIBRARY, 0),
        "page": (page, 1),
        "blender": ((*blender, str(folder)), 3),
        "example": (example, 11),
    }


@pytest.mark.slow
@pytest.mark.parametrize("name", ["blender", "example", "page", "library"])
def test_a_reader_of_ours_passes(readers, name):
    command, most = readers[name]
    found = [*conform(command)]
    assert len(found) > 20
    assert {each.case: each.wrong for each in found if each.wrong} == {}
    assert max(each.unanswered for each in found) == most


@pytest.mark.parametrize("case", sorted(path.stem for path in SUITE.glob("*.json")))
def test_the_library_answers_every_question(case):
    content = json.loads((SUITE / f"{case}.json").read_text("utf-8"))
    with scripts.loaded(SUITE / "readers.py") as reader:
        answers = reader.answers(SUITE / content["layer"], content["questions"])
    assert None not in answers
    assert [q for q, a in zip(content["questions"], answers, strict=True) if not agrees(q, a)] == []


@pytest.mark.parametrize(
    ("answers", "fails"),
    [
        ("json.dumps(answers)", False),
        ("json.dumps(answers[1:])", True),
        ("'no JSON'", True),
        ("json.dumps([None] * len(answers))", True),
        ("json.dumps(answers).replace('0.', '0.3')", True),
        ("json.dumps([{'refused': True}] * len(answers))", True),
        ("json.dumps([each if case.stem != 'drags' else [to[::-1] for to in each] for each in answers])", True),
        ("json.dumps([each if case.stem != 'shifted' or each != answers[-1] else [] for each in answers])", True),
    ],
)
def test_a_broken_reader_is_seen_to_fail(tmp_path, capsys, answers, fails):
    (tmp_path / "reader.py").write_text(REPLAYING.format(answers=answers))
    assert main(["conform", f"{sys.executable} {tmp_path / 'reader.py'}"]) == fails
    assert ("wrong: " in capsys.readouterr().out) == fails


def test_the_suite_is_current(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(SUITE))
    drags, layers = (importlib.import_module(name) for name in ("drags", "layers"))
    assert drags.written() == drags.FILE.read_text(encoding="utf-8")
    layers.make(tmp_path)
    made = contents(tmp_path)
    kept = {path.name: path.read_bytes() for path in SUITE.iterdir() if path.suffix in (".usda", ".json", ".toml")}
    assert made.keys() == kept.keys() - {"drags.json", "ruff.toml"}
    stale = {name for name, content in made.items() if content != kept[name]}
    assert stale == set(), "python schemas/conformance/layers.py"
