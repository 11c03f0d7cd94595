"""The progress of a run, and how long its stages take."""

from __future__ import annotations

import math
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from usdrigui.solve.budget import Progress


@dataclass(frozen=True, slots=True)
class Event:
    """Something worth showing while a run goes on."""

    stage: str
    detail: str = ""
    """The character, where there are several, the part of it that the stage is about, if it is
    about one, and how far it is."""
    seconds: float | None = None
    """Given when the stage has ended."""
    can_stop: bool = False
    """True while a request to stop is answered with the best layout so far."""


ProgressCallback = Callable[[Event], None]


@dataclass
class Clock:
    """Times the stages and calls the watcher; a copy for a part adds to the same times."""

    watch: ProgressCallback | None = None
    part: str = ""
    """Of the character that is worked on, where the stages are those of one part, after the path
    of the character where there are several."""
    _seconds: dict[str, float] = field(default_factory=lambda: defaultdict(float))

    @property
    def seconds(self) -> tuple[tuple[str, float], ...]:
        """Spent in each stage, in the order of their first beginning."""
        return tuple(self._seconds.items())

    def of(self, whose: str, *, told: bool = True) -> Clock:
        """For the stages of a character, `told` where there are several, or of a part of it."""
        return replace(self, part=f"{self.part} {whose}".strip()) if told else self

    @contextmanager
    def stage(self, name: str, *, can_stop: bool = False) -> Iterator[None]:
        """Time what is done within; a stage may be entered once for every character."""
        self._tell(Event(name, can_stop=can_stop))
        start = time.perf_counter()
        yield
        spent = time.perf_counter() - start
        self._seconds[name] += spent
        self._tell(Event(name, self.part, seconds=spent))

    def solving(self, progress: Progress) -> None:
        """Tell how far the solver is."""
        known = "no layout yet"
        if math.isfinite(progress.cost):
            known = f"cost {progress.cost:.4f}, gap {progress.gap:.1e} of it"
        detail = f"{self.part}: {progress.step}: {known}, bound {progress.bound:.4f}"
        self._tell(Event("solve", detail, can_stop=True))

    def _tell(self, event: Event) -> None:
        if self.watch is not None:
            self.watch(event)
