"""What a process may do that reads what nobody has vouched for: nothing but read, compute and end.

On Linux the kernel holds it to that: no new privileges, no file written, made, removed or run
(Landlock, and a filter of system calls where the kernel has none), no connection, no other process
started, signalled or looked into (seccomp).  Everywhere but on Windows hard limits hold on memory,
files and time.  Python's own audit refuses connections and programs on every system.  What a
kernel does not know is left out: SECURITY.md says which system has what.
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import os
import platform
import signal
import struct
import sys
import tomllib
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

_ADDRESSES = 4 << 30
"""Bytes of address space beyond the memory: libraries reserve far more than they touch."""
_GRACE = 1.0
"""Seconds after the limit at which the alarm ends the process, should its parent not have done
so."""


def confine(seconds: float, memory: int) -> None:
    """Take from this process, for good, what reading does not need.

    `seconds` of wall clock until it is ended, and `memory` (MiB) more than it has.
    """
    sys.addaudithook(_refuse_connections)
    limit_memory(memory)
    if sys.platform != "win32":
        import resource

        lower(resource.RLIMIT_CORE, 0)
        lower(resource.RLIMIT_FSIZE, 0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_REAL, seconds + _GRACE)
    if sys.platform == "linux":
        _confine_by_kernel()


def limit_memory(memory: int) -> None:
    """Let this process have `memory` MiB more than it has, for good."""
    if sys.platform != "win32":
        import resource

        data = _private_memory() + (memory << 20)
        lower(resource.RLIMIT_DATA, data)
        lower(resource.RLIMIT_AS, data + _ADDRESSES)


def lower(kind: int, most: int) -> None:
    """Lower a limit of this process for good, as far as the system lets us."""
    import resource

    _, highest = resource.getrlimit(kind)
    if highest != resource.RLIM_INFINITY:
        most = min(most, highest)
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(kind, (most, most))


def bind_to(parent: int) -> None:
    """End this process when its parent `parent` does, however that ends; only Linux can."""
    if sys.platform == "linux":
        _prctl(_SET_PARENT_DEATH_SIGNAL, signal.SIGKILL)
        if os.getppid() != parent:
            os.kill(os.getpid(), signal.SIGKILL)


def _private_memory() -> int:
    """Bytes of private memory that this process has; 0 if the system does not report them."""
    try:
        return int(Path("/proc/self/statm").read_text().split()[5]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError):
        return 0


_CONNECTIONS = ("socket.", "subprocess.", "os.exec", "os.posix_spawn", "os.system", "os.fork")
"""Events of Python's audit while something is connected to or started."""


def _refuse_connections(event: str, _: tuple[Any, ...]) -> None:
    if event.startswith(_CONNECTIONS):
        raise PermissionError(f"{event} is not allowed while an asset is read")


# --- Linux ----------------------------------------------------------------------------------------

_SET_PARENT_DEATH_SIGNAL = 1
_SET_NO_NEW_PRIVILEGES = 38
_CREATE_RULESET, _RESTRICT_SELF = 444, 446
_VERSION_OF_LANDLOCK = 1
_RIGHTS = {1: 0x1FF3, 2: 1 << 13, 3: 1 << 14, 5: 1 << 15}
"""Rights about files that each version of Landlock brought, but for reading: to run, write, remove
and make (1), to move (2), to shorten (3), to ask a device for something (5)."""
_CONNECTING, _BEYOND = {4: 0b11}, {6: 0b11}
"""The same for connections, and for sockets and signals of other processes."""
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC
_OF_A_THREAD = 0x10000
_ALLOW, _REFUSE, _END = 0x7FFF0000, 0x00050000, 0x80000000
_LOAD, _EQUAL, _AT_LEAST, _ANY_BIT, _LEAVE = 0x20, 0x15, 0x35, 0x45, 0x06
_ARGUMENTS = 16
"""Where the arguments of a call begin in what a filter is shown."""


