# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live panel of a gridshell: a session that solves and moves, and the parts that show and change it."""
