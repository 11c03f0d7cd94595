"""The Python in which usdrigui runs beside Blender, and the programs that run there in the
background."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import bpy

from .layout import LayoutError

NEEDED = 0.8e9
"""Bytes that an environment takes, with what pip needs on the way."""


class Preferences(bpy.types.AddonPreferences):
    """Where usdrigui runs."""

    bl_idname = __package__

    python: bpy.props.StringProperty(
        name="Python",
        subtype="FILE_PATH",
        description="A Python that has usdrigui; empty for the environment of this extension",
    )
    wheels: bpy.props.StringProperty(
        name="Wheels",
        subtype="DIR_PATH",
        description="A folder of wheels to install from without the network; empty for PyPI",
    )

    def draw(self, _context):
        """The settings, and whether there is an environment."""
        found = interpreter()
        self.layout.prop(self, "python")
        self.layout.prop(self, "wheels")
        self.layout.label(
            text=f"usdrigui runs in {found}" if found else "There is no environment yet",
            icon="CHECKMARK" if found else "INFO",
        )
        self.layout.operator("usdrigui.make_environment", icon="IMPORT")


def preferences():
    """The extension's preferences."""
    return bpy.context.preferences.addons[__package__].preferences


def interpreter():
    """Path of the Python that has usdrigui, or None."""
    named = preferences().python
    path = Path(bpy.path.abspath(named)) if named else _own_python()
    return path if path.is_file() else None


def usdrigui(*arguments):
    """The command line of usdrigui.  Raises LayoutError where there is no environment."""
    python = interpreter()
    if python is None:
        raise LayoutError(
            "usdrigui is not installed yet: press Make Environment in Preferences > Add-ons >"
            " In-situ rig controls, or name a Python that has it there"
        )
    return [python, "-I", "-m", "usdrigui", *arguments]


def need_room(folder, needed, otherwise):
    """Raise LayoutError, with what else helps, unless the disk of a folder has so many bytes
    left."""
    free = shutil.disk_usage(folder).free
    if free < needed:
        raise LayoutError(
            f"{folder} has {free / 1e9:.1f} GB free and {needed / 1e9:.1f} GB are needed: make"
            f" room, or {otherwise}"
        )


def _home():
    if __package__.startswith("bl_ext."):
        folder = Path(bpy.utils.extension_path_user(__package__, create=True))
    else:
        folder = Path(bpy.utils.user_resource("DATAFILES", path="usdrigui", create=True))
    return folder / "environment"


def _own_python():
    return _home() / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def running(commands, said):
    """Run programs one after the other beside Blender; yields each again and again while it runs,
    and ends it when nobody asks any more.

    What they say goes to the file ``said``.  Raises LayoutError where one cannot be started or
    ends badly.
    """
    clean = {name: value for name, value in os.environ.items() if name[:6] != "PYTHON"}
    for command in commands:
        try:
            with said.open("ab") as out:
                process = subprocess.Popen(
                    command,
                    stdin=subprocess.DEVNULL,
                    stdout=out,
                    stderr=subprocess.STDOUT,
                    env=clean,
                )
        except OSError as error:
            raise LayoutError(f"{command[0]} does not run: {error.strerror}") from error
        try:
            while process.poll() is None:
                yield process
        finally:
            process.terminate()
            process.wait()
        if process.returncode:
            raise LayoutError(failure(lines_of(said)))


def lines_of(said):
    """What programs have said so far."""
    return said.read_text("utf-8", "replace").splitlines()


def in_one_line(work):
    """``work(operator, context)`` that reports what is refused in one line, and is cancelled."""

    def guarded(self, context):
        try:
            return work(self, context)
        except (LayoutError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    return guarded


class Background:
    """An operator that runs programs: in the background with a window, at once without.

    Its ``prepare(context)`` gives their command lines, its ``finish()`` takes the result; both may
    raise LayoutError.
    """

    @in_one_line
    def execute(self, context):
        """Start, and come back when it is done; without a window run to the end."""
        self.said = Path(tempfile.mkdtemp(dir=bpy.app.tempdir)) / "said.txt"
        self.running = running(self.prepare(context), self.said)
        if bpy.app.background:
            for process in self.running:
                process.wait()
            self.finish()
            return {"FINISHED"}
        next(self.running, None)
        self.timer = context.window_manager.event_timer_add(0.2, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        """See how far it is; Escape ends it."""
        if event.type not in ("ESC", "TIMER"):
            return {"PASS_THROUGH"}
        result = self._looked(context) if event.type == "TIMER" else {"CANCELLED"}
        if result != {"PASS_THROUGH"}:
            self.running.close()
            context.window_manager.event_timer_remove(self.timer)
            context.workspace.status_text_set(None)
        return result

    @in_one_line
    def _looked(self, context):
        if next(self.running, None):
            said = told(lines_of(self.said))
            context.workspace.status_text_set(f"{self.bl_label}: {said}  (Esc stops)")
            return {"PASS_THROUGH"}
        self.finish()
        return {"FINISHED"}


def told(lines):
    """How far a program is, for people: the last share and the last stage that it named."""
    marks = (line.partition(": ") for line in lines if line.startswith("openjd_"))
    said = {mark: text for mark, _, text in marks}
    if said:
        return f"{said.get('openjd_progress', 0)} %  {said.get('openjd_status', '')}"
    return lines[-1][:80] if lines else "starting"


def failure(lines):
    """The one line that says what went wrong and what to do."""
    for mark in ("openjd_fail:", "usdrigui:", "ERROR:"):
        said = next((line for line in lines if line.startswith(mark)), "")
        if said:
            text = said.partition(":")[2].strip()
            repair = next((line for line in lines if line.strip().startswith("repair:")), "")
            repair = repair.partition(":")[2].strip()
            return text if repair in text else f"{text}. {repair}"
    if lines and lines[-1].endswith("No module named usdrigui"):
        return f"{lines[-1]}: press Make Environment in the preferences, or name another Python"
    return lines[-1] if lines else "the program ended without a word"


class MakeEnvironment(Background, bpy.types.Operator):
    """Install usdrigui in a Python environment beside this extension."""

    bl_idname = "usdrigui.make_environment"
    bl_label = "Make Environment"

    def invoke(self, context, event):
        """Ask first: this uses the network and the disk."""
        return context.window_manager.invoke_confirm(
            self,
            event,
            title="Install usdrigui beside this extension?",
            message=f"Downloads some 150 MB from PyPI, or takes your wheels, into {_home()}",
            confirm_text="Install",
        )

    def prepare(self, _context):
        """The command lines that make the environment, one after the other.

        Raises LayoutError without room for it, or without leave to use the network.
        """
        home = _home()
        wheels = bpy.path.abspath(preferences().wheels)
        need_room(home.parent, NEEDED, "name a Python that has usdrigui")
        if not wheels and not bpy.app.online_access:
            raise LayoutError(
                "Blender may not use the network: allow it in Preferences > System > Network, or"
                " name a folder of wheels"
            )
        offline = ["--no-index", "--find-links", wheels] if wheels else []
        package = next((Path(__file__).parent / "package").glob("usdrigui-*.whl"))
        pip = [_own_python(), "-I", "-m", "pip", "install", "--disable-pip-version-check"]
        return [
            [sys.executable, "-I", "-m", "venv", "--clear", home],
            [*pip, "--progress-bar", "off", *offline, package],
        ]

    def finish(self):
        """It is there."""
        self.report({"INFO"}, f"usdrigui runs in {interpreter()}")
