# SPDX-License-Identifier: LGPL-2.1-or-later
"""A change of a document as one undo step, all of it or nothing."""


def in_one_step(document, title, change):
    """The objects that change() returns, recomputed; None, and a message, where one comes to nothing."""
    from funicular.gui.messages import show_message

    document.openTransaction(title)
    try:
        objects = change()
        document.recompute()
        for obj in objects:
            if not obj.isValid():
                raise ValueError(obj.getStatusString())
    except Exception as error:
        # As with a gridshell: no half of an object stays behind, and the user reads why.
        document.abortTransaction()
        # Aborting restores the values and leaves what they belong to marked as out of date.
        document.recompute()
        show_message(str(error))
        return None
    document.commitTransaction()
    return objects
