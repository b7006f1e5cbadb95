# SPDX-License-Identifier: LGPL-2.1-or-later
"""Members and panels of what a file holds."""


def edges(panel):
    return zip(panel, panel[1:] + panel[:1])


def members_of(lines, panels):
    """The lines, then the panels' edges; a member that runs the other way is the same member."""
    members = {}
    for a, b in lines:
        members.setdefault((min(a, b), max(a, b)), (a, b))
    for panel in panels:
        for a, b in edges(panel):
            members.setdefault((min(a, b), max(a, b)), (a, b))
    return list(members.values())


def check_members_on_panels(path, members, panels):
    on_panels = {(min(a, b), max(a, b)) for panel in panels for a, b in edges(panel)}
    lost = [i for i, (a, b) in enumerate(members) if (min(a, b), max(a, b)) not in on_panels]
    if lost:
        raise ValueError(
            f"{path}: this format holds only panels; member {lost[0]} ({len(lost)} such in all) is on none: "
            "write .obj or .ply instead"
        )
