"""Kill and signal every command at random moments, its worker too: no torn file, no orphan, every exit documented.

    python tests/faults/ends.py --count 500

Prints one JSON document: how often each command ended how, and the faults.
"""

from __future__ import annotations

import argparse
import collections
import contextlib
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))
sys.path.append(str(Path(__file__).parents[1] / "catalogue"))

COMMANDS = {
    "process": "process char.usda -o out.usda --report report.json --preview picture.png",
    "process again": "process char.usda --bare --set objective.overlap_max=1",
    "inspect": "inspect char.usda --json",
    "check": "check char.rigui.usda",
    "diff": "diff char.rigui.usda bare.usda",
    "view": "view char.rigui.usda --html page.html",
    "picture": "picture char.rigui.usda -o picture.png",
    "picker": "picker char.rigui.usda --svg picker.svg",
    "attach": "attach char.usda bare.usda",
    "detach": "detach attached.usda bare.usda",
    "batch": "batch char.usda second.usda --jobs 2 --output-dir many --summary summary.json",
    "openjd": "openjd *.usda -o job.json",
}
WAYS = ("SIGTERM", "SIGINT", "SIGHUP", "SIGKILL", "worker SIGKILL", "worker SIGSEGV")
DOCUMENTED = {0, 1, 2, 3, 4}
VERDICT = re.compile(r"^usdrigui: (?!\w+_\w+|INTERRUPTED|BUG)", re.MULTILINE)
"""A closing line, as opposed to that of its code."""
OURS = re.compile(r'File "[^"]*[/\\]usdrigui[/\\](?!__init__\.py|__main__\.py)|in main$', re.MULTILINE)
"""A line of a traceback that Python prints once the command heeds signals."""


def made(folder: Path) -> Path:
    """A character, its layout, a bare one, and a copy that has it attached."""
    import minimal_assets

    minimal_assets.character(folder)
    run("process char.usda", folder)
    run("process char.usda --bare -o bare.usda", folder)
    for name in ("second.usda", "attached.usda"):
        shutil.copy(folder / "char.usda", folder / name)
    run("attach attached.usda bare.usda", folder)
    return folder


def run(line: str, folder: Path) -> None:
    subprocess.run([sys.executable, "-m", "usdrigui", *line.split()], cwd=folder, check=True, capture_output=True)


def is_hidden(path: Path) -> bool:
    """Whether this is a file of ours that a killed command may leave and the next run removes."""
    return path.name.startswith(".") and any(word in path.name for word in (".rigui-tmp", ".rigui-lock"))


def contents(folder: Path) -> dict[str, bytes]:
    """Every result by its name; a document that holds times counts by its being whole."""
    found = {}
    for path in sorted(each for each in folder.rglob("*") if each.is_file() and not is_hidden(each)):
        content = path.read_bytes()
        timed = path.suffix == ".json" and path.name != "job.json"
        found[path.relative_to(folder).as_posix()] = b"whole" if timed and json.loads(content) else content
    return found


def processes_in(folder: Path) -> list[int]:
    """Processes that work in the folder."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            if (entry / "cwd").readlink() == folder and b" Z " not in (entry / "stat").read_bytes():
                found.append(int(entry.name))
        except OSError:
            continue
    return found


def end(name: str, way: str, wait: float, folder: Path) -> tuple[int, str]:
    """Run the command and end it after a while; its exit code and all that it printed."""
    process = subprocess.Popen(
        [sys.executable, "-m", "usdrigui", *COMMANDS[name].split()],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    time.sleep(wait)
    target = process.pid
    if way.startswith("worker"):
        target = next((each for each in sorted(processes_in(folder)) if each != process.pid), 0)
    if target and process.poll() is None:
        with contextlib.suppress(ProcessLookupError):
            os.kill(target, getattr(signal, way.split()[-1]))
    out, err = process.communicate(timeout=120)
    return process.returncode, out + err


def unborn(code: int, printed: str) -> bool:
    """Whether it ended as any program that Python is still loading: by the signal, or by its traceback."""
    by_signal = code in {-signal.SIGTERM, -signal.SIGHUP, -signal.SIGINT, 130}
    by_python = code == 1 and printed.rstrip().endswith("KeyboardInterrupt")
    return (by_signal or by_python) and not VERDICT.search(printed) and not OURS.search(printed)


def faults_of(way: str, code: int, printed: str, folder: Path, known: dict[str, set[bytes]]) -> list[str]:
    """What is wrong with an end."""
    found, early = [], unborn(code, printed)
    crashed = code == 5 and way == "worker SIGSEGV"
    if not (code in DOCUMENTED or early or crashed or (code == -signal.SIGKILL and way == "SIGKILL")):
        found.append(f"exit {code}")
    if ("Traceback" in printed and not early) or (code in (4, 5) and len(VERDICT.findall(printed)) != 1):
        found.append(f"says {printed[-300:]!r}")
    until = time.monotonic() + 5
    while (left := processes_in(folder)) and time.monotonic() < until:
        time.sleep(0.02)
    if left:
        found.append("orphans")
    try:
        now = contents(folder)
    except ValueError:
        return [*found, "a torn document"]
    found += [f"torn {key}" for key, value in now.items() if value not in known.get(key, set())]
    found += [f"lost {key}" for key, values in known.items() if key not in now and None not in values]
    return found


def main(count: int, seed: int, names: list[str], within: float | None) -> dict[str, object]:
    """Ends, and what became of them; `within` so many seconds of the start, by default of what the command takes."""
    chance, seen, faults = random.Random(seed), collections.Counter[str](), []
    with tempfile.TemporaryDirectory() as place:
        pristine = made(Path(place).resolve())
        folder = pristine.with_name(pristine.name + "-now")
        before, known, usual = contents(pristine), {}, {}
        for name in names:
            shutil.copytree(pristine, folder)
            start = time.monotonic()
            run(COMMANDS[name], folder)
            usual[name] = time.monotonic() - start
            after = contents(folder)
            known[name] = {key: {before.get(key), after.get(key)} for key in {*before, *after}}
            shutil.rmtree(folder)
        for number in range(count):
            name, way = names[number % len(names)], WAYS[number // len(names) % len(WAYS)]
            shutil.copytree(pristine, folder)
            code, printed = end(name, way, chance.uniform(0, within or 1.05 * usual[name]), folder)
            seen[f"{way}: {'before it began' if unborn(code, printed) else f'exit {code}'}"] += 1
            allowed = {key: {value} for key, value in before.items()} if unborn(code, printed) else known[name]
            found = faults_of(way, code, printed, folder, allowed)
            if any(map(is_hidden, folder.rglob("*"))):
                seen["hidden files left, removed by the next run"] += 1
                run(COMMANDS[name], folder)
                found += [f"not swept: {each}" for each in folder.rglob("*") if is_hidden(each)]
            faults += [f"{name}, {way}: {each}" for each in found]
            print(number + 1, name, way, code, *found, file=sys.stderr, flush=True)
            shutil.rmtree(folder)
    return {"ends": count, "seen": dict(sorted(seen.items())), "faults": faults}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", nargs="+", choices=COMMANDS, default=list(COMMANDS))
    parser.add_argument("--within", type=float, help="seconds from the start; by default what the command takes")
    asked = parser.parse_args()
    result = main(asked.count, asked.seed, asked.only, asked.within)
    print(json.dumps(result, indent=2))
    sys.exit(bool(result["faults"]))
