"""Whatever becomes of the process that reads an asset, the one that asked gets a record or a code."""

import ast
import contextlib
import errno
import os
import signal
import subprocess
import sys
import threading
import time
import zlib
from pathlib import Path

import numpy as np
import pytest
from mutations import package
from processes import children_of, gone, impostor, until
from programs import ran
from pxr import Sdf
from skel_stages import character, head

from usdrigui.errors import Exit, RigUIError
from usdrigui.isolation import record_stream
from usdrigui.isolation.foreign_file import check_unchanged
from usdrigui.reader import reader_main
from usdrigui.reader.reader_process import read_rigs_isolated
from usdrigui.reader.reader_records import Request
from usdrigui.reading.character import read_characters, read_rigs
from usdrigui.settings import ReadSettings, Settings, load

HANG = '#usda 1.0\n(\n    subLayers = [@./pipe.usda@]\n)\ndef SkelRoot "A" {}\n'
"""Over a pipe that nobody writes to, this keeps USD waiting for ever."""


def refused(path, read=None):
    with pytest.raises(RigUIError) as caught:
        read_rigs_isolated(path, load({"read": read or {}}))
    return caught.value


def hanging(folder):
    os.mkfifo(folder / "pipe.usda")
    path = folder / "char.usda"
    path.write_text(HANG)
    return path


# --- the same as without -----------------------------------------------------------------------------


def test_a_rig_is_the_same_to_the_bit(tmp_path):
    path = character(tmp_path / "char.usda")
    here, there = read_rigs(path, Settings()), read_rigs_isolated(path, Settings()).rigs
    assert [b"".join(record_stream.encode(rig)) for rig in here] == [
        b"".join(record_stream.encode(rig)) for rig in there
    ]


def test_metadata_is_that_of_the_root_layer(tmp_path):
    path = tmp_path / "char.usda"
    head(tmp_path / "geo.usda")
    path.write_text(
        '#usda 1.0\n(\n    defaultPrim = "Ä"\n    metersPerUnit = 0.01\n    upAxis = "Z"\n    startTimeCode = 1\n'
        '    expressionVariables = { string SHOW = "x"\n bool ON = true\n int[] N = [1, 2] }\n'
        "    subLayers = [@./geo.usda@]\n)\n"
    )
    found = read_rigs_isolated(path, Settings()).metadata
    assert found == {
        "defaultPrim": "Ä",
        "metersPerUnit": 0.01,
        "upAxis": "Z",
        "startTimeCode": 1.0,
        "expressionVariables": {"SHOW": "x", "ON": True, "N": [1, 2]},
    }


def test_a_camera_is_a_direction_in_the_space_of_the_root_and_that_of_the_shot_is_told_frame_by_frame(tmp_path):
    """Also where the character goes its way; of two cameras it is the one that render settings name."""
    from pxr import Gf, Usd, UsdGeom, UsdRender

    path = head(tmp_path / "char.usda")
    stage = Usd.Stage.Open(str(path))
    camera = UsdGeom.Camera.Define(stage, "/cam")
    camera.AddTransformOp().Set(Gf.Matrix4d().SetRotate(Gf.Rotation((0, 1, 0), 90)))
    walk = UsdGeom.Xformable(stage.GetPrimAtPath("/Char")).AddTranslateOp()
    codes = [101, 102]
    for code in codes:
        walk.Set((code, 0, 2), code)
    stage.SetStartTimeCode(101)
    stage.SetEndTimeCode(102)
    stage.Save()
    (found,) = read_rigs_isolated(path, load({"candidates": {"view": "/cam"}})).rigs
    np.testing.assert_allclose(found.camera, [1, 0, 0], atol=1e-12)
    axes, halves = (0, 0, -1, 0, 1, 0, 1, 0, 0), (20.955 / 100, 15.2908 / 100)  # of USD's own aperture and focal length
    rows = [(*axes, -code, 0, -2, *halves) for code in codes]
    np.testing.assert_allclose(found.shot_camera, rows, atol=1e-6)
    assert found.to_world[:, 3, 0].tolist() == codes
    UsdGeom.Camera.Define(stage, "/other")
    settings = UsdRender.Settings.Define(stage, "/render")
    for named, seen in ((), False), (("/gone",), False), (("/cam",), True):
        settings.CreateCameraRel().SetTargets(named)
        stage.SetMetadata("renderSettingsPrimPath", "/render")
        stage.Save()
        (found,) = read_rigs_isolated(path, load({"candidates": {"view": "/none"}})).rigs
        assert (found.camera, found.shot_camera is not None) == (None, seen)


