"""What a running solver owes the outside: work counted, limits kept, steps reported."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from usdrigui.model import GAP_FLOOR, Step, gap_of
from usdrigui.settings import SolveSettings

LOWERED_AIM = "aim of the work limit"
"""Names the limit where the bound came to an aim that was lowered for the work that was left."""
ROUNDED = 2e-9
"""Share of a cost that a proof leaves: what HiGHS may round in a bound is taken off it."""
WITHIN_REACH = 0.25
"""Share of the way from the bound to the cutoff that half of the work may go."""


@dataclass(frozen=True, slots=True)
class Progress:
    """How far the solver is."""

    step: str
    """Name of the step, as in `Assignment.steps`."""
    cost: float
    """Of the best layout so far; +inf before the first."""
    bound: float
    """No layout costs less; -inf before the first."""

    @property
    def gap(self) -> float:
        """(cost - bound) / |cost|; inf while either is unknown."""
        return gap_of(self.cost, self.bound) if self.cost < np.inf else np.inf


@dataclass(eq=False)
class Budget:
    """Counts the work of one run and decides when to stop; a solver's only object that changes.

    Work is counted in pair evaluations, table entries, nodes and calls of HiGHS, so that a run
    stopped by `SolveSettings.work_limit` is the same on every machine.  The clock is read only for
    a time limit and for the seconds of the report.
    """

    settings: SolveSettings
    progress: Callable[[Progress], None] | None = None
    stop: Callable[[], bool] | None = None
    work: int = 0
    cost: float = np.inf
    bound: float = -np.inf
    ceiling: float = np.inf
    """More than any allowed layout can cost; set by the solver."""
    aim: float = np.inf
    """A bound above this is not looked for."""
    steps: list[Step] = field(default_factory=list)
    limit: str = ""
    """What stopped the run: ``work limit``, ``time limit``, ``memory limit``, ``interrupt`` or
    `LOWERED_AIM`."""
    _began: float = field(default_factory=time.monotonic, init=False)
    _step_began: float = field(default_factory=time.monotonic, init=False)

    @property
    def work_left(self) -> int:
        """Work until the limit."""
        return max(0, self.settings.work_limit - self.work)

    @property
    def seconds_left(self) -> float:
        """Wall time until the limit; inf without one."""
        limit = self.settings.time_limit
        return self._began + limit - time.monotonic() if limit > 0 else np.inf

    def part(self, share: float) -> Budget:
        """A budget over a share of what is left of the limits, for one of several problems solved
        in sequence.

        Its work must be counted here with `spend` when it is done: what it leaves goes to those
        that follow.
        """
        # Once it has run out, no time is left: 0 would mean no limit.
        time_limit = self.settings.time_limit and max(share * self.seconds_left, 1e-9)
        work_limit = int(share * self.work_left)
        limits = replace(self.settings, work_limit=work_limit, time_limit=time_limit)
        return Budget(limits, stop=self.stopped)

    def spend(self, work: int) -> None:
        """Count work done."""
        self.work += work

    def spent(self, share: float) -> bool:
        """Whether so much of the work that is allowed is done."""
        return self.work >= share * self.settings.work_limit

    def stopped(self) -> bool:
        """Whether a limit is reached or somebody asked to stop; stays true once it is."""
        if not self.limit:
            if self.spent(1.0):
                self.reach("work limit")
            elif self.seconds_left <= 0:
                self.reach("time limit")
            elif self.stop is not None and self.stop():
                self.reach("interrupt")
        return bool(self.limit)

    def reach(self, limit: str) -> None:
        """Note that a limit is reached: the run ends with what it has."""
        self.limit = self.limit or limit

    def lower_aim(self) -> None:
        """Once half of the work is done, aim at a bound that the rest of it may come to: what
        cannot be in a layout below that goes, and with it most of what the work would be spent
        on."""
        if self.spent(0.5) and np.isinf(self.aim):
            self.aim = self.bound + WITHIN_REACH * (self.cutoff - self.bound)

    def closed(self) -> bool:
        """Whether the gap is within the setting, or it is proved that no layout is allowed."""
        if not np.isfinite(self.cost):
            return self.bound >= self.ceiling
        return self.proves(self.cost, self.bound)

    def proves(self, cost: float, bound: float, rounding: float = 0.0) -> bool:
        """Whether a bound is as near to a cost as the settings ask; of a proof with no gap allowed
        no more may be left than rounding."""
        return cost - bound <= self.allowed(cost) + ROUNDED * (1.0 + abs(cost)) + rounding

    def over(self) -> bool:
        """Whether there is nothing left to prove, or a limit is reached."""
        return self.closed() or self.stopped()

    def allowed(self, cost: float) -> float:
        """How far the bound may stay below a cost."""
        return self.settings.gap * max(abs(cost), GAP_FLOOR)

    @property
    def cutoff(self) -> float:
        """Solutions that cost at least this much need not be looked for.

        A little below the best cost: discarding them leaves ``min(cutoff, bound of the rest)`` as
        the bound of the whole, which is within the gap that the settings ask for, unless the aim is
        lower.
        """
        if not np.isfinite(self.cost):
            return self.ceiling
        return min(self.cost - 0.9 * self.allowed(self.cost), self.aim)

    def found(self, step: str, cost: float = np.inf, bound: float = -np.inf) -> None:
        """Tell of a layout or a bound; the best of each is kept."""
        if bound >= self.aim:
            self.reach(LOWERED_AIM)
        better = cost < self.cost or bound > self.bound
        self.cost, self.bound = min(self.cost, cost), max(self.bound, bound)
        if better and self.progress is not None:
            self.progress(Progress(step, self.cost, self.bound))

    def note(self, name: str, **figures: float) -> None:
        """End a step: its figures and the time since the last one."""
        began, self._step_began = self._step_began, time.monotonic()
        numbers = tuple((key, float(value)) for key, value in figures.items())
        self.steps.append(Step(name, numbers, self._step_began - began))
