"""The Python interface for people: scripts, notebooks, and the Python of an application that has
the stage open.

Everything takes a path, as text or not, a `Usd.Stage` or an `Sdf.Layer`.  Files are read in a
process that may be lost; what is open already is read as it is, unsaved edits and all, and nothing
of it is written or changed.
"""

from __future__ import annotations

import base64
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from usdrigui import pipeline
from usdrigui.character import Control, Rig
from usdrigui.errors import meant, refuse
from usdrigui.model import Element, Layout
from usdrigui.pipeline import LayerDifference, LayerReview, Loaded, ProgressCallback
from usdrigui.pipeline.reference_layouts import ReferenceLayers
from usdrigui.pose.evaluate import PosedLayout, evaluate, prepare, values_of
from usdrigui.report.inspection import Inspection
from usdrigui.report.markup import markup
from usdrigui.report.run_report import Report
from usdrigui.settings import Settings
from usdrigui.settings.loading import load_beside

if TYPE_CHECKING:
    from pxr import Sdf, Usd

File: TypeAlias = "str | Path"
Source: TypeAlias = "str | Path | Usd.Stage | Sdf.Layer"


def process(
    asset: Source,
    settings: Settings | None = None,
    *,
    output: File | None = None,
    dry_run: bool = False,
    previous: File | None = None,
    fixed: File | None = None,
    like: File | None = None,
    base: File | None = None,
    corrections: Sequence[File] = (),
    animations: Sequence[File] = (),
    progress: ProgressCallback | None = None,
    stop: Callable[[], bool] | None = None,
) -> Report:
    """Lay out every character of an asset.

    Of a file the layer is written to `output`, by default ``CHAR.rigui.usda`` beside it.  Of an
    open stage or layer nothing is written: `Report.layer` is an anonymous `Sdf.Layer`, for its
    sublayers or its session layer.

    `settings`: by default those of the environment and of ``CHAR.rigui.toml`` beside the file.
    `previous`, `fixed`, `like`, `base`, `corrections` and `animations` are the options of the
    command, for files.
    `progress` is called with an `Event` when a stage begins (``seconds`` is None), when it has
    ended (``seconds`` is what it took), and now and then while it searches (``detail`` holds cost,
    bound and gap, after the name of the part that the stage is about); `stop` is polled meanwhile,
    and once it is true the best layout so far is taken.
    Raises `RigUIError`; then nothing has been written.
    """
    _check_kind(asset)
    if not isinstance(asset, (str, Path)):
        files = (output, previous, fixed, like, base, *corrections, *animations)
        if any(files) or dry_run:
            raise refuse(
                "CONFIG_VALUE",
                "process",
                "an open stage is laid out in memory: it takes settings alone",
            )
        return pipeline.process_stage(asset, _settings(settings), progress=progress, stop=stop)
    path = Path(asset)
    references = ReferenceLayers(
        fixed=_path(fixed),
        previous=_path(previous),
        like=_path(like),
        base=_path(base),
        corrections=tuple(map(Path, corrections)),
        animations=tuple(map(Path, animations)),
    )
    return pipeline.process(
        path,
        _settings(settings, path),
        output=_path(output),
        dry_run=dry_run,
        progress=progress,
        stop=stop,
        references=references,
    )


def inspect(
    asset: File, settings: Settings | None = None, *, animations: Sequence[File] = ()
) -> Inspection:
    """What the stages before the search find out about an asset; writes nothing.  Raises
    `RigUIError`."""
    path = Path(asset)
    return pipeline.inspect(path, _settings(settings, path), animations=[*map(Path, animations)])


def check(
    layout: Source, settings: Settings | None = None, *, progress: ProgressCallback | None = None
) -> LayerReview:
    """Whether the layouts of a stage still fit their characters, and how good they are.  Raises
    `RigUIError`."""
    if isinstance(layout, (str, Path)):
        path = Path(layout)
        return pipeline.check(path, _settings(settings, path), progress=progress)
    return open(layout, settings).check(progress=progress)


def diff(before: File, after: File, settings: Settings | None = None) -> LayerDifference:
    """What changed between two layout layers, character by character.  Raises `RigUIError`."""
    return pipeline.diff(Path(before), Path(after), _settings(settings))


def bake(stage: Usd.Stage, settings: Settings | None = None) -> Sdf.Layer:
    """What the keyed values of an open stage's controls make of its SkelAnimations, as an anonymous
    layer for the front of its sublayers; of a file the command writes it.  Raises `RigUIError`."""
    from usdrigui.layer.baking import bake as bake_values

    return bake_values(stage, _settings(settings).read)


# The name is what people expect: usdrigui.open().
def open(layout: Source, settings: Settings | None = None) -> OpenLayout:  # noqa: A001
    """The layouts of a file, an open stage or a layer, with their characters as it composes them.

    `settings`: by default those of the environment and of the configuration beside the file.
    Raises `RigUIError`.
    """
    _check_kind(layout)
    if isinstance(layout, (str, Path)):
        path = Path(layout)
        settings = _settings(settings, path)
        return OpenLayout(path.name, pipeline.load_layer(path, settings), settings)
    settings = _settings(settings)
    root = layout.GetRootLayer() if hasattr(layout, "GetRootLayer") else layout
    return OpenLayout(root.GetDisplayName(), pipeline.open_layouts(layout, settings), settings)


