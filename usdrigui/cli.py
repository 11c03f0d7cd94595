"""The command line: the only place that prints or chooses an exit code.

`main` parses, calls one function per command and turns every outcome into one closing verdict line.
Nothing heavy (pxr, scipy, highspy) is imported before a command needs it.
"""

from __future__ import annotations

import argparse
import dataclasses
import functools
import hashlib
import io
import json
import os
import signal
import sys
import time
import tomllib
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from usdrigui import __version__
from usdrigui.errors import Exit, RigUIError, refuse, visible

if TYPE_CHECKING:
    from usdrigui import report, terminal
    from usdrigui.clients.batch import jobs
    from usdrigui.settings import Settings


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns its exit code (see `usdrigui.errors.Exit`)."""
    arguments = _parser().parse_args(argv)
    _prepare_streams(machine=getattr(arguments, "json", False))
    try:
        return int(arguments.run(arguments))
    except RigUIError as error:
        _refused(error, arguments)
        return int(error.exit_code)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return int(Exit.FILE)
    except KeyboardInterrupt:
        stopped = refuse("INTERRUPTED", "", "stopped by the user before there was a result")
        _refused(stopped, arguments)
        return int(stopped.exit_code)
    except Exception as bug:
        return _bug(bug, arguments)


# --- the commands ------------------------------------------------------------------------------------


def _process(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline, report
    from usdrigui.examples import ExampleLayers

    settings = _settings(arguments)
    examples = ExampleLayers(fixed=arguments.fixed, previous=arguments.previous, like=arguments.like)
    screen = _screen(arguments)
    with _Interruption() as interruption, _progress(screen, arguments) as shown:

        def watch(event: pipeline.Event) -> None:
            interruption.patient = event.can_stop
            shown(event)

        result = pipeline.process(
            arguments.asset,
            settings,
            output=arguments.output,
            dry_run=arguments.dry_run,
            progress=watch,
            stop=interruption.requested,
            examples=examples,
        )
        arguments.layer_state = f"{result.outcome} {result.output}".rstrip()
        written = _extras(result, arguments)
    if arguments.json:
        sys.stdout.write(report.to_json(result))
    else:
        screen.report(result, written)
    return _strict(result.issues, arguments)


def _batch(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.clients.batch import run, sheet

    screen = _screen(arguments)
    jobs = _jobs(arguments)
    address = arguments.dask
    start = time.perf_counter()
    with screen.batch_progress(len(jobs)) as shown:
        rows = []
        for row in run.run_on_dask(jobs, address) if address else run.run_local(jobs, arguments.jobs):
            rows.append(row)
            shown(row)
    ordered = run.in_order(rows, jobs)
    summary = run.Summary(ordered, time.perf_counter() - start, address or "local", 0 if address else arguments.jobs)
    written = []
    if arguments.sheet is not None:
        written.append(f"{pipeline.write_file(sheet.sheet_png(ordered), arguments.sheet)} {arguments.sheet}")
    if arguments.summary is not None:
        written.append(f"{pipeline.write_file(run.to_json(summary).encode(), arguments.summary)} {arguments.summary}")
    if arguments.json:
        sys.stdout.write(run.to_json(summary))
    else:
        screen.batch(summary, written)
    warned = arguments.strict and any(row.warnings for row in ordered)
    return max(summary.exit_code, Exit.REFUSED if warned else Exit.OK)


def _openjd(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.clients import openjd
    from usdrigui.clients.batch import places

    assets = places.find_assets(arguments.patterns)
    pairs = [(asset, places.output_of(asset, assets, arguments.folder)) for asset in assets]
    template = openjd.template(pairs, _passed_on(arguments))
    if arguments.output is None:
        sys.stdout.write(template)
        return Exit.OK
    state = pipeline.write_file(template.encode(), arguments.output)
    _say(f"usdrigui: {state} {arguments.output}: {len(assets)} tasks", arguments)
    return Exit.OK


def _jobs(arguments: argparse.Namespace) -> list[jobs.Job]:
    """One job per asset, each with the settings that its own configuration gives."""
    from usdrigui.clients.batch import jobs, places

    assets = places.find_assets(arguments.patterns)
    threads = () if arguments.threads is not None else ("--threads", str(_threads_each(arguments)))
    passed = (*_passed_on(arguments), *threads)
    found = []
    for asset in assets:
        output = places.output_of(asset, assets, arguments.folder)
        picture = str(output.with_suffix(".png")) if arguments.sheet is not None else ""
        arguments.asset = asset
        digest = _settings_digest(arguments)
        found.append(jobs.Job(str(asset), str(output), picture, passed, digest, arguments.timeout, arguments.again))
    del arguments.asset
    return found


def _threads_each(arguments: argparse.Namespace) -> int:
    """Threads for each process, so that together they fill the machine; on a cluster one."""
    return 1 if arguments.dask else max(1, (os.cpu_count() or 1) // max(1, arguments.jobs))


def _settings_digest(arguments: argparse.Namespace) -> str:
    """Digest of everything that the settings of a command say, but for the threads, which change no result."""
    settings = _settings(arguments)
    settings = dataclasses.replace(settings, solve=dataclasses.replace(settings.solve, threads=0))
    return hashlib.sha256(repr(settings).encode()).hexdigest()


def _passed_on(arguments: argparse.Namespace) -> list[str]:
    """The settings of a command as options of another, with files by their absolute paths."""
    passed = []
    for name in ("config", "pose"):
        if getattr(arguments, name) is not None:
            passed += [f"--{name}", str(getattr(arguments, name).absolute())]
    if arguments.preset != "default":
        passed += ["--preset", arguments.preset]
    for text in arguments.set:
        passed += ["--set", text]
    for option in _OPTIONS:
        value = getattr(arguments, option, None)
        if value is not None and value is not False:
            name = f"--{option.replace('_', '-')}"
            passed += [name] if value is True else [f"{name}={value}"]
    return passed


def _inspect(arguments: argparse.Namespace) -> Exit:
    from usdrigui import inspection, pipeline

    settings = _settings(arguments)
    screen = _screen(arguments)
    with screen.progress() as shown:
        found = pipeline.inspect(arguments.asset, settings, progress=shown)
    if arguments.json:
        sys.stdout.write(inspection.to_json(found))
    else:
        screen.inspection(found)
    return _strict(found.issues, arguments)


def _check(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline, report

    screen = _screen(arguments)
    with screen.progress() as shown:
        found = pipeline.check(arguments.layer, _settings(arguments), progress=shown)
    if arguments.json:
        sys.stdout.write(report.review_json(found.layer, found.characters, found.issues))
    else:
        screen.review(found)
    if any(each.severity == "error" for each in found.issues):
        return Exit.REFUSED
    return _strict(found.issues, arguments)


def _diff(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline, report
    from usdrigui.settings import Settings

    names = str(arguments.before), str(arguments.layer)
    found, only_in_one = pipeline.differences(arguments.before, arguments.layer, Settings())
    if arguments.json:
        sys.stdout.write(report.difference_json(*names, found, only_in_one))
    else:
        _screen(arguments).difference(*names, found, only_in_one)
    differ = bool(only_in_one) or any(character.changes for character in found)
    return Exit.REFUSED if arguments.strict and differ else Exit.OK


def _view(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.pose import evaluate
    from usdrigui.view import page, serve

    loaded = pipeline.load_layer(arguments.layer, _settings(arguments))
    for rig, layout in loaded.characters:
        evaluate.prepare(rig, layout)  # refuses a layout made for another version of the character
    html = page.page_html(loaded.characters, title=Path(arguments.layer).name)
    if arguments.html:
        state = pipeline.write_file(html.encode(), arguments.html)
        _say(f"usdrigui: {state} {arguments.html}", arguments)
        return Exit.OK
    serve.serve(html, open_browser=not arguments.no_browser, announce=lambda address: print(address, flush=True))
    return Exit.OK


def _flat_picker(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.clients import picker

    if arguments.svg is None and arguments.dwpicker is None:
        raise refuse("CONFIG_VALUE", "picker", "say what to write: --svg FILE, --dwpicker FILE or both")
    loaded = pipeline.load_layer(arguments.layer, _settings(arguments))
    made = picker.picker(loaded.characters)
    if arguments.svg is not None:
        _say(f"{pipeline.write_file(picker.to_svg(made).encode(), arguments.svg)} {arguments.svg}", arguments)
    if arguments.dwpicker is not None:
        content = picker.to_dwpicker(made, arguments.layer.name.partition(".")[0]).encode()
        _say(f"{pipeline.write_file(content, arguments.dwpicker)} {arguments.dwpicker}", arguments)
    _say(f"usdrigui: picker of {arguments.layer}: {len(made.spots)} elements", arguments)
    return Exit.OK


def _attach(arguments: argparse.Namespace) -> Exit:
    from usdrigui.usd.attach import attach

    state = attach(arguments.asset, arguments.layer, _settings(arguments))
    return _edited(state, "is among its sublayers", arguments)


def _detach(arguments: argparse.Namespace) -> Exit:
    from usdrigui.usd.attach import detach

    state = detach(arguments.asset, arguments.layer, _settings(arguments))
    return _edited(state, "is not among its sublayers", arguments)


def _edited(state: str, what: str, arguments: argparse.Namespace) -> Exit:
    if arguments.json:
        told = {"asset": str(arguments.asset), "layer": str(arguments.layer), "outcome": state, "exit": 0}
        print(json.dumps({"format": "usdrigui.attach", "version": 1, **told}, indent=2))
    _say(f"usdrigui: {state} {arguments.asset}: {arguments.layer} {what}", arguments)
    return Exit.OK


def _picture(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.view import sheet

    loaded = pipeline.load_layer(arguments.layer, _settings(arguments))
    if arguments.output.suffix not in (".png", ".gif"):
        raise refuse("CONFIG_VALUE", "--output", f"a picture ends in .png or .gif, not in {arguments.output.suffix!r}")
    if arguments.output.suffix == ".gif":
        content = sheet.film_gif(loaded.characters, frames=arguments.frames)
    else:
        content = sheet.sheet_png(loaded.characters, labels=arguments.labels)
    state = pipeline.write_file(content, arguments.output)
    _say(f"usdrigui: {state} {arguments.output}", arguments)
    return Exit.OK


def _schema_path(arguments: argparse.Namespace) -> Exit:
    from usdrigui.usd.schema import schema_path

    del arguments
    print(schema_path())
    return Exit.OK


# --- arguments ---------------------------------------------------------------------------------------


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="usdrigui",
        description="Automatic in-situ rig UI layouts for USD characters.",
        epilog="Exit codes: 0 done, 1 asset refused, 2 usage or configuration, 3 file, 4 limit, 5 a bug of ours.",
    )
    parser.add_argument("--version", action="version", version=f"usdrigui {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    _add_process(commands)
    _add_inspect(commands)
    _add_check(commands)
    _add_diff(commands)
    _add_view(commands)
    _add_picture(commands)
    _add_flat_picker(commands)
    _add_batch(commands)
    _add_openjd(commands)
    _add_attach(commands)
    _add_detach(commands)
    schema = commands.add_parser("schema-path", help="print the folder to add to PXR_PLUGINPATH_NAME")
    schema.set_defaults(run=_schema_path)
    return parser


def _add_process(commands: Any) -> None:
    parser = _command(commands, "process", _process, "lay out a character and write the layer beside it")
    parser.add_argument("asset", type=Path, metavar="CHAR", help=".usd, .usda, .usdc or .usdz")
    parser.add_argument("-o", "--output", type=Path, metavar="LAYER", help="default: CHAR.rigui.usda beside CHAR")
    parser.add_argument("--dry-run", action="store_true", help="do everything but write")
    parser.add_argument("--fixed", type=Path, metavar="LAYER", help="keep this layout's anchors and groups exactly")
    parser.add_argument("--previous", type=Path, metavar="LAYER", help="keep this layout's places unless moving pays")
    parser.add_argument("--like", type=Path, metavar="LAYER", help="another character's layout, to be imitated")
    parser.add_argument("--report", type=Path, metavar="JSON", help="write the full account of the run")
    parser.add_argument("--preview", type=Path, metavar="PNG", help="write a picture of the layout")
    parser.add_argument("--labels", action="store_true", help="name the elements in the picture")
    parser.add_argument("--bare", action="store_true", help="leave CHAR out of the layer's sublayers")
    parser.add_argument("--openjd", action="store_true", help="print progress as Open Job Description asks for it")
    _add_settings(parser)


def _add_inspect(commands: Any) -> None:
    parser = _command(commands, "inspect", _inspect, "list the controls without solving")
    parser.add_argument("asset", type=Path, metavar="CHAR", help=".usd, .usda, .usdc or .usdz")
    _add_settings(parser)


def _add_check(commands: Any) -> None:
    parser = _command(commands, "check", _check, "say whether a layout still fits its rig, or an asset is sound")
    parser.add_argument("layer", type=Path, metavar="LAYER", help="a layout layer over its character")
    _add_settings(parser)


def _add_diff(commands: Any) -> None:
    parser = _command(commands, "diff", _diff, "say which controls two layouts of a character place otherwise, and why")
    parser.add_argument("before", type=Path, metavar="BEFORE", help="a layout layer")
    parser.add_argument("layer", type=Path, metavar="AFTER", help="another layout layer of the same character")


def _add_view(commands: Any) -> None:
    parser = _command(commands, "view", _view, "pose the character in a browser by its layout")
    parser.add_argument("layer", type=Path, metavar="LAYER", help="a layer written by `usdrigui process`")
    parser.add_argument("--html", type=Path, metavar="FILE", help="write one self-contained page instead of serving it")
    parser.add_argument("--no-browser", action="store_true", help="serve, but do not open a browser")


def _add_flat_picker(commands: Any) -> None:
    parser = _command(commands, "picker", _flat_picker, "export the layout as a flat picker, seen from its view")
    parser.add_argument("layer", type=Path, metavar="LAYER", help="a layer written by `usdrigui process`")
    parser.add_argument("--svg", type=Path, metavar="FILE", help="write a picture whose groups name their controls")
    parser.add_argument("--dwpicker", type=Path, metavar="JSON", help="write a picker for dwpicker")


def _add_batch(commands: Any) -> None:
    parser = _command(commands, "batch", _batch, "lay out many characters, each in a process of its own")
    _add_assets(parser)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N", help="processes at a time")
    parser.add_argument("--dask", metavar="ADDRESS", help="use the workers of this dask scheduler instead")
    parser.add_argument("--timeout", type=float, default=0.0, metavar="SECONDS", help="end an asset that takes longer")
    parser.add_argument("--again", action="store_true", help="lay out even what has not changed")
    parser.add_argument("--summary", type=Path, metavar="JSON", help="write what became of every asset")
    parser.add_argument("--sheet", type=Path, metavar="PNG", help="write a contact sheet; pictures stay by the layers")
    _add_settings(parser)


def _add_openjd(commands: Any) -> None:
    parser = _command(commands, "openjd", _openjd, "write a farm job, one task a character (Open Job Description)")
    _add_assets(parser)
    parser.add_argument("-o", "--output", type=Path, metavar="JSON", help="default: print it")
    _add_settings(parser)


def _add_assets(parser: Any) -> None:
    parser.add_argument("patterns", nargs="+", metavar="PATTERN", help="files, or patterns in quotes; ** is any depth")
    parser.add_argument("--output-dir", dest="folder", type=Path, metavar="DIR", help="default: beside each asset")
    parser.add_argument("--bare", action="store_true", help="leave the assets out of the layers' sublayers")


def _add_attach(commands: Any) -> None:
    parser = _command(commands, "attach", _attach, "put a bare layout layer among the sublayers of the asset itself")
    parser.add_argument("asset", type=Path, metavar="CHAR", help="the asset's root layer, which is edited")
    parser.add_argument("layer", type=Path, metavar="LAYER", help="written by `usdrigui process --bare`")


def _add_detach(commands: Any) -> None:
    parser = _command(commands, "detach", _detach, "take a layout layer out of the asset's sublayers again")
    parser.add_argument("asset", type=Path, metavar="CHAR", help="the asset's root layer, which is edited")
    parser.add_argument("layer", type=Path, metavar="LAYER", help="the layer to take out; its file may be gone")


def _add_picture(commands: Any) -> None:
    parser = _command(commands, "picture", _picture, "draw a layout layer, or the character's animation under it")
    parser.add_argument("layer", type=Path, metavar="LAYER", help="a layer written by `usdrigui process`")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FILE", help="a .png, or a .gif that moves")
    parser.add_argument("--labels", action="store_true", help="name the elements")
    parser.add_argument("--frames", type=int, default=24, metavar="N", help="pictures in a .gif")


def _command(commands: Any, name: str, run: Callable[[argparse.Namespace], Exit], summary: str) -> Any:
    parser = commands.add_parser(name, help=summary, description=summary[0].upper() + summary[1:] + ".")
    parser.set_defaults(run=run)
    parser.add_argument("--json", action="store_true", help="print one JSON document instead of text")
    parser.add_argument("-q", "--quiet", action="store_true", help="print the verdict line only")
    parser.add_argument("--strict", action="store_true", help="exit 1 if there are warnings")
    return parser


def _add_settings(parser: Any) -> None:
    group = parser.add_argument_group("settings", "docs/settings.md lists all that a configuration can say")
    group.add_argument("--config", type=Path, metavar="TOML", help="default: CHAR.rigui.toml beside CHAR, if there")
    group.add_argument("--preset", default="default", metavar="NAME", help="default, or paper: the paper's constants")
    group.add_argument("--set", action="append", default=[], metavar="PART.KEY=VALUE", help="any one setting")
    group.add_argument("--view", metavar="VIEW", help="front, side, AZ,EL in degrees or a camera prim")
    group.add_argument("--space", choices=("object", "view"), help="space elements in 3-D or as seen from the view")
    group.add_argument("--pose", type=Path, metavar="TOML", help="base pose: a file of control = value lines")
    group.add_argument("--time", type=float, metavar="CODE", help="base pose: the animation at this time code")
    group.add_argument("--gap", type=float, metavar="SHARE", help="relative gap at which to stop")
    group.add_argument("--method", metavar="NAME", help="highs, paper, enumerate or toulbar2")
    group.add_argument("--threads", type=int, metavar="N", help="accepted; the solver runs one thread")
    group.add_argument("--time-limit", type=float, metavar="SECONDS", help="stop solving with the best layout so far")
    group.add_argument("--memory-limit", type=int, metavar="MIB", help="memory that the solver may plan to use")


_OPTIONS: Mapping[str, tuple[str, str]] = {
    "view": ("candidates", "view"),
    "space": ("candidates", "space"),
    "time": ("read", "time"),
    "gap": ("solve", "gap"),
    "method": ("solve", "method"),
    "threads": ("solve", "threads"),
    "time_limit": ("solve", "time_limit"),
    "memory_limit": ("solve", "memory_limit"),
    "bare": ("output", "bare"),
}


def _settings(arguments: argparse.Namespace) -> Settings:
    """Settings of a command, from the weakest to the strongest source."""
    from usdrigui import settings

    sources: list[Mapping[str, Any]] = []
    configuration = _configuration(arguments)
    if configuration is not None:
        sources.append(settings.read_toml(configuration))
    sources += [_assignment(text) for text in getattr(arguments, "set", [])]
    if getattr(arguments, "pose", None):
        sources.append({"read": {"pose": settings.read_toml(arguments.pose)}})
    for option, (part, key) in _OPTIONS.items():
        value = getattr(arguments, option, None)
        if value is not None and value is not False:
            sources.append({part: {key: value}})
    return settings.load(
        *sources,
        preset=getattr(arguments, "preset", "default"),
        environment=settings.environment_settings(),
    )


def _configuration(arguments: argparse.Namespace) -> Path | None:
    given: Path | None = getattr(arguments, "config", None)
    if given is not None:
        return given
    asset: Path | None = getattr(arguments, "asset", None)
    layer: Path | None = getattr(arguments, "layer", None)
    beside = asset.with_suffix(".rigui.toml") if asset is not None else None
    if asset is None and layer is not None:
        beside = layer.with_suffix(".toml")  # char.rigui.usda → char.rigui.toml
    return beside if beside is not None and beside.is_file() else None


def _assignment(text: str) -> Mapping[str, Any]:
    """``solve.gap=1e-3`` as nested tables; the value is TOML, or else a plain word."""
    key, equals, value = text.partition("=")
    part, dot, name = key.partition(".")
    if not (equals and dot):
        raise refuse("CONFIG_VALUE", "--set", f"expected PART.KEY=VALUE, got {text!r}")
    try:
        return {part: {name: tomllib.loads(f"value = {value}")["value"]}}
    except tomllib.TOMLDecodeError:
        return {part: {name: value}}


# --- outcomes ----------------------------------------------------------------------------------------


class _Interruption:
    """Ctrl-C and SIGTERM: during the search they ask for the best so far; otherwise, or twice, they end the run."""

    def __init__(self) -> None:
        self.patient = False
        self._asked = False
        self._previous: dict[int, Any] = {}

    def requested(self) -> bool:
        return self._asked

    def __enter__(self) -> Self:
        for number in (signal.SIGINT, signal.SIGTERM):
            self._previous[number] = signal.signal(number, self._on_signal)
        return self

    def __exit__(self, *exc: object) -> None:
        for number, handler in self._previous.items():
            signal.signal(number, handler)

    def _on_signal(self, number: int, frame: object) -> None:
        del number, frame
        if self._asked:
            os._exit(int(Exit.LIMIT))
        self._asked = True
        if not self.patient:
            raise refuse("INTERRUPTED", "", "stopped before there was a result")


def _screen(arguments: argparse.Namespace) -> terminal.Screen:
    from usdrigui import terminal

    return terminal.Screen(quiet=arguments.quiet, machine=arguments.json)


def _progress(screen: terminal.Screen, arguments: argparse.Namespace) -> AbstractContextManager[terminal.Watch]:
    if not arguments.openjd:
        return screen.progress()
    from usdrigui.clients import openjd

    return nullcontext(openjd.progress_lines(functools.partial(print, flush=True)))


def _extras(result: report.Report, arguments: argparse.Namespace) -> tuple[str, ...]:
    """Write the report and the picture that were asked for; one line for each."""
    from usdrigui import pipeline, report

    lines = []
    if arguments.report is not None:
        content = report.to_json(result).encode()
        lines.append(f"{pipeline.write_file(content, arguments.report)} {arguments.report}")
    if arguments.preview is not None:
        from usdrigui.view import sheet

        characters = [(each.rig, each.layout) for each in result.characters]
        content = sheet.sheet_png(characters, labels=arguments.labels)
        lines.append(f"{pipeline.write_file(content, arguments.preview)} {arguments.preview}")
    return tuple(lines)


def _prepare_streams(*, machine: bool) -> None:
    """Names can hold any character: JSON is UTF-8 whatever the locale, and text never fails for want of a letter."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace", encoding="utf-8" if machine else None)


