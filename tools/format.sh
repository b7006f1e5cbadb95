#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/sources.sh

clang-format -i "${cpp[@]}"
/usr/bin/python3 -m black --quiet "${python[@]}"
