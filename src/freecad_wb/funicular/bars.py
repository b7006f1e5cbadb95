# SPDX-License-Identifier: LGPL-2.1-or-later
"""Members as the bars that they are built of: prisms along each member, for all members at once. Only numpy.

A section is an outline (k, 2) around the axis of a member, counter-clockwise: first sideways, level, then
upwards in the vertical plane of the member.
"""

import numpy as np

# Of the length of a member: what has less of it on plan stands upright, and has no vertical plane of its own.
UPRIGHT = 1e-6


def round_section(diameter, sides=8):
    """(sides, 2): a polygon that has the diameter across its corners."""
    angles = 2.0 * np.pi * np.arange(sides) / sides
    return 0.5 * diameter * np.column_stack([np.cos(angles), np.sin(angles)])


def rectangular_section(width, height):
    """(4, 2): level across the member, and upright in its vertical plane."""
    return 0.5 * np.array([[-width, -height], [width, -height], [width, height], [-width, height]])


def bar_axes(begins, ends):
    """Unit vectors (m, 3) across each member, level, and upright to both; zero where a member has no length.

    Across, upright and the member itself are right-handed. Of a vertical member upright means along y.
    """
    along = ends - begins
    lengths = np.linalg.norm(along, axis=1)
    on_plan = np.hypot(along[:, 0], along[:, 1])
    vertical = on_plan <= UPRIGHT * lengths
    across = np.column_stack([-along[:, 1], along[:, 0], np.zeros(len(along))])
    across /= np.where(vertical, 1.0, on_plan)[:, None]
    across[vertical] = np.sign(along[vertical, 2])[:, None] * (1.0, 0.0, 0.0)
    upright = np.cross(along / np.where(lengths > 0.0, lengths, 1.0)[:, None], across)
    return across, upright


def bar_points(nodes, members, section):
    """(2 k m, 3): of each bar the corners of its section at the first end, then those at the other.

    nodes: (n, 3). members: (m, 2). section: (k, 2), in the unit of the nodes. A member without length has all
    its corners in one point.
    """
    begins, ends = nodes[members[:, 0]], nodes[members[:, 1]]
    across, upright = bar_axes(begins, ends)
    ring = section[:, 0, None] * across[:, None] + section[:, 1, None] * upright[:, None]
    points = np.empty((len(members), 2, len(section), 3))
    points[:, 0] = begins[:, None] + ring
    points[:, 1] = ends[:, None] + ring
    return points.reshape(-1, 3)


def bar_faces(corners):
    """The faces of one bar by the numbers of its points: a side for each of the corners, and two caps.

    All run counter-clockwise as seen from outside.
    """
    first = list(range(corners))
    other = [corners + corner for corner in first]
    sides = [(first[j], first[(j + 1) % corners], other[(j + 1) % corners], other[j]) for j in range(corners)]
    return [*sides, tuple(reversed(first)), tuple(other)]
