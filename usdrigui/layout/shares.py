"""What counts as nothing, as hardly any, as most and as nearly all of something, as beyond all
others, and how many points stand for a region."""

NOTHING = 1e-3
"""Share below which a difference is none: layers hold single precision, fits and hands leave more.
Of a unit vector across a direction, of a handle's width between two places, of the tolerance that a
setting gives."""
HARDLY_ANY = 0.1
"""Share below which next to nothing is there."""
MOST = 0.5
"""Share from which it is most of it."""
KEPT = 0.85
"""Share of its visible peak that a control keeps where it is at home: it wants those places, those
near the place where it is expected too."""
NEARLY_ALL = 0.9
"""Share from which it counts as all of it."""
OUTLIER = 4.0
"""Times what is usual among many beyond which one of them tells nothing of the others."""
SAMPLE = 2000
"""Points of a region that are looked at where each of them takes time."""
