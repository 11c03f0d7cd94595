"""A real Blender window on a virtual screen, driven by real mouse and key events."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import time
from pathlib import Path

import numpy as np
from PIL import Image, ImageGrab

SIZE = (900, 640)
NEEDS = ("blender", "Xvfb", "xdotool")
LACKING = [name for name in NEEDS if shutil.which(name) is None]


class Window:
    """Blender with a character, and hands to use it."""

    def __init__(self, folder: Path, extension: Path, rig: dict, layout: str) -> None:
        self.folder = folder
        paths = {name: folder / f"{name}.json" for name in ("job", "rig", "layout")}
        paths["rig"].write_text(json.dumps(rig))
        paths["layout"].write_text(layout)
        task = {"extension": str(extension), "result": str(folder / "result"), "rig": str(paths["rig"])}
        paths["job"].write_text(json.dumps({**task, "layout": str(paths["layout"])}))
        geometry = f"{SIZE[0]}x{SIZE[1]}x24"
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", "1", "-screen", "0", geometry],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        self.display = f":{self.server.stdout.readline().strip()}"
        inside = Path(__file__).parent / "blender" / "inside"
        log = (folder / "blender.log").open("w")
        start = ["--factory-startup", "--python-use-system-env", "-p", "0", "0", str(SIZE[0]), str(SIZE[1])]
        self.blender = subprocess.Popen(
            ["blender", *start, "-P", str(inside / "window.py"), "--", str(paths["job"])],
            env={**os.environ, "DISPLAY": self.display, "LIBGL_ALWAYS_SOFTWARE": "1", "PYTHONPATH": str(inside)},
            stdout=log,
            stderr=subprocess.STDOUT,
        )
        try:
            self.await_file("ready", 120)
            self.settle(1.0)
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """End what was started."""
        for process in (self.blender, self.server):
            process.terminate()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()

    def ask(self, code: str):
        """Run code inside Blender; what it leaves in `result`."""
        asked = self.folder / "asked.new"
        asked.write_text(json.dumps(code))
        asked.rename(self.folder / "asked.json")
        told = self.await_file("told.json", 60)
        answer = json.loads(told.read_text())
        told.unlink()
        assert "error" not in answer, answer["error"]
        self.check_log()
        return answer["result"]

    def await_file(self, name: str, seconds: float) -> Path:
        """Wait for a file of Blender's; fails with its log."""
        until = time.monotonic() + seconds
        while not (self.folder / name).exists():
            self.check_log()
            assert time.monotonic() < until, f"no {name} after {seconds} s"
            time.sleep(0.02)
        return self.folder / name

    def check_log(self) -> None:
        """Fail when Blender has ended, or said that something broke."""
        log = (self.folder / "blender.log").read_text()
        assert self.blender.poll() is None, log
        assert "Traceback" not in log, log

    def xdotool(self, *arguments: object) -> None:
        """Real events."""
        environment = {**os.environ, "DISPLAY": self.display}
        subprocess.run(["xdotool", *map(str, arguments)], env=environment, check=True, timeout=30)

    def settle(self, seconds: float = 0.3) -> None:
        """Let Blender work off its events and draw."""
        time.sleep(seconds)
        self.ask("result = None")

    def hover(self, at) -> None:
        """Move the mouse over a place, in two steps as a hand would."""
        self.xdotool("mousemove", round(at[0]) - 3, round(at[1]) - 3)
        self.settle(0.05)
        self.xdotool("mousemove", round(at[0]), round(at[1]))
        self.settle(0.1)

    def drag(self, start, end, steps: int = 3, keys=(), release: bool = True) -> None:
        """Press at a place, move to another, let go."""
        self.hover(start)
        for key in keys:
            self.xdotool("keydown", key)
        self.xdotool("mousedown", 1)
        self.settle(0.1)
        for step in range(1, steps + 1):
            at = np.asarray(start) + (np.asarray(end) - start) * step / steps
            self.xdotool("mousemove", *(round(float(each)) for each in at))
            self.settle(0.05)
        if release:
            self.xdotool("mouseup", 1)
        for key in keys:
            self.xdotool("keyup", key)
        self.settle(0.1)

    def key(self, name: str) -> None:
        """Press a key."""
        self.xdotool("key", name)
        self.settle(0.2)

    def values(self) -> dict[str, float]:
        """Values of all controls."""
        return self.ask("result = character().values()")

    def picture(self, name: str) -> Image.Image:
        """A screenshot, kept where USDRIGUI_PICTURES says."""
        found = ImageGrab.grab(xdisplay=self.display)
        target = os.environ.get("USDRIGUI_PICTURES")
        if target:
            Path(target).mkdir(parents=True, exist_ok=True)
            found.save(Path(target) / f"{name}.png")
        return found


def described(rig, to_world: np.ndarray) -> dict:
    """A rig with one skeleton as JSON for `inside/window.py`."""
    (skeleton,) = rig.body.skeletons
    assert np.allclose(skeleton.to_root, np.eye(4)), "keep to characters whose skeleton stands in the root's space"
    names = [joint.path.rpartition("/")[2] for joint in rig.body.joints]
    joints = [
        {"name": name, "bind": joint.bind.T.tolist(), "parent": names[joint.parent] if joint.parent >= 0 else ""}
        for name, joint in zip(names, rig.body.joints, strict=True)
    ]
    return {
        "to_world": to_world.tolist(),
        "skeleton": {"path": skeleton.path, "joints": joints},
        "meshes": [_described_mesh(rig, mesh, names) for mesh in rig.body.meshes],
    }


def _described_mesh(rig, mesh, names):
    bounds = np.cumsum(mesh.topology.face_counts)[:-1]
    groups = []
    if mesh.skin is not None:
        for j, name in enumerate(names):
            weights = np.where(mesh.skin.joints == j, mesh.skin.weights, 0.0).sum(axis=1)
            points = np.flatnonzero(weights)
            if len(points):
                groups.append([name, points.tolist(), weights[points].tolist()])
    shapes = [
        [rig.body.channels[shape.channel].token, shape.points.tolist(), shape.offsets[-1].astype(float).tolist()]
        for shape in mesh.shapes
    ]
    return {
        "path": mesh.path,
        "name": mesh.path.rpartition("/")[2],
        "points": mesh.points.tolist(),
        "faces": [each.tolist() for each in np.split(mesh.topology.face_indices, bounds)],
        "to_root": (mesh.skin.geom_bind if mesh.skin is not None else mesh.to_root).T.tolist(),
        "shapes": shapes,
        "groups": groups,
    }
