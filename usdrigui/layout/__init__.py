"""From a `Rig` to a layout problem, and from its solution to a `Layout`; pure functions, no USD.

Each stage is a function whose signature lists its inputs; `usdrigui.pipeline.stages` calls them
in order:

    trajectories → displacement fields → symmetry → views → classification → handle width → Face
    Face → Candidates → Groups → PlacementProblem → ... Assignment, of usdrigui.solve ... → Layout
"""
