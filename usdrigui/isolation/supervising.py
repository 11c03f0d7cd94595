"""Commands run in a worker: a process that may crash, hang, be killed or take too much, and what
that means.

`supervise` starts `usdrigui.cli.working` on a command line, passes on what it prints, asks it to
stop or ends it, and returns its closing message or the reason why there is none.  The command line
does so for the user, a batch for each of its assets.  Nothing here imports more than the standard
library, so that nothing here can die of an asset.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import shutil
import subprocess
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from queue import Empty, SimpleQueue
from typing import IO, Any

from usdrigui.errors import RigUIError, refuse
from usdrigui.isolation.forking import FORKS, Child, fresh, warm_parent
from usdrigui.isolation.process import (
    Drain,
    ProcessEnd,
    addresses_allowed,
    kill,
    not_started,
    signal_name,
    signals_later,
)

Events = SimpleQueue[Any]
"""What a supervisor waits for: STOP, an error for which the worker is to be ended, messages of its
worker (mappings), None for its end."""
STOP = "stop"
"""Ask the worker to end with what it has, at once where it has nothing."""

_WORKER = "usdrigui.cli.working"
_PATIENCE = 3.0
"""Seconds in which a worker that was asked to stop must have ended, unless it searches or
writes."""
_LAST_WORDS = 2.0
"""Seconds in which the messages of a worker that was ended must have come."""
_LEAST_ADDRESSES = 3 << 29
"""Bytes below which OpenBLAS waits for ever for what it is not given, or crashes."""
_LAST = 60.0
"""Seconds in which one that searches or writes must have ended after its time was up, and in which
one must have been forked."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a command ended."""

    code: int
    """Exit code."""
    out: str = ""
    """What belongs on standard output, all of it unless something was printed before."""
    err: str = ""
    """The closing line, where it belongs on standard error."""
    death: RigUIError | None = None
    """Why there is no closing line of the worker's own."""
    written: tuple[str, ...] = ()
    """Files that were put in place."""
    unknown: tuple[str, ...] = ()
    """Files that were being put in place when the worker ended: each as it was before, or
    complete."""


def supervise(
    arguments: Sequence[str],
    show: Callable[[str, str], None],
    events: Events | None = None,
    *,
    terminals: tuple[bool, bool] = (False, False),
    alone: bool = False,
) -> Outcome:
    """Run a command in a worker until it ends.

    Parameters: `show` is given what is printed before the end, as (``out`` or ``err``, text);
    `events` is where STOP and errors come from; `terminals` holds whether standard output and
    error are terminals; `alone` gives the worker a session of its own, which ends with it, where it
    would else be stopped and continued with this process by the terminal.
    """
    events = SimpleQueue() if events is None else events
    allowed = addresses_allowed()
    if allowed < _LEAST_ADDRESSES:
        what = f"the system allows {allowed / (1 << 20):.0f} MiB of addresses (ulimit -v)"
        return _dead(refuse("RUN_MEMORY_LIMIT", "", f"{what}; it needs {_LEAST_ADDRESSES >> 20}"))
    process = None
    try:
        with signals_later():
            process = _started(terminals, alone)
        _greet(process, arguments, terminals)
        printed = Drain(process.stderr)
        threading.Thread(target=_collect, args=(process.stdout, events), daemon=True).start()
        watch = _Supervision(process, show)
        watch.until_it_has_ended(events)
    except (OSError, TypeError, ValueError, RuntimeError) as error:  # the last for want of a thread
        return _dead(not_started(error, "WORKER_LOST", "", "the working process"))
    finally:
        if process is not None:
            code, peak = process.end()
            assert process.stdin is not None
            with contextlib.suppress(OSError):
                process.stdin.close()
    printed.close()
    return watch.outcome(ProcessEnd(code, peak, bytes(printed.content)))


def _started(terminals: tuple[bool, bool], alone: bool) -> Child:
    """A worker that waits for its greeting."""
    if alone and FORKS:
        given, hears = os.pipe()
        requests = os.fdopen(hears, "wb")
        with os.fdopen(given):
            return warm_parent((_WORKER, "warm")).forked(given, _LAST, requests)
    size = shutil.get_terminal_size()
    shape = {"COLUMNS": str(size.columns), "LINES": str(size.lines)} if any(terminals) else {}
    return fresh((_WORKER,), subprocess.PIPE, alone=alone, **shape)


def _greet(process: Child, arguments: Sequence[str], terminals: tuple[bool, bool]) -> None:
    """Tell a worker what it needs to know."""
    parent = process.parent.process.pid if process.parent is not None else os.getpid()
    out, err = terminals
    greeting = {"parent": parent, "out": out, "err": err, "arguments": arguments}
    process.say(json.dumps(greeting).encode() + b"\n")


def _collect(messages: IO[bytes], events: Events) -> None:
    """Hand over the messages of a worker until it has ended; a last one that was cut off is
    none."""
    for line in messages:
        with contextlib.suppress(ValueError):
            events.put(json.loads(line))
    events.put(None)