# --- what may become of the reader -------------------------------------------------------------------

DEATHS = {
    "segfault": ("kill -SEGV $$", "SOURCE_CRASHES_USD", Exit.REFUSED),
    "abort": ("kill -ABRT $$", "SOURCE_CRASHES_USD", Exit.REFUSED),
    "bus error": ("kill -BUS $$", "SOURCE_CRASHES_USD", Exit.REFUSED),
    "out of memory": (
        "echo \"terminate called after throwing an instance of 'std::bad_alloc'\" >&2; kill -ABRT $$",
        "SOURCE_MEMORY_LIMIT",
        Exit.LIMIT,
    ),
    "killed": ("kill -KILL $$", "SOURCE_READER_LOST", Exit.LIMIT),
    "alarm": ("kill -ALRM $$", "SOURCE_TIME_LIMIT", Exit.LIMIT),
    "no module": ("echo 'No module named pxr' >&2; exit 1", "SOURCE_READER_LOST", Exit.LIMIT),
    "silence": ("exit 0", "BUG", Exit.BUG),
    "garbage": ("head -c 5000 /dev/urandom", "BUG", Exit.BUG),
    "a preamble and no more": ("printf RIGUIREC", "BUG", Exit.BUG),
    "sleep": ("sleep 60", "SOURCE_TIME_LIMIT", Exit.LIMIT),
    "endless complaint": ("exec yes complaint >&2", "SOURCE_TIME_LIMIT", Exit.LIMIT),
    "deaf to polite signals": ("trap '' TERM INT HUP; sleep 60; sleep 60", "SOURCE_TIME_LIMIT", Exit.LIMIT),
}


@pytest.mark.parametrize("how", DEATHS)
def test_every_death_has_its_code(how, tmp_path, monkeypatch, capfd):
    script, code, leaves = DEATHS[how]
    impostor(tmp_path, monkeypatch, script)
    error = refused(head(tmp_path / "char.usda"), {"time_limit": 0.5})
    assert (error.issue.code, error.exit_code) == (code, leaves)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("executable", "code"),
    [("/no/such/python", "SOURCE_READER_LOST"), ("/", "PYTHON_PERMISSION"), (None, "SOURCE_READER_LOST")],
)
def test_a_reader_that_cannot_be_started(executable, code, tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "executable", executable)
    assert refused(head(tmp_path / "char.usda")).issue.code == code


def test_an_answer_that_the_system_does_not_hand_over(tmp_path, monkeypatch):
    def failing(*_):
        raise OSError(errno.EIO, os.strerror(errno.EIO))

    path = head(tmp_path / "char.usda")
    assert read_rigs_isolated(path, Settings()).rigs
    monkeypatch.setattr(os, "read", failing)
    error = refused(path)
    assert (error.issue.code, error.exit_code) == ("SOURCE_READER_LOST", Exit.LIMIT)


def test_grandchildren_die_with_the_reader(tmp_path, monkeypatch):
    impostor(tmp_path, monkeypatch, f"sleep 60 &\necho $! > {tmp_path}/grandchild\nwait")
    assert refused(head(tmp_path / "char.usda"), {"time_limit": 0.5}).issue.code == "SOURCE_TIME_LIMIT"
    until(lambda: gone(int((tmp_path / "grandchild").read_text())))


# --- USD itself --------------------------------------------------------------------------------------


def test_usd_never_returns(tmp_path):
    before = time.monotonic()
    assert refused(hanging(tmp_path), {"time_limit": 1.5}).issue.code == "SOURCE_TIME_LIMIT"
    assert time.monotonic() - before < 3.5
    assert not any(map(children_of, children_of(os.getpid())))


