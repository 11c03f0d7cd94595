"""The page's own sources in Node.js and its server, without a browser."""

import json
import shutil
import subprocess
import threading
from contextlib import contextmanager
from pathlib import Path

import pytest

from usdrigui.view.web.serve import page_server


def placed_by_the_page(cases):
    """What the page makes of cases {scene, times}, as placed.mjs says; one process for all."""
    return json.loads(answer("placed.mjs", cases))


def corrections_of_the_page(scene, control, mesh, point):
    """The layer that the page saves when the element of a control was moved to a point, as rearranged.mjs says."""
    return answer("rearranged.mjs", {"scene": scene, "control": control, "mesh": mesh, "point": point})


def answer(script, asked):
    """What a script of tests/clients prints that is given a question as JSON."""
    if shutil.which("node") is None:
        pytest.skip("Node.js is not installed")
    path = Path(__file__).with_name("clients") / script
    done = subprocess.run(
        ["node", str(path)], input=json.dumps(asked), capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@contextmanager
def serving(page, live=None):
    """A server of the page that answers meanwhile."""
    with page_server(page, live=live) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True)
        thread.start()
        yield server
        server.shutdown()
        thread.join()
