#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# soak.sh SECONDS: random scenes and files until the time is over, a third of it for each of
#   - the properties of tests/python, with new random seeds each round;
#   - fuzz_scene, libFuzzer on the core under sanitizers (built by `make soak`);
#   - fuzz_files.py, atheris on the mesh readers.
# All three run whatever the others find. What fails is printed with what repeats it: a reproduce_failure line of
# hypothesis, or the path of an input, which `fuzz_scene PATH` or `fuzz_files.py PATH` runs again. Corpora stay in
# build/soak/, so that each soak begins where the last one ended.
set -uo pipefail
cd "$(dirname "$0")/../.."
share=$((${1:?seconds} / 3))
python=${PYTHON:-/usr/bin/python3}
failed=()

properties() {
    local until=$((SECONDS + share)) seed rounds=0
    while [ $rounds -eq 0 ] || [ $SECONDS -lt $until ]; do
        seed=$RANDOM$RANDOM
        echo "soak: properties, seed $seed"
        "$python" -m pytest -q tests/python/test_properties.py tests/python/test_any_file.py \
            --hypothesis-profile=soak --hypothesis-seed=$seed || return 1
        rounds=$((rounds + 1))
    done
}

# No small input takes or holds as much as this.
limits=(-max_total_time=$share -timeout=20 -rss_limit_mb=2048 -verbosity=0 -print_final_stats=1)

scenes() {
    mkdir -p build/soak/scenes
    "$python" tests/fuzz/seeds.py build/soak/scenes
    build/fuzz/tests/fuzz/fuzz_scene build/soak/scenes -max_len=600 -artifact_prefix=build/soak/scene- "${limits[@]}"
}

# The wheel is not Debian's: without a network the readers are left to the properties, which know no coverage.
atheris_python() {
    local venv=build/soak/venv
    [ -x $venv/bin/python ] || "$python" -m venv --system-site-packages $venv >&2 || return 1
    $venv/bin/python -c 'import atheris' 2> /dev/null || $venv/bin/pip install --quiet 'atheris>=3,<4' >&2 || return 1
    echo $venv/bin/python
}

files() {
    local guided
    if ! guided=$(atheris_python); then
        echo "soak: atheris cannot be installed, so the readers are fuzzed by tests/python/test_any_file.py alone"
        return 0
    fi
    mkdir -p build/soak/files
    "$python" tests/fuzz/fuzz_files.py --seeds build/soak/files
    "$guided" tests/fuzz/fuzz_files.py build/soak/files -max_len=2000 -artifact_prefix=build/soak/file- "${limits[@]}"
}

for part in properties scenes files; do
    $part || failed+=("$part")
done
[ ${#failed[@]} -eq 0 ] || { echo "soak: failed: ${failed[*]}" >&2; exit 1; }
echo "soak: nothing found in $SECONDS s"
