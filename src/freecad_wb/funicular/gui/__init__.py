# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything that needs FreeCAD's window: the only package that names FreeCADGui, Qt or pivy."""
