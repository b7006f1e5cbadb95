# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Sourced by lint.sh and format.sh from the root of the checkout: one opinion on what our sources are.
mapfile -t cpp < <(find src/core tests/core tests/fuzz bench -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' \) 2> /dev/null | sort)
mapfile -t core_units < <(find src/core -type f -name '*.cpp' -not -path '*/bindings/*' | sort)
mapfile -t python < <(find ./*.py src/freecad_wb tests examples tools bench -type f -name '*.py' 2> /dev/null | sort)
