"""`view`, `picture` and `picker`: a layout for the eyes; `study`: what the evaluation of one
found."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from usdrigui import worker
from usdrigui.cli.options import add_configuration, command, files_read, settings_of
from usdrigui.cli.outcomes import say
from usdrigui.errors import Exit, refuse

if TYPE_CHECKING:
    from usdrigui import pipeline
    from usdrigui.model import Layout, Rig
    from usdrigui.view.live import LiveFile


def add_view(commands: Any) -> None:
    """Add ``view`` to the commands."""
    parser = command(commands, "view", _view, "pose the character in a browser by its layout")
    parser.add_argument(
        "layer", type=Path, metavar="LAYER", help="a layer written by `usdrigui process`"
    )
    parser.add_argument(
        "--html",
        type=Path,
        metavar="FILE",
        help="write one self-contained page instead of serving it",
    )
    parser.add_argument(
        "--no-browser", action="store_true", help="serve, but do not open a browser"
    )
    parser.add_argument(
        "--study",
        action="store_true",
        help="offer the evaluation: match target faces with three interfaces",
    )
    parser.add_argument(
        "--live",
        type=Path,
        metavar="USDA",
        help="keep the animation of the page in this layer, which is saved as keys are set",
    )
    parser.add_argument(
        "--review",
        type=Path,
        action="append",
        default=[],
        metavar="USDA",
        help="open the notes of a review that the page saved; may be given again",
    )
    add_configuration(parser)


def add_picture(commands: Any) -> None:
    """Add ``picture`` to the commands."""
    parser = command(
        commands, "picture", _picture, "draw a layout layer, or the character's animation under it"
    )
    parser.add_argument(
        "layer", type=Path, metavar="LAYER", help="a layer written by `usdrigui process`"
    )
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="FILE",
        help="a .png, or an animated .gif",
    )
    parser.add_argument("--labels", action="store_true", help="name the elements")
    parser.add_argument(
        "--pose",
        type=Path,
        metavar="TOML",
        help="the pose of a .png: a file of control = value lines, as `--set read.pose.smile=1`",
    )
    _add_levels(parser)
    parser.add_argument("--frames", type=int, default=24, metavar="N", help="pictures in a .gif")
    add_configuration(parser)


def add_flat_picker(commands: Any) -> None:
    """Add ``picker`` to the commands."""
    parser = command(
        commands, "picker", _flat_picker, "export the layout as a flat picker, seen from its view"
    )
    parser.add_argument(
        "layer", type=Path, metavar="LAYER", help="a layer written by `usdrigui process`"
    )
    parser.add_argument(
        "--svg", type=Path, metavar="FILE", help="write a picture whose groups name their controls"
    )
    parser.add_argument(
        "--labels", action="store_true", help="name the elements on the face in the picture as well"
    )
    _add_levels(parser)
    parser.add_argument("--dwpicker", type=Path, metavar="JSON", help="write a picker for dwpicker")
    add_configuration(parser)


def add_study(commands: Any) -> None:
    """Add ``study`` to the commands."""
    parser = command(
        commands,
        "study",
        _study,
        "sum results of `view --study` over participants, beside the paper's",
    )
    parser.add_argument(
        "results",
        type=Path,
        nargs="+",
        metavar="CSV",
        help="the CSV files that the page saved, one for each participant",
    )


def _study(arguments: argparse.Namespace) -> Exit:
    from usdrigui.clients import study

    found = study.summed(arguments.results)
    sys.stdout.write(study.as_json(found) if arguments.json else study.as_text(found) + "\n")
    return Exit.OK


def _add_levels(parser: Any) -> None:
    """Which level of a layout with two is shown."""
    group = parser.add_argument_group("levels", "for a layout with coarse elements and members")
    group.add_argument(
        "--level",
        type=int,
        choices=(1, 2),
        default=1,
        help="1: coarse elements (default); 2: members",
    )
    group.add_argument(
        "--open",
        action="append",
        default=[],
        metavar="ELEMENT",
        help="this coarse element is opened",
    )


def _visible(
    characters: Sequence[tuple[Rig, Layout]], arguments: argparse.Namespace
) -> list[tuple[Rig, Layout]]:
    """The characters with the elements that the options show."""
    from usdrigui.model import levels

    layouts = [layout for _, layout in characters]
    seen = levels.shown_of_all(layouts, arguments.open, everything=arguments.level == 2)
    return [(rig, layout) for (rig, _), layout in zip(characters, seen, strict=True)]


def _spared(
    outputs: Sequence[Path | None],
    loaded: pipeline.Loaded,
    arguments: argparse.Namespace,
    more: Sequence[Path] = (),
) -> tuple[Path, ...]:
    """Every file that was read; refuses outputs that are one of them before anything is drawn."""
    from usdrigui import pipeline

    read = (*files_read(arguments), *loaded.files, *more)
    pipeline.check_outputs(outputs, read)
    return read


def _view(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.pose import evaluate
    from usdrigui.view import page, serve

    reviews = [page.read_review(path) for path in arguments.review]
    settings = settings_of(arguments)
    loaded = pipeline.load_layer(arguments.layer, settings)
    for rig, layout in loaded.characters:
        evaluate.prepare(rig, layout)  # refuses a layout made for another version of the character
    read = _spared((arguments.html,), loaded, arguments, arguments.review)
    name = Path(arguments.layer).name
    live = _live(arguments, read)
    html = page.page_html(
        loaded.characters,
        name,
        arguments.study,
        arguments.live.name if live else "",
        reviews,
    )
    if arguments.html:
        state = pipeline.write_file(html.encode(), arguments.html, read)
        say(f"usdrigui: {state} {arguments.html}", arguments)
        return Exit.OK
    worker.budget(0.0, settings.run.memory_limit)  # it ends when the user says so
    serve.serve(
        html, open_browser=not arguments.no_browser, announce=worker.print_now, name=name, live=live
    )
    say(f"usdrigui: showed {arguments.layer}", arguments)
    return Exit.OK


def _live(arguments: argparse.Namespace, read: Sequence[Path]) -> LiveFile | None:
    """The file of the live link, if there is to be one."""
    from usdrigui.view.live import LiveFile

    if arguments.live is None:
        return None
    if arguments.html or arguments.study:
        raise refuse("CONFIG_VALUE", "--live", "needs the page to be served, and not as a study")
    return LiveFile(arguments.live, read)


def _picture(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.view import sheet

    if arguments.output.suffix not in (".png", ".gif"):
        raise refuse(
            "CONFIG_VALUE",
            "--output",
            f"a picture ends in .png or .gif, not in {arguments.output.suffix!r}",
        )
    settings = settings_of(arguments)
    loaded = pipeline.load_layer(arguments.layer, settings)
    read = _spared((arguments.output,), loaded, arguments)
    characters = _visible(loaded.characters, arguments)
    if arguments.output.suffix == ".gif":
        content = sheet.film_gif(characters, frames=arguments.frames)
    else:
        pose = settings.rig.read.pose
        content = sheet.sheet_png(characters, labels=arguments.labels, pose=pose)
    state = pipeline.write_file(content, arguments.output, read)
    for line in (f"{state} {arguments.output}", *sheet.spelt_out(characters)):
        say(f"usdrigui: {line}", arguments)
    return Exit.OK


def _flat_picker(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.clients import picker

    if arguments.svg is None and arguments.dwpicker is None:
        raise refuse(
            "CONFIG_VALUE", "picker", "no output is given: --svg FILE, --dwpicker FILE or both"
        )
    loaded = pipeline.load_layer(arguments.layer, settings_of(arguments))
    behind = arguments.dwpicker and arguments.dwpicker.with_suffix(".background.png")
    read = _spared((arguments.svg, arguments.dwpicker, behind), loaded, arguments)
    made = picker.picker(_visible(loaded.characters, arguments), labels=arguments.labels)
    if arguments.svg is not None:
        content = picker.to_svg(made).encode()
        say(f"{pipeline.write_file(content, arguments.svg, read)} {arguments.svg}", arguments)
    if arguments.dwpicker is not None:
        name = arguments.layer.name.partition(".")[0]
        place = f"$DWPICKER_PROJECT_DIRECTORY/{behind.name}"
        content = picker.to_dwpicker(made, name, place).encode()
        say(f"{pipeline.write_file(picker.background_png(made), behind, read)} {behind}", arguments)
        say(
            f"{pipeline.write_file(content, arguments.dwpicker, read)} {arguments.dwpicker}",
            arguments,
        )
    say(f"usdrigui: picker of {arguments.layer}: {len(made.spots)} elements", arguments)
    return Exit.OK
