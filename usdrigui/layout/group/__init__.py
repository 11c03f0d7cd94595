"""Which controls share one element, and on which level it is shown (paper sections 3.2 and 4.2)."""
