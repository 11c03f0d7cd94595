"""What a shot's layer adds to elements of another layer."""

import numpy as np

from usdrigui.layer.skin_binding import PointShape


def shape(channel, count=1):
    return PointShape(channel, np.array([1.0]), np.arange(3.0 * count).reshape(1, count, 3))
