"""`usdrigui batch`: many assets, isolated, resumable, accounted for."""

import json
import os
import threading
from dataclasses import replace
from pathlib import Path

import batch_assets
import commands
import minimal_assets
import pytest
from PIL import Image
from processes import gone, impostor, until
from pxr import Sdf

from usdrigui.cli import main
from usdrigui.clients.batch import jobs, places, run, state
from usdrigui.clients.batch.job import Job, Row


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Two sound assets and a broken one, laid out once."""
    path = tmp_path_factory.mktemp("batch")
    batch_assets.folder_of(path)
    return path


def batch(folder, capsys, *options, expected_exit=0, pattern="**/*.usda"):
    return commands.run(capsys, "batch", folder / pattern, "--jobs", "2", *options, expected=expected_exit)


def outcomes(document):
    return {Path(row["asset"]).relative_to(Path(row["asset"]).parents[1]).as_posix(): row for row in document["assets"]}


def test_one_bad_file_never_stops_the_rest_and_what_is_done_is_skipped(folder, tmp_path, capsys):
    first = batch(folder, capsys, "--sheet", str(tmp_path / "sheet.png"), expected_exit=1)
    assert first["counts"] == {"written": 2, "unchanged": 0, "skipped": 0, "refused": 1, "failed": 0, "part": 0}
    (refused,) = [row for row in first["assets"] if row["outcome"] == "refused"]
    assert (refused["code"], refused["exit"]) == ("FILE_NOT_USD", 1)
    assert refused["repair"]
    assert refused["picture"] == ""
    assert all(Path(row["picture"]).is_file() for row in first["assets"] if row["picture"])
    assert all(Path(row["output"]).is_file() for row in first["assets"] if row["exit"] == 0)
    assert Image.open(tmp_path / "sheet.png").width == 1800
    layers = {path: path.stat().st_mtime_ns for path in folder.rglob("*.rigui.usda")}

    second = batch(folder, capsys, "--sheet", str(tmp_path / "sheet.png"), expected_exit=1)
    assert second["counts"] == {"written": 0, "unchanged": 0, "skipped": 2, "refused": 1, "failed": 0, "part": 0}
    assert {path: path.stat().st_mtime_ns for path in layers} == layers
    before, after = ([(row["face"], row["board"], row["gap"]) for row in each["assets"]] for each in (first, second))
    assert before == after

    changed = folder / "a1" / "char.usda"
    changed.write_text(changed.read_text() + "\n# touched\n")
    third = outcomes(batch(folder, capsys, pattern="a*/*.usda"))
    assert (third["a0/char.usda"]["outcome"], third["a1/char.usda"]["outcome"]) == ("skipped", "unchanged")


def test_prints_a_table_and_a_closing_line(folder, capsys):
    assert main(["batch", str(folder / "a0" / "char.usda"), str(folder / "broken.usda"), "--jobs", "1"]) == 1
    printed = capsys.readouterr()
    assert "FILE_NOT_USD" in printed.out
    assert printed.out.splitlines()[-1].startswith("usdrigui: 1 of 2 assets have their layout")
    assert "[2/2]" in printed.err


def test_everything_that_the_result_depends_on_ends_the_skipping(folder, tmp_path):
    """Settings, a file below the asset, the layer and the picture; without running anything."""
    asset = batch_assets.split(folder)
    output, picture = tmp_path / "split.rigui.usda", tmp_path / "split.rigui.png"
    output.write_text("layer")
    picture.write_text("picture")
    job = Job(str(asset), str(output), str(picture), settings="settings")
    files = [Path("split.usda"), Path("a0/char.usda")]
    sources = [{"path": each.as_posix(), "sha256": state.hashed(folder / each).sha256} for each in files]
    paths = tuple(os.path.realpath(folder / each) for each in files)
    row = Row(job.asset, job.output, job.picture, "written", 0, face=7, gap=0.25, seconds=3.0)
    skipped = replace(row, outcome="skipped", seconds=0.0, sources=paths)

    def remembered():
        state.remember(job, sources, row)
        assert state.recall(job) == skipped

    remembered()
    for other in ({"settings": "others"}, {"asset": "another.usda"}, {"picture": str(tmp_path / "other.png")}):
        assert state.recall(replace(job, **other)) is None
    plain = replace(job, picture="")
    assert state.recall(plain) == replace(skipped, picture="")
    picture.write_text("another picture")
    assert state.recall(plain) == replace(skipped, picture="")
    assert state.recall(job) is None
    picture.write_text("picture")
    state.remember(plain, sources, row)
    assert state.recall(job) is None, "a picture that was not drawn then is asked for now"
    for path in (folder / "a0" / "char.usda", output, picture):
        remembered()
        before = path.read_bytes()
        path.write_bytes(before + b" ")
        assert state.recall(job) is None
        path.unlink()
        assert state.recall(job) is None
        path.write_bytes(before)
    state.state_path(job.output).write_text("{")
    assert state.recall(job) is None
    state.forget(job.output)
    stale = [{**each, "sha256": "0" * 64} for each in sources]
    state.remember(job, stale, row)
    assert not state.state_path(job.output).exists()
    asset.unlink()


@pytest.mark.skipif(os.name != "posix", reason="needs links and pipes")
def test_what_a_pattern_matches_and_is_no_file_has_a_row(tmp_path, capsys):
    (tmp_path / "gone.usda").symlink_to(tmp_path / "nowhere.usda")
    (tmp_path / "null.usda").symlink_to("/dev/null")
    os.mkfifo(tmp_path / "pipe.usda")
    (tmp_path / "folder.usda").mkdir()
    rows = batch(tmp_path, capsys, expected_exit=3)["assets"]
    codes = {Path(row["asset"]).stem: row["code"] for row in rows}
    assert codes == {"gone": "FILE_NOT_FOUND", "null": "SOURCE_NOT_A_FILE", "pipe": "SOURCE_NOT_A_FILE"}
    (refused,) = batch(tmp_path, capsys, expected_exit=2, pattern="folder.usda")["issues"]
    assert f"'{tmp_path / 'folder.usda' / '**' / '*.usd*'}'" in refused["message"]


def fake(monkeypatch, tmp_path, text):
    """Processes of the batch run a script instead of usdrigui."""
    impostor(tmp_path, monkeypatch, text)
    return Job(str(tmp_path / "char.usda"), str(tmp_path / "char.rigui.usda"), "")


END = """echo '{"what": "end", "code": 0, "out": "rubbish", "err": ""}'"""


@pytest.mark.skipif(os.name != "posix", reason="needs a shell")
def test_a_process_that_hangs_is_ended_with_its_children(monkeypatch, tmp_path):
    job = fake(monkeypatch, tmp_path, f"sleep 1000 & echo $! > {tmp_path}/pid; wait")
    row = jobs.run_job(Job(job.asset, job.output, "", timeout=1.0))
    assert (row.outcome, row.code, row.exit) == ("failed", "BATCH_TIME_LIMIT", 4)
    until(lambda: gone(int((tmp_path / "pid").read_text())))


@pytest.mark.skipif(os.name != "posix", reason="needs a shell")
def test_leaving_early_ends_what_still_runs(monkeypatch, tmp_path):
    fake(
        monkeypatch,
        tmp_path,
        f"read it; case $it in */0.usda*) exit 0;; esac; cd {tmp_path}; echo $$ > $$; mv $$ pid; exec sleep 1000",
    )
    many = [Job(str(tmp_path / f"{i}.usda"), str(tmp_path / f"{i}.rigui.usda"), "") for i in range(6)]
    rows = run.run_local(many, 2)
    assert next(rows).code == "WORKER_CRASHED"
    until((tmp_path / "pid").exists)
    closing = threading.Thread(target=rows.close)
    closing.start()
    closing.join(30)
    assert not closing.is_alive()
    until(lambda: gone(int((tmp_path / "pid").read_text())))


STATES = {
    "deep": "[" * 100_000,
    "no table": "[]",
    "a pipe": None,
    "a device": '{"sources": ["/dev/zero"]}',
    "an exit code": {"exit": 99},
    "no sources": {"sources": []},
    "sources without the asset": {"sources": ["other.usda"]},
    "a count that is none": {"counts": {"face": "many"}},
}


@pytest.mark.skipif(os.name != "posix", reason="needs a pipe and /dev/zero")
@pytest.mark.parametrize("what", STATES)
def test_a_file_that_does_not_hold_is_none(monkeypatch, tmp_path, what):
    """Neither does it end the batch, nor is an asset skipped for it, even with a digest that fits."""
    job = fake(monkeypatch, tmp_path, END)
    for name in ("char.usda", "char.rigui.usda", "other.usda"):
        (tmp_path / name).touch()
    empty = {name: 0.0 if name == "gap" else 0 for name in state._COUNTS}
    path, content = state.state_path(job.output), STATES[what]
    if content is None:
        os.mkfifo(path)
    elif isinstance(content, str):
        path.write_text(content)
    else:
        counts = empty | content.get("counts", {})
        record = state._record(job, content.get("sources", ["char.usda"]), counts)
        path.write_text(json.dumps(record | {"exit": 99} if "exit" in content else record))
    assert jobs.run_job(job).code == "BUG"


def test_a_broken_configuration_and_a_part_cost_no_other_asset(monkeypatch, tmp_path, capsys):
    """The part is no character by itself; the pattern, however it is spelt, finds what was done before."""
    minimal_assets.character(tmp_path)
    (tmp_path / "typo.usda").write_bytes((tmp_path / "char.usda").read_bytes())
    (tmp_path / "typo.rigui.toml").write_text("typo = 1\n[candidates]\nview = 1")
    (tmp_path / "geo.usda").write_text('#usda 1.0\n(\n    defaultPrim = "Hair"\n)\ndef Xform "Hair"\n{\n}\n')
    whole = Sdf.Layer.FindOrOpen(str(tmp_path / "char.usda"))
    whole.subLayerPaths.append("./geo.usda")
    whole.Save()
    monkeypatch.chdir(tmp_path)
    outcomes = []
    for pattern in ("./*.usda", str(tmp_path / "*.usda")):
        rows = commands.run(capsys, "batch", pattern, "--jobs", "2", expected=2)["assets"]
        outcomes.append({Path(row["asset"]).stem: (row["outcome"], row["code"]) for row in rows})
    rest = {"geo": ("part", ""), "typo": ("refused", "CONFIG_UNKNOWN_KEY")}
    assert outcomes == [{"char": ("written", "")} | rest, {"char": ("skipped", "")} | rest]


def test_patterns(tmp_path):
    for name in ("b/x.usd", "b/x.rigui.usda", "a/x.usda", "a/x.usdc", "a/notes.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    found = places.find_assets([str(tmp_path / "b" / "x.usd"), str(tmp_path / "**" / "*")])
    assert [each.relative_to(tmp_path).as_posix() for each in found] == ["b/x.usd", "a/x.usda", "a/x.usdc"]
    layers = [each.relative_to(tmp_path).as_posix() for each in places.outputs_of(found, tmp_path / "out")]
    assert layers == ["out/b/x.rigui.usda", "out/a/x_usda.rigui.usda", "out/a/x_usdc.rigui.usda"]
    assert places.outputs_of(found, None)[0] == tmp_path / "b" / "x.rigui.usda"
