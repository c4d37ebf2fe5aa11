#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Prints key=…, which is another one where the sources of the package differ, or the system that it is for.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
system=$(sed -n 's/^\(ID\|VERSION_ID\)="\?\([^"]*\)"\?$/\2/p' /etc/os-release | paste -sd-)
sources=$(find CMakeLists.txt src oracles properties docs -name node_modules -prune -o -type f -print0 | sort -z |
  xargs -0 sha256sum | sha256sum | cut -c 1-32)
echo "key=carom-$system-$(dpkg --print-architecture)-$sources"
