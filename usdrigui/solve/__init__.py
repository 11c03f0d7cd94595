"""Solvers of `usdrigui.model.LayoutProblem`; knows nothing of rigs or USD."""