def test_the_reader_ends_with_a_host_that_was_killed(tmp_path):
    path = hanging(tmp_path)
    host = f"import pathlib, usdrigui; usdrigui.inspect(pathlib.Path({str(path)!r}), usdrigui.Settings())"
    parent = subprocess.Popen([sys.executable, "-c", host], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        (warm,) = until(lambda: children_of(parent.pid))
        (reader,) = until(lambda: children_of(warm))
        for process in (warm, reader):
            assert b"_usd" in Path(f"/proc/{process}/maps").read_bytes()
    finally:
        parent.kill()
        parent.wait()
    until(lambda: gone(warm, reader))


def test_the_reader_has_an_alarm_of_its_own(tmp_path):
    """Even where nothing watches it any more."""
    request = Request("rigs", str(hanging(tmp_path)), Settings(read=ReadSettings(time_limit=0.2)))
    done = subprocess.run(
        [sys.executable, "-m", "usdrigui.isolation.reader", "usdrigui.reader.reader_main"],
        input=b"".join(record_stream.encode(request)),
        stdout=subprocess.DEVNULL,
        timeout=30,
        check=False,
    )
    assert done.returncode == -signal.SIGALRM


# --- what the reader may do --------------------------------------------------------------------------


def in_bounds(code, tmp_path):
    """Run code in a process that is bound as the reader is; what it prints."""
    program = f"from usdrigui.isolation.confinement import confine\nconfine(20.0, 1000)\n{code}"
    done = ran("-c", program, cwd=tmp_path)
    return done.stdout + done.stderr


@pytest.mark.parametrize(
    "code",
    [
        "import socket; socket.create_connection(('127.0.0.1', 9))",
        "import socket; socket.getaddrinfo('localhost', 9)",
        "import subprocess; subprocess.run(['true'])",
        "import os; os.system('true')",
        "import os; os.fork()",
    ],
)
def test_python_opens_no_connection_and_starts_no_program(code, tmp_path):
    assert "is not allowed while an asset is read" in in_bounds(code, tmp_path)


FORBIDDEN = {
    "write": "open('new', 'w')",
    "write to a file that is there": "open('old', 'r+')",
    "empty": "os.open('old', os.O_RDONLY | os.O_TRUNC)",
    "shorten": "os.truncate('old', 1)",
    "remove": "os.unlink('old')",
    "rename": "os.rename('old', 'new')",
    "replace": "os.replace('other', 'old')",
    "link": "os.link('old', 'new')",
    "a symbolic link": "os.symlink('old', 'new')",
    "a folder": "os.mkdir('new')",
    "a pipe": "os.mkfifo('new')",
    "permission": "os.chmod('old', 0)",
    "a time": "os.utime('old', (0, 0))",
    "connect": "__import__('socket').socket()",
    "run": "os.execv('/bin/true', ['true'])",
    "start": "os.posix_spawn('/bin/true', ['true'], {})",
    "fork": "os.fork()",
    "signal": "os.kill(os.getppid(), 0)",
}
"""What a reader has no business with."""
ALLOWED = {
    "read": "open('old').read()",
    "list": "os.listdir('.')",
    "thread": "threading.Thread(target=len, args=('',)).start()",
    "signal itself": "signal.raise_signal(signal.SIGURG)",
}


@pytest.mark.skipif(sys.platform != "linux", reason="other kernels are not asked")
@pytest.mark.parametrize("without", ["nothing", "Landlock"])
def test_the_kernel_lets_it_read_and_no_more(without, tmp_path):
    """Whatever code runs there: Python's own audit is left out.  An older kernel has no Landlock."""
    for name in ("old", "other"):
        (tmp_path / name).write_text("as before")
    code = f"""
import os, signal, sys, threading
from usdrigui.isolation import confinement
sys.addaudithook = lambda _: None
if {without == "Landlock"}:
    confinement._forbid_files = lambda: None
confinement.confine(20.0, 1000)
for kinds in ({FORBIDDEN!r}, {ALLOWED!r}):
    for what, attempt in kinds.items():
        try:
            eval(attempt)
            print(what, "done")
        except OSError as error:
            print(what, error.errno)
print([line.split()[1] for line in open("/proc/self/status") if line.startswith(("NoNewPrivs", "Seccomp:"))])
"""
    done = ran("-c", code, cwd=tmp_path)
    said = done.stdout.split("\n")
    assert [line.rpartition(" ")[0] for line in said if line.endswith((" 1", " 13"))] == list(FORBIDDEN), done
    assert [line.rpartition(" ")[0] for line in said if line.endswith("done")] == list(ALLOWED), done.stderr[-600:]
    assert said[-2] == "['1', '2']"
    assert {each.name: each.read_text() for each in tmp_path.iterdir()} == {"old": "as before", "other": "as before"}


def test_its_limits_are_hard(tmp_path):
    names = ("CORE", "FSIZE", "DATA", "AS")
    code = f"import resource; print([resource.getrlimit(getattr(resource, 'RLIMIT_' + name)) for name in {names}])"
    core, files, data, addresses = ast.literal_eval(in_bounds(code, tmp_path))
    assert (core, files) == ((0, 0), (0, 0))
    assert data[0] == data[1] > 1000 << 20
    assert addresses[0] == addresses[1] == data[0] + (4 << 30)


def test_it_imports_nothing_from_the_working_directory(tmp_path, monkeypatch):
    path = head(tmp_path / "char.usda")
    for name in ("numpy", "pxr", "json", "usdrigui"):
        (tmp_path / f"{name}.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w')\n")
    monkeypatch.chdir(tmp_path)
    assert read_rigs_isolated(Path("char.usda"), Settings()).rigs
    assert path.exists()
    assert not (tmp_path / "ran").exists()


def test_a_mistake_of_ours_is_called_one(tmp_path, monkeypatch):
    def broken(*_):
        raise IndexError("of ours")

    monkeypatch.setattr("usdrigui.reader.reader_main.read_characters", broken)
    request = Request("rigs", str(head(tmp_path / "char.usda")), Settings())
    found = reader_main.answer(request)
    assert found.refusal is not None
    assert (found.refusal.code, found.exit_code) == ("BUG", Exit.BUG)
    assert "IndexError: of ours" in found.refusal.message


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (MemoryError(), "SOURCE_MEMORY_LIMIT"),
        (UnicodeDecodeError("utf-8", b"\xff", 0, 1, "no"), "USD_ERROR"),
    ],
)
def test_what_usd_raises_blames_the_asset(error, code, tmp_path, monkeypatch):
    def broken(*_):
        raise error

    monkeypatch.setattr("usdrigui.reader.reader_main.read_characters", broken)
    request = Request("rigs", str(head(tmp_path / "char.usda")), Settings())
    assert reader_main.answer(request).refusal.code == code


