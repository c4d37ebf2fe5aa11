#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Everything from a fresh Debian 12 machine on: bash src/bootstrap.sh [packages|build|gate|engines|test|sanitize] [ARG…]
#   packages  install what is missing (sudo where not root)
#   build     packages, then the program at build/carom
#   gate      build, then `build/carom gate ARG…`
#   engines   build, install the engines that npm has, then `build/carom gate --engines ARG…`
#   test      build, then all tests
#   bench     build, then print what solvers, batches, judge and gate take
#   compare   REVISION: the benchmarks of that revision and of this tree in turn, and their ratios
#   sanitize  the tests with assertions, under AddressSanitizer and UndefinedBehaviorSanitizer, in build-sanitize
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(g++ cmake ninja-build pkg-config libeigen3-dev libcgal-dev libfmt-dev nlohmann-json3-dev libcli11-dev
  libpugixml-dev libbenchmark-dev gnuplot-nox libgtest-dev librapidcheck-dev)
engines=(libbullet-dev libode-dev) # the gate reports an engine as absent where these are not there
judged='/all$|generate|^gate/' # of the benchmarks of the judge; those of each subject and family take four minutes more
jobs=$(nproc 2>/dev/null || echo 2)

# install_packages [PACKAGE…]: what is missing of these and of what every build needs
install_packages() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "bootstrap: this system has no apt. Install what Debian calls ${packages[*]}," >&2
    echo "bootstrap: and for the engines ${engines[*]}; going on with what is there." >&2
    return
  fi
  local missing=() package
  for package in "${packages[@]}" "${engines[@]}" "$@"; do
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "bootstrap: not root, and there is no sudo. As root: apt-get install ${missing[*]}" >&2
      exit 2
    }
    as_root=(sudo)
  fi
  echo "bootstrap: installing ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# configure DIRECTORY [CMAKE ARG…]
configure() {
  local directory=$1
  shift
  cmake -S . -B "$directory" -G Ninja -Wno-dev --log-level=WARNING "$@" >/dev/null
}

# What the tests start besides: the examples' interpreters, a reader of the schema, and a browser for the report.
install_test_programs() {
  local programs=(python3 python3-jsonschema)
  command -v node >/dev/null || programs+=(nodejs)
  command -v chromium >/dev/null || programs+=(chromium)
  install_packages "${programs[@]}"
}

build() {
  install_packages
  configure build -DCAROM_BUILD_TESTS=ON
  cmake --build build --parallel "$jobs" --target "$1" >&2
}

command=${1:-build}
[ $# -gt 0 ] && shift
case "$command" in
packages) install_packages ;;
build) build carom_programs ;;
gate)
  build carom_programs
  exec build/carom gate "$@"
  ;;
engines)
  command -v npm >/dev/null || install_packages nodejs npm
  (cd src/subjects/engines/npm && npm ci --no-audit --no-fund >&2)
  build carom_programs
  exec build/carom gate --engines "$@"
  ;;
test)
  install_test_programs
  build all
  exec ctest --test-dir build --output-on-failure --parallel "$jobs" "$@"
  ;;
bench)
  build carom_benchmarks
  build/tests/benchmarks/solvers "$@"
  build/tests/benchmarks/judge_rate "--benchmark_filter=$judged" "$@"
  ;;
compare)
  revision=${1:?bootstrap: compare needs a REVISION}
  shift
  install_packages python3 git
  build carom_benchmarks
  [ -e build-compare/source ] && git worktree remove --force build-compare/source
  git worktree add --quiet --force --detach build-compare/source "$revision"
  cmake -S build-compare/source -B build-compare/build -G Ninja -Wno-dev --log-level=WARNING -DCAROM_BUILD_TESTS=ON >/dev/null
  cmake --build build-compare/build --parallel "$jobs" --target carom_benchmarks >&2
  status=0
  for benchmark in solvers judge_rate; do
    filter=()
    [ "$benchmark" = judge_rate ] && filter=("--benchmark_filter=$judged")
    python3 tests/benchmarks/compare.py "build-compare/build/tests/benchmarks/$benchmark" \
      "build/tests/benchmarks/$benchmark" "${filter[@]}" "$@" || status=$?
  done
  exit "$status"
  ;;
sanitize)
  install_test_programs
  configure build-sanitize -DCAROM_BUILD_TESTS=ON -DCAROM_SANITIZE=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1
  cmake --build build-sanitize --parallel "$jobs" >&2
  exec ctest --test-dir build-sanitize --output-on-failure --parallel "$jobs" "$@"
  ;;
*)
  sed -n '3,11p' src/bootstrap.sh >&2
  exit 2
  ;;
esac
