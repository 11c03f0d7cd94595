"""For every issue code the smallest trigger that calls for it: ``TRIGGERS[code](folder, patch)``.

A trigger runs the command, or the one function that can find the fault, and returns (exit code, issues).
Files are made in `folder`; `patch` is pytest's monkeypatch, for faults of the machine.
"""

from __future__ import annotations

import contextlib
import errno
import io
import json
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from queue import SimpleQueue
from types import SimpleNamespace
from typing import Any

import minimal_assets
import numpy as np
from layout_problems import at_one_spot
from processes import impostor
from programs import ran

from usdrigui import pipeline, stages
from usdrigui.cli import distributions, main, supervised
from usdrigui.clients import blender_extension
from usdrigui.clients.batch.run import run_on_dask
from usdrigui.clients.publish import hook
from usdrigui.errors import Exit, RigUIError, issue, refuse
from usdrigui.isolation import foreign_file
from usdrigui.layer import write_layout as layer
from usdrigui.layout.motion import trajectory
from usdrigui.reader import reader_process
from usdrigui.reading import character as rig, clips
from usdrigui.replacing import transaction
from usdrigui.settings import Settings, SolveSettings
from usdrigui.stages import schema

Found = tuple[int, list[dict[str, Any]]]
Trigger = Callable[[Path, Any], Found]