# --- what is let in ----------------------------------------------------------------------------------


# --- sources -----------------------------------------------------------------------------------------


@pytest.fixture
def layered(tmp_path):
    head(tmp_path / "geo.usda")
    path = tmp_path / "char.usda"
    path.write_text("#usda 1.0\n(\n    subLayers = [@./geo.usda@]\n)\n")
    return path


def test_every_file_is_remembered(layered, tmp_path):
    sources = read_rigs_isolated(layered, Settings()).sources
    assert [Path(each.path).name for each in sources] == ["char.usda", "geo.usda"]
    check_unchanged(sources)
    assert [each.size for each in sources] == [(tmp_path / name).stat().st_size for name in ("char.usda", "geo.usda")]


@pytest.mark.parametrize("name", ["char.usda", "geo.usda"])
@pytest.mark.parametrize("how", ["append", "same length", "remove"])
def test_a_change_is_noticed(layered, name, how):
    sources = read_rigs_isolated(layered, Settings()).sources
    path = layered.with_name(name)
    content = path.read_bytes()
    if how == "remove":
        path.unlink()
    else:
        path.write_bytes(content + b"\n" if how == "append" else content[:-1] + b" ")
    with pytest.raises(RigUIError, match="SOURCE_CHANGED"):
        check_unchanged(sources)


