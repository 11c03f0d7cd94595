"""The line from USD in to USD out, and what can be asked of its two ends.

    Usd.Stage → Rig → Trajectories → Candidates → Groups → LayoutProblem → Assignment → Layout →
    Sdf.Layer

`process` lays out and writes, `inspect` stops before the search, `load_layer` reads a written layer
back, `check` and `diff` review layers.  Nothing here prints; the record that it returns holds all
results.
"""

from usdrigui.pipeline.configuration import (
    with_faults_of_asset as with_faults_of_asset,
)
from usdrigui.pipeline.correcting import (
    bake as bake,
    pin as pin,
    pins as pins,
)
from usdrigui.pipeline.inspecting import (
    inspect as inspect,
)
from usdrigui.pipeline.laying_out import (
    process as process,
    process_stage as process_stage,
)
from usdrigui.pipeline.progress import (
    Event as Event,
    ProgressCallback as ProgressCallback,
)
from usdrigui.pipeline.records import (
    ProblemInputs as ProblemInputs,
)
from usdrigui.pipeline.reviewing import (
    LayerDifference as LayerDifference,
    LayerReview as LayerReview,
    Loaded as Loaded,
    check as check,
    diff as diff,
    load_layer as load_layer,
    open_layouts as open_layouts,
    review as review,
)
from usdrigui.pipeline.stages import (
    build_problem as build_problem,
)
from usdrigui.pipeline.targets import (
    check_outputs as check_outputs,
    check_place as check_place,
    default_output as default_output,
    stage_file as stage_file,
    write_file as write_file,
)
