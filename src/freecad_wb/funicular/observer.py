# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mending of documents that were saved where the addon was absent: their objects' proxies are lost then."""

import FreeCAD as App

from .features.feature import MARKER


class Observer:
    """Looks at each document as it becomes the active one."""

    def slotActivateDocument(self, doc):
        ours = [obj for obj in doc.Objects if getattr(obj, MARKER, "")]
        if not ours:
            return
        # FreeCAD starts faster where nobody has brought in Part and numpy yet.
        from . import make

        for obj in ours:
            if getattr(obj, MARKER) in make.FEATURES:
                make.attach(obj)


_observer = Observer()


def start():
    """Watch every document from now on; calling it again changes nothing."""
    App.removeDocumentObserver(_observer)
    App.addDocumentObserver(_observer)
