#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Builds every target as OSS-Fuzz requires: with $CXX, $CXXFLAGS and $LIB_FUZZING_ENGINE, in $WORK, to $OUT, with its
# seeds and its dictionary.
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
fuzz=$source/tests/fuzz

# The batch solvers use libstdc++'s <experimental/simd>, and the system's {fmt} is compiled for libstdc++.
flags=${CXXFLAGS:-}
flags=${flags//-stdlib=libc++/}

# Targets run on machines without the shared libraries, which are copied beside them.
# shellcheck disable=SC2016 # $ORIGIN is the loader's
cmake -S "$source" -B "$WORK/carom" -G Ninja -Wno-dev -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" \
  -DCAROM_BUILD_FUZZERS=ON -DCAROM_BUILD_TESTS=OFF -DCAROM_UNITY=ON -DCAROM_WARNINGS_AS_ERRORS=OFF \
  -DCMAKE_BUILD_RPATH='$ORIGIN/lib'
cmake --build "$WORK/carom" --target carom_fuzzers

mkdir -p "$OUT/lib"
for seeds in "$WORK"/carom/tests/fuzz/seeds/*; do
  target=$(basename "$seeds")
  cp "$WORK/carom/tests/fuzz/$target" "$OUT/"
  cp "$fuzz/carom.dict" "$OUT/$target.dict"
  known=("$seeds")
  [ -d "$fuzz/regressions/$target" ] && known+=("$fuzz/regressions/$target")
  rm -f "$OUT/${target}_seed_corpus.zip"
  zip -q -j -r "$OUT/${target}_seed_corpus.zip" "${known[@]}"
  ldd "$WORK/carom/tests/fuzz/$target" | awk '$1 ~ /^lib(stdc\+\+|gcc_s|fmt|gmp|mpfr|ode|Bullet|LinearMath|ccd)/ { print $3 }' |
    xargs -r cp -L -t "$OUT/lib"
done
