"""`view`, `picture` and `picker`: a layout for the eyes; `study`: what the evaluation of one
found."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from usdrigui.cli.options import files_read, settings_of
from usdrigui.cli.outcomes import check_ending, screen_of, wrote
from usdrigui.errors import Exit, refuse
from usdrigui.isolation import worker

if TYPE_CHECKING:
    from usdrigui import pipeline
    from usdrigui.character import Rig
    from usdrigui.model import Layout


def study(arguments: argparse.Namespace) -> Exit:
    """Sum results of `view --study` over participants."""
    from usdrigui.cli.terminal import review_lines
    from usdrigui.clients import study

    found = study.summed(arguments.results)
    screen_of(arguments).show(lambda: study.as_json(found), review_lines.of_study(found))
    return Exit.OK


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


def view(arguments: argparse.Namespace) -> Exit:
    """Pose the character in a browser by its layout."""
    from usdrigui import pipeline
    from usdrigui.view.web import page, serve
    from usdrigui.view.web.live import LiveFile

    more = (*arguments.review, *arguments.targets)
    reviews = [page.read_review(path) for path in more]
    study = arguments.study or bool(arguments.targets)
    poses = "".join(reviews).count("string pose = ")
    if arguments.targets and poses < 13:  # as viewer/src/evaluate.js says
        raise refuse("CONFIG_VALUE", "--targets", f"has {poses} of the 13 poses needed")
    settings = settings_of(arguments)
    loaded = pipeline.load_layer(arguments.layer, settings)
    read = _spared((arguments.html,), loaded, arguments, more)
    name = arguments.layer.name
    if arguments.live and (arguments.html or study):
        raise refuse("CONFIG_VALUE", "--live", "needs the page to be served, and not as a study")
    live = arguments.live and LiveFile(arguments.live, read, settings.read)
    html = page.page_html(
        loaded.characters,
        name,
        study,
        arguments.live.name if live else "",
        reviews,
    )
    if arguments.html:
        state = pipeline.write_file(html.encode(), arguments.html, read)
        return wrote(arguments, {arguments.html: state})
    worker.budget(0.0, settings.run.memory_limit)  # it ends when the user says so
    serve.serve(
        html, open_browser=not arguments.no_browser, announce=worker.print_now, name=name, live=live
    )
    return wrote(arguments, {}, [f"showed {arguments.layer}"])


def picture(arguments: argparse.Namespace) -> Exit:
    """Draw a layout layer, or the character's animation under it."""
    from usdrigui import pipeline
    from usdrigui.view import sheet

    check_ending("--output", arguments.output, ".png", ".gif")
    settings = settings_of(arguments)
    loaded = pipeline.load_layer(arguments.layer, settings)
    read = _spared((arguments.output,), loaded, arguments)
    characters = _visible(loaded.characters, arguments)
    if arguments.output.suffix == ".gif":
        content = sheet.film_gif(characters, frames=arguments.frames)
    else:
        pose = settings.read.pose
        content = sheet.sheet_png(characters, labels=arguments.labels, pose=pose)
    state = pipeline.write_file(content, arguments.output, read)
    return wrote(arguments, {arguments.output: state}, sheet.spelt_out(characters))


def picker(arguments: argparse.Namespace) -> Exit:
    """Export the layout as a flat picker, seen from its view."""
    from usdrigui import pipeline
    from usdrigui.clients import picker
    from usdrigui.view.flat.svg import svg

    if arguments.svg is None and arguments.dwpicker is None:
        raise refuse(
            "CONFIG_VALUE", "picker", "no output is given: --svg FILE, --dwpicker FILE or both"
        )
    loaded = pipeline.load_layer(arguments.layer, settings_of(arguments))
    behind = arguments.dwpicker and arguments.dwpicker.with_suffix(".background.png")
    read = _spared((arguments.svg, arguments.dwpicker, behind), loaded, arguments)
    made = picker.picker(_visible(loaded.characters, arguments), labels=arguments.labels)
    files = {}
    if arguments.svg is not None:
        files[arguments.svg] = svg(made).encode()
    if arguments.dwpicker is not None:
        name = arguments.layer.name.partition(".")[0]
        place = f"$DWPICKER_PROJECT_DIRECTORY/{behind.name}"
        files[behind] = picker.background_png(made)
        files[arguments.dwpicker] = picker.to_dwpicker(made, name, place).encode()
    states = {path: pipeline.write_file(content, path, read) for path, content in files.items()}
    return wrote(arguments, states)
