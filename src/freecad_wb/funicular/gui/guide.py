# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guide of this addon in a window of its own: docs/guide.md and its pictures, from where they lie."""

import os

import FreeCADGui
import funicular_locate

from funicular.gui.qt import QtCore, QtWidgets, translate

SIZE = 760, 900


class GuideWindow(QtWidgets.QDialog):
    """Stays beside what one does with it open; Esc closes it."""

    def __init__(self, window):
        super().__init__(window)
        self.setObjectName("FunicularGuide")
        self.setWindowTitle(translate("Funicular guide"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.page = QtWidgets.QTextBrowser()
        self.page.setObjectName("GuidePage")
        self.page.setOpenExternalLinks(True)
        # By its ending Qt takes it for Markdown, and looks for the pictures beside it.
        self.page.setSource(QtCore.QUrl.fromLocalFile(funicular_locate.GUIDE))
        self.page.document().setDocumentMargin(24)
        column.addWidget(self.page)
        self.resize(*SIZE)


_window = None


def show():
    """Open the guide, or bring it to the front. Returns its window."""
    global _window
    if not os.path.isfile(funicular_locate.GUIDE):
        from funicular.gui.messages import show_message

        show_message(
            translate("The guide is missing: {}. Install the addon again.").format(funicular_locate.GUIDE)
        )
        return None
    if _window is None:
        _window = GuideWindow(FreeCADGui.getMainWindow())
    _window.show()
    _window.raise_()
    _window.activateWindow()
    return _window