def _confine_by_kernel() -> None:
    """What the kernel does not know is not there: nothing here fails."""
    _prctl(_SET_NO_NEW_PRIVILEGES, 1)
    _forbid_files()
    machines = {"x86_64": 0, "aarch64": 1}
    if platform.machine() in machines and struct.calcsize("P") == 8:
        _forbid_calls(machines[platform.machine()])


def _prctl(option: int, value: int) -> None:
    none = ctypes.c_ulong(0)
    ctypes.CDLL(None).prctl(option, ctypes.c_ulong(value), none, none, none)


def _call(number: int, *arguments: Any) -> int:
    return int(ctypes.CDLL(None).syscall(ctypes.c_long(number), *arguments))


def _forbid_files() -> None:
    """No file may be written, made, removed or run from now on, whatever its path."""
    version = _call(_CREATE_RULESET, None, ctypes.c_size_t(0), _VERSION_OF_LANDLOCK)
    kinds = (_RIGHTS, _CONNECTING, _BEYOND)
    wanted = [sum(right for first, right in rights.items() if first <= version) for rights in kinds]
    attributes = struct.pack("QQQ", *wanted)
    ruleset = _call(_CREATE_RULESET, attributes, ctypes.c_size_t(len(attributes)), 0)
    if ruleset >= 0:
        _call(_RESTRICT_SELF, ruleset, 0)
        os.close(ruleset)


def _forbid_calls(machine: int) -> None:
    """System calls that reading does not need fail from now on, in every thread."""
    table = tomllib.loads((files(__package__) / "system_calls.toml").read_text(encoding="utf-8"))
    program = _program(table, machine)
    code = ctypes.create_string_buffer(program)
    described = struct.pack("HP", len(program) // 8, ctypes.addressof(code))
    set_filter, in_every_thread = 1, 1
    _call(table["seccomp"]["number"][machine], set_filter, in_every_thread, described)


def _program(table: Mapping[str, Mapping[str, list[int]]], machine: int) -> bytes:
    """A filter for the kernel: one decision for each call; all that the table does not name are
    allowed."""
    forbidden, missing = _leave(_REFUSE | errno.EPERM), _leave(_REFUSE | errno.ENOSYS)

    def numbers(part: str) -> list[int]:
        return [number[machine] for number in table[part].values() if number[machine]]

    def examined(part: str, argument: int, test: bytes) -> bytes:
        """The call is allowed if the test, which skips one step then, lets its argument pass."""
        passed = [_step(_LOAD, _ARGUMENTS + 8 * argument), test, forbidden, _leave(_ALLOW)]
        return b"".join(_step(_EQUAL, number, 0, 4) + b"".join(passed) for number in numbers(part))

    steps = [
        _step(_LOAD, 4),
        _step(_EQUAL, table["seccomp"]["architecture"][machine], 1, 0),
        _leave(_END),
        _step(_LOAD, 0),
        # The x32 calls of a 64-bit kernel have numbers of their own.
        _step(_AT_LEAST, 1 << 30, 0, 1),
        forbidden,
    ]
    steps += [_step(_EQUAL, number, 0, 1) + missing for number in numbers("missing")]
    steps += [_step(_EQUAL, number, 0, 1) + forbidden for number in numbers("refused")]
    # The one that names no folder has its flags one argument earlier.
    steps += [
        examined("to_read_here", 1, _step(_ANY_BIT, _WRITING, 0, 1)),
        examined("to_read", 2, _step(_ANY_BIT, _WRITING, 0, 1)),
        examined("to_thread", 0, _step(_ANY_BIT, _OF_A_THREAD, 1, 0)),
        examined("to_itself", 0, _step(_EQUAL, os.getpid(), 1, 0)),
        _leave(_ALLOW),
    ]
    return b"".join(steps)


def _step(code: int, value: int, if_so: int = 0, if_not: int = 0) -> bytes:
    """One instruction, and how many are skipped after it."""
    return struct.pack("HBBI", code, if_so, if_not, value)


def _leave(decision: int) -> bytes:
    return _step(_LEAVE, decision)
