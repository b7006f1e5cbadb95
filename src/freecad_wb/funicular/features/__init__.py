# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects. Their module and class names are written into users' files: they never change."""
