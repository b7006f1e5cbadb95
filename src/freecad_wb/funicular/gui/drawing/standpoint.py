# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where one stands to look at a net: above it, before it, beside it, or at a corner; and near enough."""

import numpy as np
from pivy import coin

from funicular.gui.qt import QT_TRANSLATE_NOOP

MARGIN = 1.08  # of what is to be seen

_UPRIGHT = np.array([0.0, 0.0, 1.0])
# Directions in which one looks, what is then up in the view, its name, and FreeCAD's picture of it.
STANDPOINTS = {
    "Plan": ((0.0, 0.0, -1.0), (0.0, 1.0, 0.0), QT_TRANSLATE_NOOP("Funicular", "Plan"), "view-top"),
    "Front": ((0.0, 1.0, 0.0), _UPRIGHT, QT_TRANSLATE_NOOP("Funicular", "Front"), "view-front"),
    "Side": ((-1.0, 0.0, 0.0), _UPRIGHT, QT_TRANSLATE_NOOP("Funicular", "Side"), "view-right"),
    "Axonometric": (
        (-1.0, 1.0, -1.0),
        _UPRIGHT,
        QT_TRANSLATE_NOOP("Funicular", "Axonometric"),
        "view-isometric",
    ),
}


def look_from(view, name, points, left=0.0):
    """Turn a 3D view of FreeCAD's at once, and let it hold the points (n, 3) [mm, of the document].

    left: share of its width, from the left, that is left free of them.
    """
    if hasattr(view, "stopAnimating"):
        # A turn that is under way would go on from here.
        view.stopAnimating()
    right, up, backward = _axes(name)
    forward = -backward
    width, height = view.getSize()
    aspect = width / height
    camera = view.getCameraNode()
    rotation = coin.SbMatrix(*(value for row in (right, up, backward) for value in (*row, 0.0)), 0, 0, 0, 1)
    camera.orientation = coin.SbRotation(rotation)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, size = 0.5 * (low + high), max(np.linalg.norm(high - low), 1e-3)
    across, upward, along = ((points - middle) @ axis for axis in (right, up, forward))
    middle = middle + right * _mean_of_ends(across) + up * _mean_of_ends(upward)
    across, upward = across - _mean_of_ends(across), upward - _mean_of_ends(upward)
    if camera.isOfType(coin.SoOrthographicCamera.getClassTypeId()):
        tall = 2.0 * MARGIN * max(np.abs(upward).max(), np.abs(across).max() / aspect / (1.0 - left))
        tall = max(tall, 1e-3 * size)
        camera.height = tall
        aside, distance = 0.5 * left * tall * aspect, size
    else:
        # Each point so far away that it stays within the angle of the view.
        half = np.tan(0.5 * camera.heightAngle.getValue())
        wide, across, upward = half * aspect, MARGIN * across, MARGIN * upward
        to_right = (across / wide - along) / (1.0 - left)
        to_left = ((2.0 * left - 1.0) * along - across / wide) / (1.0 - left)
        away = np.concatenate([np.abs(upward) / half - along, to_right, to_left])
        distance = max(away.max(), 1e-3 * size)
        aside = left * wide * distance
    camera.position = (middle - distance * forward - aside * right).tolist()
    camera.focalDistance = distance


def rotation_of(view):
    """(3, 3) rows: to the right in a view, upward, toward the eye; as from a corner if there is no view."""
    if not hasattr(view, "getCameraNode"):
        return np.array(_axes("Axonometric"))
    rotation = coin.SbMatrix()
    rotation.setRotate(view.getCameraNode().orientation.getValue())
    return np.array(rotation.getValue())[:3, :3]


def _axes(name):
    """To the right, upward, and toward the eye, as one stands there."""
    forward, upwards = STANDPOINTS[name][:2]
    forward = np.array(forward) / np.linalg.norm(forward)
    right = np.cross(forward, upwards)
    right /= np.linalg.norm(right)
    return right, np.cross(right, forward), -forward


def _mean_of_ends(values):
    return 0.5 * (values.min() + values.max())
