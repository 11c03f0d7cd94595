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
    asked = json.dumps(asked)
    done = subprocess.run(node(script), input=asked, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def node(script):
    if shutil.which("node") is None:
        pytest.skip("Node.js is not installed")
    return ["node", str(Path(__file__).with_name("clients") / script)]


@contextmanager
def conversation(script):
    """A function that tells a script of tests/clients a line of JSON and returns the line that it answers."""
    with subprocess.Popen(node(script), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:

        def told(asked):
            process.stdin.write(json.dumps(asked) + "\n")
            process.stdin.flush()
            return json.loads(process.stdout.readline())

        yield told
        process.stdin.close()


@contextmanager
def serving(page, live=None):
    """A server of the page that answers meanwhile."""
    with page_server(page, live=live) as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True)
        thread.start()
        yield server
        server.shutdown()
        thread.join()
