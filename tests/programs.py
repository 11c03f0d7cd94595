"""Runs of Python in a process of its own, so that one that dies takes no test along."""

import json
import subprocess
import sys


def ran(*arguments, timeout=120, **options):
    """A run that has ended, with what it printed; `options` are those of subprocess.run."""
    command = [sys.executable, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=timeout, check=False, **options)


def figures(*command):
    """What a campaign prints."""
    done = ran("-W", "error::RuntimeWarning", *command, timeout=900)
    assert done.stdout, f"the process under test died ({done.returncode}): {done.stderr[-2000:]}"
    return json.loads(done.stdout)
