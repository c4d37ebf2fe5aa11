#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# The gate with the action's inputs, which come by the environment: no input is ever a part of a command. Ends as the gate.
set -euo pipefail

# lines TEXT: each line that is not empty, ended by NUL.
lines() {
  local line
  while IFS= read -r line; do
    [ -z "$line" ] || printf '%s\0' "$line"
  done <<<"$1"
}

mapfile -d '' -t subjects < <(lines "$CAROM_SUBJECTS")
mapfile -d '' -t arguments < <(lines "$CAROM_ARGUMENTS")
[ -z "$CAROM_WITHIN" ] || arguments+=(--within "$CAROM_WITHIN")
[ -z "$CAROM_DIGITS" ] || arguments+=(--digits "$CAROM_DIGITS")
[ -z "$CAROM_BASELINE" ] || arguments+=(--baseline "$CAROM_BASELINE")
exec carom gate "${subjects[@]}" --seed "$CAROM_SEED" --cases "$CAROM_CASES" --out "$CAROM_OUT" --annotations github \
  --summary "$GITHUB_STEP_SUMMARY" "${arguments[@]}"
