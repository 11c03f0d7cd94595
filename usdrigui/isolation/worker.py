"""A working process's side of `usdrigui.isolation.supervising`: its messages to its
supervisor, and how it is asked to stop.

Messages go to its standard output, one JSON document a line; what it prints is such a
message, too, and its last line, the closing line, comes with the message that closes.  One byte
on its standard input asks it to stop, and the end of that input means that its supervisor is gone.
In a process that has no supervisor, as a host's that uses the Python API, nothing here does
anything.
"""

from __future__ import annotations

import _thread
import contextlib
import io
import json
import os
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from typing import Any, NoReturn

from usdrigui.errors import Exit
from usdrigui.isolation.confinement import bind_to, limit_memory
from usdrigui.isolation.process import resident

_AGAIN = 0.05
"""Seconds until an interruption that Python has dropped comes again."""
_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]

_worker: _Worker | None = None


def start() -> list[str]:
    """Make this process a worker: bound to its supervisor, its streams messages, its signals the
    supervisor's; the command line that it is asked for."""
    global _worker
    greeting = json.loads(_line(0))
    bind_to(greeting["parent"])
    _worker = _Worker(os.dup(0), os.dup(1))
    os.dup2(2, 1)  # what libraries print is kept for the case that they crash
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    sys.stdout = _Stream("out", greeting["out"], kept=True)
    sys.stderr = _Stream("err", greeting["err"], kept=False)
    for number in _SIGNALS:
        signal.signal(number, _worker.on_signal)
    sys.unraisablehook = _worker.on_unraisable
    threading.Thread(target=_worker.listen, daemon=True).start()
    arguments: list[str] = greeting["arguments"]
    return arguments


def resign() -> None:
    """Be no worker any more: this process is one that was forked from it."""
    global _worker
    _worker = None
    sys.unraisablehook = sys.__unraisablehook__
    for number in _SIGNALS:
        signal.signal(number, signal.SIG_DFL)


def active() -> bool:
    """Whether this process has a supervisor, which decides what its death means."""
    return _worker is not None


def budget(seconds: float, memory: int) -> None:
    """What the run may take: wall clock since its start, 0 for no limit, and MiB of private
    memory."""
    if _worker is not None:
        _worker.tell(what="budget", seconds=seconds, memory=memory, base=resident())
        limit_memory(memory)


@contextlib.contextmanager
def committing(paths: Sequence[str]) -> Iterator[None]:
    """Files are put in place meanwhile, which nobody may interrupt; the supervisor knows what was
    written."""
    if _worker is None or not paths:
        yield
        return
    before, _worker.patient = _worker.patient, True
    _worker.tell(what="writing", paths=paths)
    written: Sequence[str] = ()
    try:
        yield
        written = paths
    finally:
        _worker.tell(what="wrote", paths=written)
        _worker.patient = before


def be_patient(patient: bool) -> None:
    """Whether a request to stop is looked for (`stop_requested`), so that it must not break into
    the work."""
    if _worker is not None and patient != _worker.patient:
        _worker.patient = patient
        _worker.tell(what="patient", patient=patient)


def stop_requested() -> bool:
    """Whether the run is to end with what it has."""
    return _worker is not None and _worker.asked


def interrupted() -> bool:
    """Whether a request to stop has broken into the work; what fails after that fails of it."""
    return _worker is not None and _worker.interrupted


def print_now(text: str) -> None:
    """Print a line of the result that cannot wait for the end, as progress that a farm reads."""
    sys.stdout.write(f"{text}\n")
    if isinstance(sys.stdout, _Stream):
        sys.stdout.release()
    else:
        sys.stdout.flush()


def discard_result() -> None:
    """Drop what was written of the result and has not been printed yet."""
    if isinstance(sys.stdout, _Stream):
        sys.stdout.taken()


def hold_errors() -> None:
    """What is printed on standard error from now on is the closing line: it comes with the closing
    message."""
    if isinstance(sys.stderr, _Stream):
        sys.stderr.kept = True


def finish(code: int) -> NoReturn:
    """Send the closing line and leave, without the interpreter's farewell, which may crash on what
    was read."""
    assert _worker is not None
    out, err = (
        stream.taken() if isinstance(stream, _Stream) else "" for stream in (sys.stdout, sys.stderr)
    )
    _worker.tell(what="end", code=code, out=out, err=err)
    os._exit(0)


class _Worker:
    """The two pipes, and what has been asked."""

    def __init__(self, requests: int, messages: int) -> None:
        self.asked = False
        self.patient = False
        self.interrupted = False
        self._heard = False
        self._telling = False
        self._requests, self._messages = requests, messages
        self._lock = threading.Lock()

    def tell(self, **message: Any) -> None:
        """Send a message; without a supervisor there is nothing left to do."""
        interruptible = threading.current_thread() is threading.main_thread()
        self._telling |= interruptible
        rest = memoryview(json.dumps(message).encode() + b"\n")
        try:
            with self._lock:
                while rest:
                    rest = rest[os.write(self._messages, rest) :]
        except OSError:
            os._exit(int(Exit.LIMIT))
        if interruptible:
            self._telling = False
            self.on_signal(0, None)

    def listen(self) -> None:
        """Wait for requests to stop, and for the supervisor's end."""
        while os.read(self._requests, 1):
            self.asked = True
            self._wake()
        os._exit(int(Exit.LIMIT))

    def _wake(self) -> None:
        if hasattr(signal, "pthread_kill"):
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
        else:
            _thread.interrupt_main()

    def on_signal(self, number: int, frame: object) -> None:
        """Interrupt the work, once, unless it will look for the request itself or is amid a write
        or a message.

        A terminal signals the whole group: only the supervisor's word counts.
        """
        del number, frame
        if self.asked and not (self._telling or self._heard):
            self._heard = True
            if not self.patient:
                self.interrupted = True
                raise KeyboardInterrupt

    def on_unraisable(self, unraisable: Any) -> None:
        """An interruption that came amid a callback, where Python drops it, comes once more.

        It comes from another thread, later: Python drops what is raised in this hook, too.
        """
        if isinstance(unraisable.exc_value, KeyboardInterrupt):
            self._heard = False
            again = threading.Timer(_AGAIN, self._wake)
            again.daemon = True
            again.start()
        else:
            sys.__unraisablehook__(unraisable)


class _Stream(io.TextIOBase):
    """A standard stream of a worker: `kept` for the closing message, or printed as it comes."""

    encoding = "utf-8"

    def __init__(self, name: str, terminal: bool, *, kept: bool) -> None:
        self.kept = kept
        self._name, self._terminal = name, terminal
        self._text = io.StringIO()

    def isatty(self) -> bool:
        return self._terminal

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self._text.write(text)
        if not self.kept:
            self.release()
        return len(text)

    def release(self) -> None:
        """Tell what was kept."""
        if _worker is not None and (text := self.taken()):
            _worker.tell(what="print", stream=self._name, text=text)

    def taken(self) -> str:
        """What was kept, which is kept no longer."""
        text, self._text = self._text.getvalue(), io.StringIO()
        return text


def _line(descriptor: int) -> bytes:
    """A line, and nothing beyond it."""
    line = b""
    while (byte := os.read(descriptor, 1)) not in (b"", b"\n"):
        line += byte
    return line
