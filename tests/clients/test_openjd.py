"""`usdrigui openjd`: a job that Open Job Description's own command checks and runs."""

import json
import subprocess
import sys
from pathlib import Path

import batch_assets
import pytest

from usdrigui.cli import main
from usdrigui.clients import openjd
from usdrigui.errors import RigUIError, issue
from usdrigui.pipeline import Event

needs_openjd = pytest.mark.skipif(
    not Path(sys.executable).with_name("openjd").exists(), reason="openjd-cli is not installed"
)


def openjd_command(*arguments):
    command = [str(Path(sys.executable).with_name("openjd")), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)


@pytest.mark.slow
@needs_openjd
def test_a_job_is_checked_and_run(tmp_path, capsys):
    batch_assets.folder_of(tmp_path / "assets")
    job = tmp_path / "job.json"
    pattern = str(tmp_path / "assets" / "a*" / "*.usda")
    options = ["--output-dir", str(tmp_path / "out"), "--set", "solve.gap=0.01", "-o", str(job)]
    assert main(["openjd", pattern, *options]) == 0
    assert "2 tasks" in capsys.readouterr().out
    checked = openjd_command("check", str(job))
    assert checked.returncode == 0, checked.stdout + checked.stderr
    ran = laid_out_by(job)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert "openjd_progress: 99" in ran.stdout
    layers = sorted((tmp_path / "out").rglob("*.rigui.usda"))
    assert [each.parent.name for each in layers] == ["a0", "a1"]


def laid_out_by(job):
    usdrigui = Path(sys.executable).with_name("usdrigui")
    return openjd_command("run", str(job), "--step", "Layout", "-p", f"Command={usdrigui}")


@needs_openjd
def test_a_refused_asset_fails_its_task_and_says_why(tmp_path):
    (tmp_path / "broken.usda").write_text("#usda 1.0\n(\n")
    job = tmp_path / "job.json"
    assert main(["openjd", str(tmp_path / "broken.usda"), "-o", str(job)]) == 0
    ran = laid_out_by(job)
    assert ran.returncode != 0
    assert "openjd_fail: FILE_NOT_USD" in ran.stdout


def test_many_assets_make_several_steps():
    places = [(Path(f"/a/{i}.usda"), Path(f"/a/{i}.rigui.usda")) for i in range(1025)]
    job = json.loads(openjd.template(places, ["--gap=0.1"]))
    assert [step["name"] for step in job["steps"]] == ["Layout1", "Layout2"]
    tasks = [step["parameterSpace"]["taskParameterDefinitions"][0]["range"] for step in job["steps"]]
    assert [len(each) for each in tasks] == [1024, 1]
    assert all(step["script"]["actions"]["onRun"]["args"][-1] == "--gap=0.1" for step in job["steps"])


def test_names_that_the_template_language_would_read_are_refused():
    with pytest.raises(RigUIError, match="FILE_NAME"):
        openjd.template([(Path("/a/{{Param.X}}.usda"), Path("/a/x.usda"))], [])
    with pytest.raises(RigUIError, match="BATCH_TOO_MANY"):
        openjd.template([(Path("/a"), Path("/b"))] * (1024 * 100 + 1), [])


def test_progress_never_goes_back():
    lines = []
    watch = openjd.progress_lines(lines.append)
    for stage in ("read", "trajectories", "symmetry", "candidates", "problem", "solve", "layout", "write"):
        watch(Event(stage))
        watch(Event(stage, seconds=0.1))
    shares = [int(line.split()[1]) for line in lines if line.startswith("openjd_progress:")]
    assert shares == [15, 25, 30, 45, 50, 90, 95, 99]


def test_a_refusal_is_one_line_of_two_sentences():
    (line,) = openjd.failure_lines(issue("LAYOUT_MISSING", "char.usda", "no prim has a\nlayout."))
    assert line.startswith(
        "openjd_fail: LAYOUT_MISSING char.usda: no prim has a layout. Make one with `usdrigui process`"
    )
