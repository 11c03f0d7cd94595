"""The line from USD in to USD out, and what can be asked of its two ends.

    Usd.Stage → Rig → Trajectories → Candidates → Groups → LayoutProblem → Assignment → Layout →
    Sdf.Layer

`process` lays out and writes, `inspect` stops before the search, `load_layer` reads a written layer
back, `check` and `diff` review layers.  Nothing here prints; the record that it returns holds all
results.
"""

from __future__ import annotations

from usdrigui.pipeline.configuration import with_faults_of_asset
from usdrigui.pipeline.inspecting import inspect
from usdrigui.pipeline.laying_out import process, process_stage
from usdrigui.pipeline.progress import Event, ProgressCallback
from usdrigui.pipeline.records import ProblemInputs, Task
from usdrigui.pipeline.reviewing import (
    LayerDifference,
    LayerReview,
    Loaded,
    check,
    diff,
    load_layer,
    open_layouts,
    review,
)
from usdrigui.pipeline.stages import build_problem
from usdrigui.pipeline.targets import check_outputs, default_output, stage_file, write_file

__all__ = [
    "Event",
    "LayerDifference",
    "LayerReview",
    "Loaded",
    "ProblemInputs",
    "ProgressCallback",
    "Task",
    "build_problem",
    "check",
    "check_outputs",
    "default_output",
    "diff",
    "inspect",
    "load_layer",
    "open_layouts",
    "process",
    "process_stage",
    "review",
    "stage_file",
    "with_faults_of_asset",
    "write_file",
]