def command(*arguments: object) -> Found:
    """Exit code and issues of one run of the command."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
        code = main([*map(str, arguments), "--json"])
    return code, json.loads(out.getvalue())["issues"]


def process(folder: Path, code: str = "", *arguments: object) -> Found:
    """The command on the smallest character, changed for `code`; --dry-run unless an output is named."""
    output = () if "-o" in arguments else ("--dry-run",)
    return command("process", minimal_assets.character(folder, code), *output, *arguments)


@contextlib.contextmanager
def refusal() -> Iterator[list[Any]]:
    """Catch what the block refuses."""
    found: list[Any] = []
    try:
        yield found
    except RigUIError as error:
        found[:] = [int(error.exit_code), [asdict(error.issue)]]


def refused(call: Callable[[], object]) -> Found:
    with refusal() as found:
        call()
    assert found, "nothing was refused"
    return found[0], found[1]


# --- reading -----------------------------------------------------------------------------------------


def _made(code: str, *arguments: object) -> Trigger:
    return lambda folder, _: command("process", minimal_assets.MAKERS[code](folder), "--dry-run", *arguments)


def _impostor(script: str, *arguments: object) -> Trigger:
    """A reading process of another kind."""

    def trigger(folder: Path, patch: Any) -> Found:
        impostor(folder, patch, script)
        return process(folder, "", *arguments)

    return trigger


def _changed(folder: Path, _: Any) -> Found:
    path = minimal_assets.character(folder)
    read = foreign_file.hashed(path)
    path.write_text(path.read_text() + "\n")
    return refused(lambda: foreign_file.check_unchanged([read]))


def _usd_error(folder: Path, patch: Any) -> Found:
    from pxr import Tf

    patch.setattr(rig, "_bound", lambda *_, **__: Tf.RaiseRuntimeError("corrupt asset"))
    return refused(lambda: rig.read_rigs(minimal_assets.character(folder), Settings()))


def _thinned(folder: Path, patch: Any) -> Found:
    patch.setattr(clips, "_CLIP_BYTES", 600)
    path = minimal_assets.character(folder, "CLIP_THINNED")
    return 0, [asdict(each) for each in rig.read_rigs(path, Settings())[0].issues]


def _trajectories(code: str) -> Trigger:
    def trigger(folder: Path, _: Any) -> Found:
        (found,) = rig.read_rigs(minimal_assets.character(folder, code), Settings())
        said = trajectory.trajectories(found, Settings().trajectories, np.zeros(len(found.controls)))
        return 0, [asdict(each) for each in said.issues]

    return trigger


# --- writing -----------------------------------------------------------------------------------------


def _failing_write(number: int) -> Trigger:
    def trigger(folder: Path, patch: Any) -> Found:
        def fail(*_: object) -> int:
            raise OSError(number, os.strerror(number))

        patch.setattr(os, "write", fail)
        return refused(lambda: transaction.commit("text", folder / "out.usda"))

    return trigger


# --- layers ------------------------------------------------------------------------------------------


def _written(folder: Path, *arguments: str) -> None:
    code, _ = process(folder, "", "-o", folder / "char.rigui.usda", *arguments)
    assert code == 0


def _laid_out(folder: Path) -> Path:
    _written(folder)
    return folder / "char.rigui.usda"


def _contributed(folder: Path, _: Any) -> Found:
    found = hook.judge(folder / "char.usda", _laid_out(folder), root="hero")
    return int(Exit.REFUSED), [asdict(each) for each in found]


def _edited(*edits: tuple[str, str], of: str = "char.rigui.usda") -> Callable[[Path], Path]:
    """A layout of the smallest character with regular expressions replaced in it, or in the character."""

    def made(folder: Path) -> Path:
        found = _laid_out(folder)
        path = folder / of
        text = path.read_text()
        for old, new in edits:
            text, count = re.subn(old, new, text, count=1, flags=re.DOTALL)
            assert count, f"{old!r} is not in {of}"
        path.write_text(text)
        return found

    return made


_COLLIDING = ("Index = 5", "Index = 0"), (r"position = \(4, 3, 0\)", "position = (0, 0, 0)")
_WORSE = "uniform point3f rigUI:anchor:position = (2, 0, 0)\nuniform int rigUI:anchor:pointIndex = 1"
_INVISIBLE = 'token visibility = "invisible"\npoint3f[] points'
_OTHER_NAMES = (
    r'blendShapes = \["smile", "frown"\](.*?)\["smile", "frown"\]',
    r'blendShapes = ["grin", "frown"]\1["grin", "frown"]',
)


def _laid_out_again(*edits: tuple[str, str], over: str = "") -> Trigger:
    """The smallest character changed since its layout was made, the smile of which a stronger layer corrects."""

    def trigger(folder: Path, _: Any) -> Found:
        _edited(*edits, of="char.usda")(folder).rename(folder / "earlier.rigui.usda")
        where = "".join(f'over "{name}"\n{{\n' for name in ("Char", "RigUI", "FaceControls", "smile"))
        smile = where + over + 4 * "}\n"
        corrected = folder / "corrected.usda"
        corrected.write_text(f"#usda 1.0\n(subLayers = [@./earlier.rigui.usda@])\n{smile}\n")
        return command("process", folder / "char.usda", "--dry-run", "--previous", corrected)

    return trigger


_CORRECTED = "uniform int rigUI:anchor:pointIndex = 1\n"
_TURNED = ("1, 4, 5, 2]", "1, 4, 5, 3]")


def _checked(made: Callable[[Path], Path], *arguments: object) -> Trigger:
    return lambda folder, _: command("check", made(folder), *arguments)


def _renamed(folder: Path) -> Path:
    found = _laid_out(folder)
    path = folder / "char.usda"
    path.write_text(path.read_text().replace('"Char"', '"Hero"').replace("</Char/", "</Hero/"))
    return found


def _beside_a_bare_one(folder: Path) -> Path:
    layout, shot = _laid_out(folder), folder / "shot.usda"
    shot.write_text(
        f'#usda 1.0\ndef "A" (references = @{layout.name}@</Char>) {{}}\n'
        'def "B" (references = @char.usda@</Char>) {}\n'
    )
    return shot


def _viewed(made: Callable[[Path], Path]) -> Trigger:
    return lambda folder, _: refused(lambda: pipeline.load_layer(made(folder), Settings()))


def _bare(folder: Path) -> Path:
    _written(folder, "--bare")
    return folder / "char.rigui.usda"


def _animated(names: str) -> Trigger:
    """An animation that moves the two shapes named."""

    def trigger(folder: Path, _: Any) -> Found:
        take = folder / "take.usda"
        weights = f"token[] blendShapes = [{names}]\nfloat[] blendShapeWeights.timeSamples = {{0: [0, 0], 1: [1, 1]}}"
        take.write_text(f'#usda 1.0\ndef SkelAnimation "Take" {{\n{weights}\n}}\n'.replace("'", '"'))
        return command("inspect", minimal_assets.character(folder), "--animation", take)

    return trigger


def _obsolete(folder: Path, _: Any) -> Found:
    """A character that refers to a crate of a version that no USD of today reads."""
    from pxr import Sdf

    Sdf.Layer.CreateNew(str(folder / "old.usdc")).Save()
    content = bytearray((folder / "old.usdc").read_bytes())
    content[8:11] = bytes((0, 0, 1))
    (folder / "old.usdc").write_bytes(content)
    path = minimal_assets.character(folder)
    path.write_text(path.read_text().replace('upAxis = "Y"', "subLayers = [@./old.usdc@]"))
    return command("process", path)


def _based(*changes: tuple[str, str]) -> Trigger:
    """The character of another path or name, over the layout that it had."""

    def trigger(folder: Path, _: Any) -> Found:
        found = _laid_out(folder)
        path = folder / "char.usda"
        for old, new in changes:
            path.write_text(path.read_text().replace(old, new))
        return command("process", path, "--base", found, "-o", folder / "shot.rigui.usda")

    return trigger


def _shot_over(layer: Path) -> Path:
    shot = layer.with_name("shot.usda")
    shot.write_text(f"#usda 1.0\n(\n    subLayers = [@./{layer.name}@]\n)\n")
    return shot


def _renamed_since(folder: Path, *more: str) -> Path:
    """The layout of a character that stood at another path; `more` are names of prims that it had otherwise, too."""
    found = _laid_out(folder)
    for path in (found, folder / "char.usda"):
        text = path.read_text().replace('"Char"', '"Hero"').replace("</Char/", "</Hero/")
        for name in more:
            text = text.replace(name, f"{name}Before")
        path.write_text(text)
    return found.rename(folder / "hero.rigui.usda")


def _no_layout(folder: Path) -> Path:
    return minimal_assets.character(folder)


def _switched_off(folder: Path) -> Path:
    from pxr import Sdf

    found = _laid_out(folder)
    layer = Sdf.Layer.FindOrOpen(str(found))
    layer.GetPrimAtPath("/Char").variantSelections["rigUI"] = "none"
    layer.Save()
    return found


def _attached(made: Callable[[Path], Path], name: str = "char.usda", *, in_variant: bool = False) -> Trigger:
    from usdrigui.clients.attaching.attach import attach

    return lambda folder, _: refused(lambda: attach(folder / name, made(folder), Settings(), in_variant=in_variant))


def _gone_when_attached(folder: Path, _: Any) -> Found:
    bare, asset = _bare(folder), folder / "char.usda"
    asset.write_text(asset.read_text().replace("smile", "grin"))
    return command("attach", asset, bare)


def _linked(folder: Path) -> Path:
    (folder / "link.usda").symlink_to("char.usda")
    return _bare(folder)


def _shared(folder: Path) -> Path:
    found = _bare(folder)
    (folder / "other.usda").hardlink_to(folder / "char.usda")
    return found


def _busy(folder: Path, _: Any) -> Found:
    from usdrigui.replacing.exchange import editing

    def twice() -> None:
        with editing(folder / "char.usda", 0.0), editing(folder / "char.usda", 0.0):
            pass

    return refused(twice)


def _of_another_owner(folder: Path, patch: Any) -> Found:
    patch.setattr(transaction, "keep_attributes", lambda *_: ["group", "owner"])
    return _attached(_bare)(folder, patch)


def _of_another(folder: Path) -> Path:
    found = _bare(folder)
    found.write_text(found.read_text().replace('over "Char"', 'over "Other"'))
    return found


def _beyond_its_root(folder: Path) -> Path:
    found = _bare(folder)
    found.write_text(found.read_text().replace("anchor:prim = </Char/", "anchor:prim = </Set/", 1))
    return found


def _over_another(folder: Path) -> Path:
    found = _bare(folder)
    (folder / "other.usda").write_text("#usda 1.0\n")
    found.write_text(found.read_text().replace("#usda 1.0\n(", "#usda 1.0\n(\n    subLayers = [@./other.usda@]", 1))
    return found


# --- batches -----------------------------------------------------------------------------------------


def _job(script: str, timeout: float = 0.0) -> Trigger:
    """A job of a batch whose process is another one."""
    from usdrigui.clients.batch import jobs
    from usdrigui.clients.batch.job import Job

    def trigger(folder: Path, patch: Any) -> Found:
        impostor(folder, patch, script)
        row = jobs.run_job(Job(str(folder / "char.usda"), str(folder / "out.usda"), "", timeout=timeout))
        return row.exit, [asdict(issue(row.code, row.asset, row.message))]

    return trigger


def _too_many(_: Path, patch: Any) -> Found:
    from usdrigui.clients import openjd

    patch.setattr(openjd, "_TASKS", 1)
    patch.setattr(openjd, "_STEPS", 1)
    return refused(lambda: openjd.template([(Path("/a"), Path("/b"))] * 2, ()))


def _no_scheduler(_: Path, patch: Any) -> Found:
    from usdrigui.clients.batch.run import run_on_dask

    def client(*_: object, **__: object) -> None:
        raise OSError("connection refused")

    patch.setitem(sys.modules, "distributed", SimpleNamespace(Client=client))
    return refused(lambda: list(run_on_dask([], "tcp://farm:8786")))


def _no_animation(folder: Path, _: Any) -> Found:
    from usdrigui.view.sheet import film_gif

    (found,) = rig.read_rigs(minimal_assets.character(folder), Settings())
    return refused(lambda: film_gif([(found, None)], frames=2))


# --- problems and poses ------------------------------------------------------------------------------


def _problem(folder: Path) -> Any:
    (found,) = rig.read_rigs(minimal_assets.character(folder), Settings())
    return pipeline.build_problem(found, Settings()).placement.problem


def _infeasible(folder: Path, _: Any) -> Found:
    from usdrigui.solve import solve

    return refused(lambda: solve(at_one_spot(_problem(folder)), SolveSettings()))


def _without(package: str, trigger: Trigger) -> Trigger:
    def hidden(folder: Path, patch: Any) -> Found:
        patch.setitem(sys.modules, package, None)
        return trigger(folder, patch)

    return hidden


def _bad_term(folder: Path, patch: Any) -> Found:
    from importlib import metadata

    term = SimpleNamespace(linear=lambda _face, _motion, points: -np.ones(len(points)))
    entry = SimpleNamespace(name="studio", load=lambda: term)
    patch.setattr(metadata, "entry_points", lambda **_: [entry])
    return process(folder, "", "--set", 'objective.terms=["studio"]')


def _posed(call: Callable[[Any], object]) -> Trigger:
    return lambda folder, _: refused(lambda: call(rig.read_rigs(minimal_assets.character(folder), Settings())[0]))


def _valued(pose: Mapping[str, float]) -> Callable[[Any], object]:
    from usdrigui.pose import evaluate

    return lambda found: evaluate.checked_values(found, evaluate.values_of(found, pose))


def _empty_page(*_: object) -> Found:
    from usdrigui.view.web.page import page_html

    return refused(lambda: page_html([], "none"))


def _not_shipped(asked: Callable[[], object]) -> Callable[[Path, Any], Found]:
    def found(folder: Path, patch: Any) -> Found:
        patch.setattr(schema, "__file__", str(folder / "usdrigui" / "stages" / "schema.py"))
        return refused(asked)

    return found


def _no_usd(_: Path, patch: Any) -> Found:
    patch.setitem(sys.modules, "pxr", None)
    return refused(stages.require_usd)


def _two_usds(folder: Path, patch: Any) -> Found:
    for name in ("usd-core", "usd-exchange"):
        info = folder / f"{name.replace('-', '_')}-26.8.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 26.8\n")
        (info / "RECORD").write_text(f"{info.name}/METADATA,,\npxr/Usd/__init__.py,,\n")
    (folder / "pxr").mkdir()
    patch.delitem(sys.modules, "pxr")
    patch.setattr(sys, "path", [str(folder)])
    return 0, [asdict(each) for each in distributions.colliding()]


def _schema_late(*_: object) -> Found:
    program = (
        "from pxr import Usd; keep = Usd.SchemaRegistry()\n"
        "import json; from dataclasses import asdict; from usdrigui.errors import RigUIError\n"
        "from usdrigui.stages import schema\n"
        "try: schema.register()\n"
        "except RigUIError as error: print(json.dumps([int(error.exit_code), [asdict(error.issue)]]))\n"
    )
    done = ran("-c", program)
    exit_code, issues = json.loads(done.stdout)
    place = str(schema.schema_path())
    return exit_code, [{key: value.replace(place, "SCHEMAS") for key, value in each.items()} for each in issues]


def _raising(error: BaseException) -> Trigger:
    def trigger(folder: Path, patch: Any) -> Found:
        def broken(*_: object, **__: object) -> None:
            raise error

        patch.setattr(pipeline, "process", broken)
        return process(folder)

    return trigger


def _supervised(script: str) -> Trigger:
    """The command itself, its worker being another program."""

    def trigger(folder: Path, patch: Any) -> Found:
        impostor(folder, patch, script)
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
            code = supervised.run(["process", str(folder / "char.usda"), "--json"], SimpleQueue())
        return code, json.loads(out.getvalue())["issues"]

    return trigger


def _no_interpreter(folder: Path, patch: Any) -> Found:
    (folder / "python").touch(mode=0o600)
    patch.setattr(sys, "executable", str(folder / "python"))
    return refused(lambda: reader_process.read_rigs_isolated(minimal_assets.character(folder, ""), Settings()))


def _told(what: str, **fields: object) -> str:
    """A message of a worker, said by a shell."""
    return f"echo '{json.dumps({'what': what, **fields})}'"


def _no_working_directory(folder: Path, patch: Any) -> Found:
    def gone() -> str:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))

    patch.setattr(os, "getcwd", gone)
    return _supervised("exit 0")(folder, patch)


def _full_output(folder: Path, patch: Any) -> Found:
    """Only standard error can tell it."""
    impostor(folder, patch, _told("end", code=0, out="laid out", err=""))
    err = io.StringIO()
    with Path("/dev/full").open("w") as full, contextlib.redirect_stdout(full), contextlib.redirect_stderr(err):
        code = supervised.run(["process", "char.usda"], SimpleQueue())
    told = re.fullmatch(r"usdrigui: (\w+) ([^:]+): (.*)", err.getvalue().splitlines()[0])
    assert told is not None
    return code, [asdict(refuse(*told.groups()).issue)]


def _configured(toml: str) -> Trigger:
    def trigger(folder: Path, _: Any) -> Found:
        (folder / "char.rigui.toml").write_text(toml)
        return process(folder)

    return trigger


def _glyph(text: str) -> Trigger:
    """A file with or without the glyph that the configuration names."""

    def trigger(folder: Path, patch: Any) -> Found:
        (folder / "glyphs.usda").write_text(f"#usda 1.0\n{text}\n")
        return _configured('[controls.smile]\nglyph = "glyphs.usda</Star>"\n')(folder, patch)

    return trigger


def _in_variants(owner: str, prim: str, *arguments: object) -> Trigger:
    """The smallest character with a variant set LOD on `owner`, of which ``box`` has no `prim`."""

    def trigger(folder: Path, _: Any) -> Found:
        from pxr import Usd

        stage = Usd.Stage.Open(str(minimal_assets.character(folder)))
        levels = stage.GetPrimAtPath(owner).GetVariantSets().AddVariantSet("LOD")
        for level in ("box", "high"):
            levels.AddVariant(level)
            levels.SetVariantSelection(level)
            with levels.GetVariantEditContext():
                stage.OverridePrim(prim).SetActive(level != "box")
        stage.Save()
        return command("process", folder / "char.usda", "--dry-run", *arguments)

    return trigger


TRIGGERS: Mapping[str, Trigger] = {
    **{code: (lambda folder, _, code=code: process(folder, code)) for code in minimal_assets.EDITS},
    **{code: _made(code) for code in minimal_assets.MAKERS},
    **{
        code: (lambda folder, _, setting=setting: process(folder, "", "--set", setting))
        for code, setting in minimal_assets.CONFIGURED.items()
    },
    "HANDLES_NARROWER": lambda folder, _: process(
        folder, "", "--set", "objective.handle_size=0.9", "--set", "objective.max_neighbours=1"
    ),
    "SOURCE_TIME_LIMIT": _made("SOURCE_TIME_LIMIT", "--set", "read.time_limit=1"),
    "SOURCE_MEMORY_LIMIT": _made("SOURCE_MEMORY_LIMIT", "--set", "read.memory_limit=24"),
    "SOURCE_READER_LOST": _impostor("kill -KILL $$"),
    "SOURCE_CHANGED": _changed,
    "USD_ERROR": _usd_error,
    "VARIANT_BELOW": _in_variants("/Char/Face", "/Char/Face/smile", "--variant", "LOD=high"),
    "VARIANT_LEFT_OFF": _in_variants("/Char", "/Char/Face", "--each-variant", "LOD"),
    "CLIP_THINNED": _thinned,
    "CONTROL_TINY": _trajectories("CONTROL_TINY"),
    "CONFIG_SYNTAX": _configured("[solve\n"),
    "RUN_TIME_LIMIT": _supervised(_told("budget", seconds=0.2, memory=100, base=0) + "; exec sleep 60"),
    "RUN_MEMORY_LIMIT": _raising(MemoryError()),
    "WORKER_LOST": _supervised("kill -KILL $$"),
    "PYTHON_PERMISSION": _no_interpreter,
    "WORKER_CRASHED": _supervised("kill -SEGV $$"),
    "OUTPUT_STREAM": _full_output,
    "REVIEW_LAYER": lambda folder, _: command(
        "view", folder / "char.rigui.usda", "--review", folder / "none.usda"
    ),
    "STUDY_RESULTS": lambda folder, _: command("study", folder / "none.csv"),
    "COMMAND_LINE": lambda *_: command("procces"),
    "WORKING_DIRECTORY": _no_working_directory,
    "FILE_ACCESS": _raising(OSError(errno.ENAMETOOLONG, os.strerror(errno.ENAMETOOLONG), "char.usda")),
    "INTERRUPTED": _raising(KeyboardInterrupt()),
    "BUG": _raising(ZeroDivisionError("by nothing")),
    "EXTRA_MISSING": _without(
        "distributed", lambda *_: refused(lambda: list(run_on_dask([], "tcp://127.0.0.1:9")))
    ),
    "FILE_FULL": _failing_write(errno.ENOSPC),
    "FILE_READ_ONLY": _failing_write(errno.EROFS),
    "FILE_PERMISSION": _failing_write(errno.EACCES),
    "FILE_WRITE": _failing_write(errno.EIO),
    "FILE_TARGET": lambda folder, _: process(folder, "", "-o", folder / "char.usda"),
    "FILE_VERIFY": lambda folder, _: refused(
        lambda: transaction.commit("text", folder / "out.usda", verify=lambda _: False)
    ),
    "SOURCE_UNREFERABLE": lambda folder, _: refused(
        lambda: layer.relative_asset_path(folder / "a@@@b.usda", folder / "out.usda")
    ),
    "USD_MISSING": _no_usd,
    "USD_TWICE": _two_usds,
    "EXTENSION_MISSING": _not_shipped(blender_extension.extension_files),
    "SCHEMA_MISSING": _not_shipped(schema.schema_path),
    "SCHEMA_TOO_LATE": _schema_late,
    "VIEW_MISMATCH": _empty_page,
    "LAYOUT_MISSING": _viewed(_no_layout),
    "LAYOUT_OFF": _viewed(_switched_off),
    "WEIGHTS_BEYOND_LIMITS": lambda folder, _: command(
        "check", minimal_assets.character(folder, "WEIGHTS_BEYOND_LIMITS")
    ),
    "LAYOUT_INVALID": _checked(_edited((r"uniform int rigUI:anchor:pointIndex = \d+\n", ""))),
    "LAYOUT_TRACK": _checked(_edited((r"(smile:trackPoints = \[[^)]*\)), \([^)]*\)", r"\1, (0, 9, 0)"))),
    "LAYOUT_DRAWN": _checked(_edited((r"point3f\[\] points = \[\([^)]*\)", "point3f[] points = [(9, 9, 9)"))),
    "LAYOUT_VALUE": _checked(_edited((r"(double rigUI:control:smile:value)", r"\1 = 0.7"))),
    "LAYOUT_VERSION": _checked(_edited(("RigUILayoutAPI", "RigUILayoutAPI_99"))),
    "PUBLISH_ROOT": _contributed,
    "VALUES_MISSING": lambda folder, _: command("bake", _laid_out(folder)),
    "SOURCE_MISSING": _viewed(_bare),
    "LAYOUT_STALE": _viewed(_renamed),
    "CONTROL_RENAMED": _laid_out_again(_OTHER_NAMES),
    "CONTROL_UNSURE": _laid_out_again(_OTHER_NAMES, (r"\(0,0,1\), \(0,0,0.5\)", "(0,0.05,1), (0,0,0.5)")),
    "PIN_CARRIED": _laid_out_again(_TURNED, over=_CORRECTED + "uniform point3f rigUI:anchor:position = (9, 9, 9)\n"),
    "PIN_LOST": _laid_out_again(_TURNED, over="uniform int rigUI:anchor:pointIndex = 99\n"),
    "OPINION_IGNORED": _laid_out_again(over='over "grin" { uniform int rigUI:anchor:pointIndex = 1\n}\n'),
    "LAYOUT_NONE": _checked(_beside_a_bare_one),
    "LAYOUT_MESH_GONE": _checked(_edited(("rigUI:anchor:prim = </Char/Face>", "rigUI:anchor:prim = </Char/Nose>"))),
    "LAYOUT_TOPOLOGY": _checked(_edited(("1, 4, 5, 2]", "1, 4, 5, 3]"), of="char.usda")),
    "LAYOUT_ANCHOR_MOVED": _checked(_edited((r"anchor:position = \([^)]*\)", "anchor:position = (9, 9, 9)"))),
    "LAYOUT_RESHAPED": _checked(_edited((r"\(0,0,0\), (.*)\(4,3,0\)\]", r"(1,0,0), \1(4,4,0)]"), of="char.usda")),
    "LAYOUT_CONTROL_GONE": _checked(_edited(_OTHER_NAMES, of="char.usda")),
    "LAYOUT_CONTROL_NEW": _checked(_edited(_OTHER_NAMES, of="char.usda")),
    "LAYOUT_NOT_ANIMATED": _checked(_edited((r"rel skel:animationSource = [^\n]*\n", ""), of="char.usda")),
    "LAYOUT_HANDLES_COLLIDE": _checked(_edited(*_COLLIDING)),
    "LAYOUT_UNCLEAR": _checked(_edited(*_COLLIDING)),
    "LAYOUT_BETTER_PLACE": _checked(_edited(("uniform int rigUI:anchor:pointIndex = 0", _WORSE))),
    "LAYOUT_ANCHOR_HIDDEN": _checked(_edited((r"point3f\[\] points", _INVISIBLE), of="char.usda")),
    "GLYPH_MISSING": _glyph(""),
    "GLYPH_TYPE": _glyph('def Xform "Star" {}'),
    "GLYPH_EMPTY": _glyph('def Mesh "Star" {}'),
    "FIXED_IMPOSSIBLE": _configured('[controls.smile]\nanchor = "/Char/Face#5"\n'),
    "CLIP_UNKNOWN_CONTROL": _animated("'wing', 'smile'"),
    "CLIP_FOREIGN": _animated("'wing', 'tail'"),
    "LAYER_UNREADABLE": _obsolete,
    "BASE_COMPLETE": _based(),
    "BASE_APART": _based(('"Char"', '"Hero"'), ("</Char/", "</Hero/")),
    "BASE_MISMATCH": _based(("Face", "Nose")),
    "PREVIOUS_MISMATCH": lambda folder, _: process(folder, "", "--previous", _renamed_since(folder, "Face")),
    "PREVIOUS_RENAMED": lambda folder, _: process(folder, "", "--previous", _renamed_since(folder)),
    "SOURCE_IS_LAYOUT": lambda folder, _: command("process", _laid_out(folder)),
    "SOURCE_HAS_LAYOUT": lambda folder, _: command("process", _shot_over(_laid_out(folder)), "--dry-run"),
    "ATTACH_PACKAGE": _attached(_no_layout, "char.usdz"),
    "ATTACH_LINK": _attached(_linked, "link.usda"),
    "ATTACH_BUSY": _busy,
    "ATTACH_HARD_LINK": _attached(_shared),
    "ATTACH_ATTRIBUTES": _of_another_owner,
    "ATTACH_MISMATCH": _attached(_of_another),
    "ATTACH_CONTROLS_GONE": _gone_when_attached,
    "ATTACH_CYCLE": _attached(_laid_out),
    "ATTACH_NOT_BARE": _attached(_over_another),
    "ATTACH_OUTSIDE": _attached(_beyond_its_root, in_variant=True),
    "BATCH_NO_MATCH": lambda folder, _: command("batch", folder / "*.usda"),
    "BATCH_TIME_LIMIT": _job("exec sleep 60", 0.2),
    "BATCH_TOO_MANY": _too_many,
    "BATCH_SCHEDULER": _no_scheduler,
    "ANIMATION_MISSING": _no_animation,
    "NORMALS_INWARD": _trajectories("NORMALS_INWARD"),
    "SOLVE_INFEASIBLE": _infeasible,
    "TERM_INVALID": _bad_term,
    "POSE_CONTROL": _posed(_valued({"smirk": 1.0})),
    "POSE_VALUE": _posed(_valued({"smile": float("nan")})),
}  # fmt: skip