def _strict(issues: Sequence[Any], arguments: argparse.Namespace) -> Exit:
    warned = any(found.severity == "warning" for found in issues)
    return Exit.REFUSED if arguments.strict and warned else Exit.OK


def _refused(error: RigUIError, arguments: argparse.Namespace) -> None:
    from usdrigui import report

    asset = str(getattr(arguments, "asset", getattr(arguments, "layer", "")))
    if getattr(arguments, "json", False):
        sys.stdout.write(report.failure_json(asset, error.issue, error.exit_code))
    found = error.issue
    if getattr(arguments, "openjd", False):
        from usdrigui.clients import openjd

        print(*openjd.failure_lines(found), sep="\n", flush=True)
    where = f" {found.path}:" if found.path else ""
    print(visible(f"usdrigui: {found.code}{where} {found.message}"), file=sys.stderr)
    print(f"  repair: {found.repair}", file=sys.stderr)
    done = getattr(arguments, "layer_state", "")
    kept = f"the layout itself is {done}" if done else "nothing was written"
    print(visible(f"usdrigui: refused {asset}; {kept}"), file=sys.stderr)


def _bug(error: Exception, arguments: argparse.Namespace) -> int:
    """An exception that nobody expected is ours: say so in one line, with the place, without a traceback."""
    if os.environ.get("USDRIGUI_TRACEBACK"):
        raise error
    place = error.__traceback__
    while place is not None and place.tb_next is not None:
        place = place.tb_next
    where = f" ({Path(place.tb_frame.f_code.co_filename).name}:{place.tb_lineno})" if place is not None else ""
    _refused(refuse("BUG", "", f"{type(error).__name__}: {error}{where}"), arguments)
    return int(Exit.BUG)


def _say(line: str, arguments: argparse.Namespace) -> None:
    if not arguments.json:
        print(visible(line))
