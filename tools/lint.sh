#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Every linter speaks before the first failure counts.
# clang-tidy leaves src/core/bindings out: pybind11's headers alone cost it more time than the whole core, and its
# macros trip the checks. It needs build/release/compile_commands.json, so `make lint` configures first.
set -uo pipefail
cd "$(dirname "$0")/.."
source tools/sources.sh

failed=()
run() {
    printf 'lint: %s\n' "$1"
    "${@:2}" || failed+=("$1")
}
# One complaint a file is enough to know that it wants formatting.
formatted() {
    local file faults=0
    for file in "$@"; do
        clang-format --dry-run -Werror --ferror-limit=1 "$file" || faults=1
    done
    return $faults
}
run clang-format formatted "${cpp[@]}"
run clang-tidy /usr/bin/python3 tools/tidy.py build/release "${core_units[@]}"
run black /usr/bin/python3 -m black --check --quiet --diff "${python[@]}"
run flake8 /usr/bin/python3 -m flake8 "${python[@]}"

if [ "${#failed[@]}" -gt 0 ]; then
    printf 'lint: failed: %s (make format mends the formatting)\n' "${failed[*]}" >&2
    exit 1
fi
