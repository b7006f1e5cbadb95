# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the sun throws a shadow on level ground, and how much ground that takes. Only numpy."""

import math

import numpy as np

LOWEST_SUN = 5.0  # [°]: below it shadows grow beyond all bounds
MARGIN = 0.12  # of the larger side, around what stands on the ground and its shadow


def toward_sun(azimuth, altitude):
    """(3,) unit vector. azimuth: [°] from north (+y), clockwise as on a compass; altitude: [°] above level
    ground; what is below LOWEST_SUN is taken for that."""
    azimuth, altitude = math.radians(azimuth), math.radians(min(max(altitude, LOWEST_SUN), 90.0))
    return np.array(
        [
            math.cos(altitude) * math.sin(azimuth),
            math.cos(altitude) * math.cos(azimuth),
            math.sin(altitude),
        ]
    )


def shadow_matrix(sun, level):
    """(4, 4) by which points (x, y, z, 1), as columns, come to their shadows at the height `level`.

    sun: (3,) towards it.
    """
    away = sun[:2] / sun[2]
    matrix = np.eye(4)
    matrix[0, 2:] = -away[0], away[0] * level
    matrix[1, 2:] = -away[1], away[1] * level
    matrix[2, 2:] = 0.0, level
    return matrix


def shadows(points, sun, level):
    """(n, 3) shadows of points (n, 3) at the height `level`."""
    matrix = shadow_matrix(sun, level)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def ground_below(points, sun, level):
    """(4, 3): corners, counter-clockwise from above, of the ground that holds points and their shadows."""
    both = np.vstack([points[:, :2], shadows(points, sun, level)[:, :2]])
    low, high = both.min(axis=0), both.max(axis=0)
    margin = MARGIN * max((high - low).max(), 1e-3)
    (x0, y0), (x1, y1) = low - margin, high + margin
    return np.array([[x0, y0, level], [x1, y0, level], [x1, y1, level], [x0, y1, level]])
