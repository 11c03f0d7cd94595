"""What counts as nothing, as hardly any, as most and as nearly all of something, and as beyond all
others."""

NOTHING = 1e-3
"""Share below which a difference is none: layers hold single precision, fits and hands leave more.
Of a unit vector across a direction, of a handle's width between two places, of the tolerance that a
setting gives."""
HARDLY_ANY = 0.1
"""Share below which next to nothing is there."""
MOST = 0.5
"""Share from which it is most of it."""
NEARLY_ALL = 0.9
"""Share from which it counts as all of it."""
OUTLIER = 4.0
"""Times the median beyond which one of many tells nothing of the others."""
