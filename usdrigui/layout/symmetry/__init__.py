"""What mirrors what: the plane, the twin controls, n-fold orbits, and where the front is (paper
section 3.3)."""