@dataclass
class _Supervision:
    """What a supervisor knows of its worker."""

    process: Child
    show: Callable[[str, str], None]
    start: float = field(default_factory=time.monotonic)
    ended: bool = False
    base: int = 0
    """MiB resident when the budget began."""
    memory: int = 0
    """MiB; 0 until the settings are known."""
    deadline: float = 0.0
    """When the run's own time is up; 0 for never."""
    kill_at: float = 0.0
    gone_by: float = 0.0
    """When a worker that was ended is waited for no longer: something that it started may hold its
    pipe."""
    patient: bool = False
    writing: tuple[str, ...] = ()
    written: list[str] = field(default_factory=list)
    death: RigUIError | None = None
    closing: dict[str, Any] | None = None

    def until_it_has_ended(self, events: Events) -> None:
        """Take note of all that happens."""
        while not self.ended:
            try:
                self._handle(events.get(timeout=self._remaining()))
            except Empty:
                self._time_passed()

    def _remaining(self) -> float | None:
        """Seconds until something must happen; None for never."""
        ends = [each for each in (self.deadline, self.kill_at, self.gone_by) if each]
        return max(0.0, min(ends) - time.monotonic()) if ends else None

    def _time_passed(self) -> None:
        """Something's time is up."""
        now = time.monotonic()
        if self.gone_by:
            self.ended |= now >= self.gone_by
        elif self.kill_at and now >= self.kill_at:
            self._end(self.death or interrupted())
        elif self.deadline and now >= self.deadline:
            self._out_of_time()

    def _out_of_time(self) -> None:
        seconds = self.deadline - self.start
        self.deadline = 0.0
        self.death = refuse("RUN_TIME_LIMIT", "", f"was not done within {seconds:g} s")
        if self.patient or self.writing:
            self._ask(_LAST)
        else:
            self._end()

    def _handle(self, event: Any) -> None:
        """Take note of an event."""
        if event is None:
            self.ended = True
        elif isinstance(event, RigUIError):
            self._end(event)
        elif event == STOP:
            self._stop()
        else:
            getattr(self, f"_on_{event['what']}")(event)

    def _stop(self) -> None:
        """The first request asks, a second one ends."""
        if self.death is not None:
            self._end(interrupted())
            return
        self.death = interrupted()
        self._ask(0.0 if self.patient or self.writing else _PATIENCE)

    def _ask(self, seconds: float) -> None:
        """Ask the worker to end, within `seconds` if they are not 0."""
        self.kill_at = time.monotonic() + seconds if seconds else 0.0
        self.process.say(b"s")

    def _end(self, why: RigUIError | None = None) -> None:
        self.death = why or self.death
        self.deadline = self.kill_at = 0.0
        self.gone_by = time.monotonic() + _LAST_WORDS
        kill(self.process.process, group=self.process.leads)

    def _on_print(self, message: dict[str, Any]) -> None:
        self.show(message["stream"], message["text"])

    def _on_budget(self, message: dict[str, Any]) -> None:
        self.memory, self.base = message["memory"], message["base"]
        self.deadline = self.start + message["seconds"] if message["seconds"] else 0.0

    def _on_patient(self, message: dict[str, Any]) -> None:
        self.patient = message["patient"]
        self._give_time()

    def _on_writing(self, message: dict[str, Any]) -> None:
        self.writing = tuple(message["paths"])
        self._give_time()

    def _give_time(self) -> None:
        """A search or a write that has begun when the request to stop came is finished."""
        if (
            (self.patient or self.writing)
            and self.death is not None
            and self.death.issue.code == "INTERRUPTED"
        ):
            self.kill_at = 0.0

    def _on_wrote(self, message: dict[str, Any]) -> None:
        self.writing = ()
        self.written += [each for each in message["paths"] if each not in self.written]

    def _on_end(self, message: dict[str, Any]) -> None:
        self.closing = message

    def outcome(self, end: ProcessEnd) -> Outcome:
        """What became of the command, from the closing message or from the worker's end."""
        if self.closing is not None:
            return Outcome(
                self.closing["code"],
                self.closing["out"],
                self.closing["err"],
                written=tuple(self.written),
            )
        used = ProcessEnd(end.code, max(0, end.peak - self.base), end.text)
        return _dead(self._cause(used), self)

    def _cause(self, end: ProcessEnd) -> RigUIError:
        if self.death is not None:
            return self.death
        if end.starved(self.memory):
            return refuse(
                "RUN_MEMORY_LIMIT",
                "",
                f"needs more than {self.memory} MiB" if self.memory else "no memory",
            )
        if end.was_killed_by("SIGKILL"):
            return refuse("WORKER_LOST", "", "the working process was killed from outside")
        if end.code < 0 and addresses_allowed() < math.inf:
            what = (
                f"the working process crashed ({signal_name(-end.code)}) under a limit on addresses"
            )
            return refuse("RUN_MEMORY_LIMIT", "", f"{what} (ulimit -v)")
        what = f"ended with code {end.code}: {end.last_line}"
        if end.code < 0:
            what = f"crashed ({signal_name(-end.code)})"
        return refuse("WORKER_CRASHED", "", f"the working process {what}")


def interrupted() -> RigUIError:
    """What a command is that was stopped."""
    return refuse("INTERRUPTED", "", "stopped before there was a result")


def _dead(death: RigUIError, watch: _Supervision | None = None) -> Outcome:
    written, unknown = (tuple(watch.written), watch.writing) if watch is not None else ((), ())
    return Outcome(int(death.exit_code), death=death, written=written, unknown=unknown)
