"""Where each element may stand, and what every place costs (paper sections 3.3, 4.1 and 4.2)."""