def _check_kind(source: Source) -> None:
    """Raise TypeError for what is neither a path nor a stage nor a layer."""
    if isinstance(source, (str, Path)):
        return
    from pxr import Sdf, Usd

    if not isinstance(source, (Usd.Stage, Sdf.Layer)):
        kind = type(source).__name__
        raise TypeError(f"expected a path, a Usd.Stage or an Sdf.Layer, not {kind}")


def _settings(given: Settings | None, beside: Path | None = None) -> Settings:
    """The settings that are given, or else those of the configuration beside a file; raises
    TypeError for tables of settings."""
    if given is None:
        return Settings() if beside is None else load_beside(beside)
    if not isinstance(given, Settings):
        kind = type(given).__name__
        raise TypeError(f"expected usdrigui.load_settings(...) as settings, not {kind}")
    return given


def _path(file: File | None) -> Path | None:
    return None if file is None else Path(file)


@dataclass(frozen=True)
class Image:
    """A picture, which notebooks show."""

    png: bytes

    def save(self, path: File) -> None:
        """Write it to a ``.png``, all or nothing.  Raises `RigUIError` with a FILE_ code."""
        pipeline.write_file(self.png, Path(path), ())

    def __repr__(self) -> str:
        return f"<Image of {len(self.png)} bytes>"

    def _repr_png_(self) -> bytes:
        return self.png


@dataclass(frozen=True)
class Page:
    """The viewer as one page, which notebooks show."""

    html: str

    def save(self, path: File) -> None:
        """Write it, all or nothing.  Raises `RigUIError` with a FILE_ code."""
        pipeline.write_file(self.html.encode(), Path(path), ())

    def show(self) -> None:
        """Serve it on this machine and open a browser; returns when it is interrupted."""
        from usdrigui.view.web.serve import serve

        serve(self.html)

    def __repr__(self) -> str:
        return f"<Page of {len(self.html)} characters>"

    def _repr_html_(self) -> str:
        address = base64.b64encode(self.html.encode()).decode()
        return f'<iframe src="data:text/html;base64,{address}" width="100%" height="640"></iframe>'


@dataclass(frozen=True, repr=False)
class OpenLayout:
    """Layouts and their characters, ready to be posed, seen and checked."""

    name: str
    loaded: Loaded
    settings: Settings

    @property
    def characters(self) -> tuple[tuple[Rig, Layout], ...]:
        """Every character with its layout."""
        return self.loaded.characters

    @property
    def controls(self) -> tuple[Control, ...]:
        """Every control of every character, laid out or not."""
        return tuple(control for rig, _ in self.characters for control in rig.controls)

    @property
    def elements(self) -> tuple[Element, ...]:
        """Every element of every layout."""
        return tuple(element for _, layout in self.characters for element in layout.elements)

    def pose(self, values: Mapping[str, float], root: str = "") -> PosedLayout:
        """One character at a pose: points (n, 3) of its meshes and its elements there, in the space
        of its SkelRoot.

        `values` by control name, the others at the base pose; `root` names the SkelRoot where there
        are several. Raises `RigUIError` POSE_CONTROL, POSE_VALUE, SKELROOT_UNKNOWN.
        """
        if not isinstance(values, Mapping):
            kind = type(values).__name__
            raise TypeError(f"expected a mapping of control names to values, not {kind}")
        rig, layout = self._character(root)
        return evaluate(prepare(rig, layout), values_of(rig, values, layout.base_values))

    def picture(self, *, labels: bool = False, pose: Mapping[str, float] | None = None) -> Image:
        """What `usdrigui picture` draws; `pose` as of `pose`, for all characters that have its
        controls."""
        from usdrigui.model.levels import shown
        from usdrigui.view.sheet import sheet_png

        characters = [(rig, shown(layout)) for rig, layout in self.characters]
        return Image(sheet_png(characters, labels=labels, pose=pose))

    def view(self) -> Page:
        """The page that `usdrigui view` shows."""
        from usdrigui.view.web.page import page_html

        return Page(page_html(self.characters, title=self.name))

    def check(self, *, progress: ProgressCallback | None = None) -> LayerReview:
        """Whether the layouts fit their characters as these were read, and how good they are."""
        return pipeline.review(self.name, self.loaded, self.settings, progress=progress)

    def _character(self, root: str) -> tuple[Rig, Layout]:
        found = [each for each in self.characters if not root or each[0].path == root]
        if len(found) != 1:
            known = [rig.path for rig, _ in self.characters]
            what = f"name one of the characters: {', '.join(known)}{meant(root, known)}"
            raise refuse("SKELROOT_UNKNOWN", root, what)
        return found[0]

    def __repr__(self) -> str:
        counts = (f"{rig.path}: {len(layout.elements)} elements" for rig, layout in self.characters)
        return f"<OpenLayout {self.name}: {'; '.join(counts)}>"

    def _repr_html_(self) -> str:
        picture = base64.b64encode(self.picture().png).decode()
        return f'<p>{markup(repr(self)[1:-1])}</p><img src="data:image/png;base64,{picture}">'
