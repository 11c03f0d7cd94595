"""From a `Rig` to a `LayoutProblem`, and from its solution to a `Layout`; pure functions, no USD.

found = trajectory.trajectories(rig, settings.trajectories, base_values)
symmetry = symmetry.find_symmetry(rig, found, settings)
views = visibility.find_views(rig, found, symmetry, settings.candidates.view, settings.candidates.occlusion, camera)
context = terms.Context(rig, found, symmetry, views, settings)
candidates = candidates.candidates(context)
groups = groups.find_groups(context, candidates)
problem, choices = problem.layout_problem(context, candidates, groups)
...an Assignment of `problem`, from usdrigui.solve...
layout = elements.layout(context, candidates, groups, problem, choices, assignment, base_values)
"""
