# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD at its start, with a window or without."""

import FreeCAD
import funicular_locate

funicular_locate.add_package_to_path()

from funicular import observer  # noqa: E402

observer.start()

# FreeCAD imports the module when something is exported, and not before.
FreeCAD.addExportType("Funicular gridshell (*.obj *.ply *.stl *.off *.csv)", "funicular.export")
