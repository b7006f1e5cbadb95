# SPDX-License-Identifier: LGPL-2.1-or-later
"""Registers the workbench with FreeCAD's window."""

import FreeCADGui


class FunicularWorkbench(FreeCADGui.Workbench):
    """The workbench as FreeCAD lists it; what it contains is in funicular.gui.workbench.

    FreeCAD runs this file inside a function, so neither the class body nor the methods see names imported at
    its top: each method imports what it uses.
    """

    def __init__(self):
        import os
        import FreeCAD
        import FreeCADGui
        import funicular_locate

        # Before anything is said: what FreeCAD lists of a workbench, it lists once.
        FreeCADGui.addLanguagePath(funicular_locate.TRANSLATION_FOLDER)
        FreeCADGui.updateLocale()
        translate = FreeCAD.Qt.translate
        self.__class__.MenuText = translate("Workbench", "Funicular")
        self.__class__.ToolTip = translate("Workbench", "Turn a surface into a compression-only gridshell")
        self.__class__.Icon = os.path.join(funicular_locate.ICON_FOLDER, "Funicular.svg")

    def Initialize(self):
        import funicular_locate

        funicular_locate.add_package_to_path()
        from funicular.gui import workbench

        workbench.fill(self)

    def Activated(self):
        pass

    def Deactivated(self):
        pass

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(FunicularWorkbench())