def test_a_change_while_usd_reads_is_noticed(tmp_path):
    path = tmp_path / "char.usda"
    head(tmp_path / "geo.usda")
    os.mkfifo(tmp_path / "pipe.usda")
    path.write_text("#usda 1.0\n(\n    subLayers = [@./pipe.usda@, @./geo.usda@]\n)\n")

    def meddle():
        with contextlib.suppress(BrokenPipeError), (tmp_path / "pipe.usda").open("w") as pipe:
            path.write_text("#usda 1.0\n(\n    subLayers = [@./geo.usda@]\n)\n")
            (tmp_path / "pipe.usda").unlink()
            pipe.write("#usda 1.0\n")

    thread = threading.Thread(target=meddle)
    thread.start()
    error = refused(path, {"time_limit": 20})
    thread.join()
    assert (error.issue.code, error.exit_code) == ("SOURCE_CHANGED", Exit.FILE)


@pytest.mark.parametrize("when", ["before", "after"])
def test_a_sublayer_that_changes_around_its_reading_is_noticed(layered, when, monkeypatch):
    """It is hashed before it is read, and read from the disk after that."""
    below = layered.with_name("geo.usda")

    def meddle():
        below.write_bytes(below.read_bytes() + b"\n")

    def read(path, settings):
        assert Sdf.Layer.Find(str(below)) is None
        if when == "before":
            meddle()
        rigs = read_characters(path, settings)
        if when == "after":
            meddle()
        return rigs

    monkeypatch.setattr("usdrigui.reader.reader_main.read_characters", read)
    request = Request("rigs", str(layered), Settings())
    found = reader_main.answer(request)
    assert found.refusal is not None
    assert (found.refusal.code, found.refusal.path) == ("SOURCE_CHANGED", os.path.realpath(below))


def test_an_asset_of_one_file_is_parsed_once(tmp_path, monkeypatch):
    path = head(tmp_path / "char.usda")

    def read(path, settings):
        assert Sdf.Layer.Find(str(path)) is not None
        return read_characters(path, settings)

    monkeypatch.setattr("usdrigui.reader.reader_main.read_characters", read)
    assert reader_main.answer(Request("rigs", str(path), Settings())).result is not None


@pytest.mark.parametrize("referenced", [False, True])
def test_what_usd_says_while_it_parses_is_reported_once(referenced, tmp_path):
    path = head(tmp_path / "geo.usda")
    path.write_text(path.read_text() + '\ndef "Prop" {\n    double count = 99999999999999999999\n}\n')
    if referenced:
        path = tmp_path / "char.usda"
        path.write_text("#usda 1.0\n(\n    subLayers = [@./geo.usda@]\n)\n")
    issues = read_rigs_isolated(path, Settings()).rigs[0].issues
    assert ["99999999999999999999" in each.message for each in issues if each.code == "USD_DIAGNOSTIC"] == [True]


def test_a_damaged_package_that_is_only_referenced(tmp_path):
    content = head(tmp_path / "head.usda").read_bytes()
    path = tmp_path / "char.usda"
    path.write_text("#usda 1.0\n(\n    subLayers = [@./pack.usdz@]\n)\n")
    pack = tmp_path / "pack.usdz"
    pack.write_bytes(package("head.usda", content))
    assert [Path(each.path).name for each in read_rigs_isolated(path, Settings()).sources] == ["char.usda", "pack.usdz"]
    pack.write_bytes(package("head.usda", content, zlib.crc32(content) ^ 1))
    assert refused(path).issue.code == "FILE_CORRUPT"


@pytest.mark.skipif(sys.platform != "linux", reason="a reader begins early where it is forked")
def test_what_a_reader_has_begun_is_not_read_again(tmp_path):
    """And another question is asked of a reader of its own."""
    script = (
        "import sys; from pathlib import Path\n"
        "from usdrigui.isolation import reading, worker\n"
        "from usdrigui.reader.reader_process import begin_to_read, read_rigs_isolated\n"
        "from usdrigui.pipeline.variants import selecting; from usdrigui.settings import load\n"
        "worker.active = lambda: True; path = Path(sys.argv[1]); pids = []; start = reading._started\n"
        "reading._started = lambda *each: pids.append(found := start(*each)) or found\n"
        "begin_to_read(path, load({}))\n"
        "for other in ({'read': {'time': 1.0}}, {}, {}):\n"
        "    read_rigs_isolated(path, selecting(load(other), {})); print(len(pids))\n"
    )
    done = ran("-c", script, character(tmp_path / "char.usda"))
    assert (done.stderr, done.stdout.split()) == ("", ["2", "2", "3"])
