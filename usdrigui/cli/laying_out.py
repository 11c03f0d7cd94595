"""`process` and `inspect`: from a character to its layout layer."""

from __future__ import annotations

import argparse
import functools
import sys
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any

from usdrigui import worker
from usdrigui.cli.options import add_each_variant, add_settings, command, files_read, settings_of
from usdrigui.cli.outcomes import screen_of, strict
from usdrigui.errors import Exit, refuse

if TYPE_CHECKING:
    from usdrigui.cli import terminal
    from usdrigui.replacing.transaction import Transaction
    from usdrigui.report import run_report


def add_process(commands: Any) -> None:
    """Add ``process`` to the commands."""
    parser = command(
        commands, "process", _process, "lay out a character and write the layer beside it"
    )
    parser.add_argument("asset", type=Path, metavar="CHAR", help=".usd, .usda, .usdc or .usdz")
    parser.add_argument(
        "-o", "--output", type=Path, metavar="LAYER", help="default: CHAR.rigui.usda beside CHAR"
    )
    parser.add_argument("--dry-run", action="store_true", help="run all stages, write no file")
    parser.add_argument(
        "-v",
        "--verbose",
        action="store_true",
        help="print the place of every control and the reason",
    )
    add_each_variant(parser, "lay out every variant of this set, each in its variant")
    parser.add_argument(
        "--fixed", type=Path, metavar="LAYER", help="keep this layout's anchors and groups exactly"
    )
    parser.add_argument(
        "--previous",
        type=Path,
        metavar="LAYER",
        help="keep this layout's places unless moving pays",
    )
    parser.add_argument(
        "--like", type=Path, metavar="LAYER", help="another character's layout, to be imitated"
    )
    parser.add_argument(
        "--base",
        type=Path,
        metavar="LAYER",
        help="the asset's layout: place only the controls that the shot adds",
    )
    _add_animation(parser, "controls that these animations use often weigh more")
    parser.add_argument(
        "--report", type=Path, metavar="JSON", help="write the JSON report of the run"
    )
    parser.add_argument("--preview", type=Path, metavar="PNG", help="write a picture of the layout")
    parser.add_argument("--labels", action="store_true", help="name the elements in the picture")
    parser.add_argument(
        "--bare", action="store_true", help="leave CHAR out of the layer's sublayers"
    )
    parser.add_argument(
        "--openjd", action="store_true", help="print progress as Open Job Description asks for it"
    )
    add_settings(parser)


def add_inspect(commands: Any) -> None:
    """Add ``inspect`` to the commands."""
    parser = command(commands, "inspect", _inspect, "list the controls without solving")
    parser.set_defaults(written="")  # it only reads, whatever comes of it
    parser.add_argument("asset", type=Path, metavar="CHAR", help=".usd, .usda, .usdc or .usdz")
    _add_animation(
        parser, "list how much these use each control, and which controls they move together"
    )
    parser.add_argument(
        "--like",
        type=Path,
        metavar="LAYER",
        help="match the controls of another character's layout",
    )
    add_settings(parser)


def _add_animation(parser: Any, summary: str) -> None:
    help_text = f"{summary}: files with SkelAnimations, CHAR itself among them"
    parser.add_argument(
        "--animation",
        type=Path,
        nargs="+",
        action="extend",
        default=[],
        metavar="CLIP",
        help=help_text,
    )


def _process(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.pipeline.references import ReferenceLayers

    settings = settings_of(arguments)
    references = ReferenceLayers(
        fixed=arguments.fixed,
        previous=arguments.previous,
        like=arguments.like,
        animations=tuple(arguments.animation),
        base=arguments.base,
    )
    # Before the work, not after.
    pipeline.check_outputs((arguments.report, arguments.preview), files_read(arguments))
    if arguments.preview is not None and arguments.preview.suffix.lower() != ".png":
        raise refuse(
            "CONFIG_VALUE",
            "--preview",
            f"a picture ends in .png, not in {arguments.preview.suffix!r}",
        )
    screen = screen_of(arguments)
    written: list[str] = []
    with _progress(screen, arguments) as shown:

        def watch(event: pipeline.Event) -> None:
            worker.be_patient(event.can_stop)
            shown(event)

        result = pipeline.process(
            arguments.asset,
            settings,
            output=arguments.output,
            dry_run=arguments.dry_run,
            progress=watch,
            stop=worker.stop_requested,
            references=references,
            read=files_read(arguments),
            extras=functools.partial(_stage_extras, arguments, written),
        )
        arguments.written = f"the layout itself is {result.outcome} {result.output}".rstrip()
    if arguments.json:
        from usdrigui.report import run_report

        sys.stdout.write(run_report.to_json(result))
    else:
        screen.report(result, written)
    return strict(result.issues, arguments)


def _inspect(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.report import inspection

    settings = settings_of(arguments)
    screen = screen_of(arguments)
    with screen.progress() as shown:
        clips, like = arguments.animation, arguments.like
        found = pipeline.inspect(
            arguments.asset, settings, progress=shown, animations=clips, like=like
        )
    if arguments.json:
        sys.stdout.write(inspection.to_json(found))
    else:
        screen.inspection(found)
    return strict(found.issues, arguments)


def _progress(
    screen: terminal.Screen, arguments: argparse.Namespace
) -> AbstractContextManager[terminal.ProgressCallback]:
    if not arguments.openjd:
        return screen.progress()
    from usdrigui.clients import openjd

    return nullcontext(openjd.progress_lines(worker.print_now))


def _stage_extras(
    arguments: argparse.Namespace, written: list[str], result: run_report.Report, files: Transaction
) -> None:
    """Stage the report and the picture that were asked for with the layer; one line in `written`
    for each."""
    from usdrigui import pipeline
    from usdrigui.model import levels
    from usdrigui.report import run_report

    if arguments.report is not None:
        content = run_report.to_json(result).encode()
        written.append(
            f"{pipeline.stage_file(files, content, arguments.report)} {arguments.report}"
        )
    if arguments.preview is not None:
        from usdrigui.view import sheet

        characters = [(each.rig, levels.shown(each.layout)) for each in result.characters]
        content = sheet.sheet_png(characters, labels=arguments.labels)
        written.append(
            f"{pipeline.stage_file(files, content, arguments.preview)} {arguments.preview}"
        )
        written += sheet.spelt_out(characters)
