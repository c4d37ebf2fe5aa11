#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Everything from a fresh Debian 12 machine on: bash src/bootstrap.sh [COMMAND] [ARG…], where COMMAND is one of
#   packages  install what is missing for all components (sudo if you are not root)
#   build     the program at build/carom, without scenes, and the packages that it needs; this is done if you name no COMMAND
#   package   the Debian packages in build/package: carom, carom-scene, and libcarom-PART-dev for each component
#   package-test  package, then all of them into a bare Debian 12 made by debootstrap, as root, where they have to do what they should
#   component-test  [COMPONENT…]: configures, builds, installs and uses each component in a bare Debian 12 with its own packages alone, as root
#   ci-test   [NAME…]: runs the scripts that docs/guide/ci.md shows, as they stand there, in a bare Debian 12, as root. NAME is one
#             of action, github, gitlab, script and container; all of them take an hour on two cores
#   gate      build, then `build/carom gate ARG…`
#   engines   build, install the engines that npm has, then `build/carom gate --engines ARG…`
#   scenes    build carom-scene, too, then run every scene of docs/examples/scenes into build/scenes, and print a line with each verdict
#   quick     build the tests of single parts that take least, and run them: the first answer to an edit
#   test      build, then the tests that a change needs (`ctest ARG…`): of the heavy ones a share of their cases
#   test all  all tests, with all of their cases, the proofs, the browser, the installed libraries, every instruction set
#   proofs    build, then check the proofs, print each theorem with the axioms that it rests on, and hold the oracle that is
#             extracted of them against ours on 10,000 collisions: six minutes on two cores
#   bench     build, then print what solvers, batches, judge and gate take; exit status 1 if a solver takes more than four times
#             as long as the note in plain C++, or a batch longer than that
#   compare   REVISION: the benchmarks of that revision and of this tree in turn, and their ratios
#   sanitize  the tests with assertions, under AddressSanitizer and UndefinedBehaviorSanitizer, in build-sanitize
#   tsan      the tests that start programs and threads, under ThreadSanitizer, in build-tsan
#   fuzz      [SECONDS]: each target of tests/fuzz so long, 30 where nothing is said, by clang's libFuzzer, in build-fuzz
#   same-cases [CASES]: builds the families by other compilers and for other instruction sets, also of 32-bit x86 and of 64-bit
#             Arm under qemu, in build-same-cases, and compares every bit of what they draw
#   coverage  the tests, and which share of the lines of each folder they run, in build-coverage
#   mutation  change one operator, sign, number, comparison or term of the judge at a time, and ask whether the tests notice,
#             in build-mutation; `mutation --help` says what its figures mean
#   lint      clang-format, shellcheck, and clang-tidy of all files, in build-lint-all
#   lint FILE…  clang-tidy of these alone, in build-lint; `lint change` takes those that differ from HEAD
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# packages_of COMPONENT…: what they need of Debian
packages_of() {
  local component
  for component in "$@"; do sed -n "s/^$component //p" src/package/needs.txt | tr ' ' '\n'; done | sort -u
}

program=(impulse judge report program) # `carom` and what is below it
mapfile -t packages < <(packages_of "${program[@]}" kit scenes)
tools=(g++ cmake ninja-build gnuplot-nox)
engines=(libbullet-dev libode-dev) # the gate reports an engine as absent where these are not there
compilers=(clang g++-i686-linux-gnu g++-aarch64-linux-gnu qemu-user) # that build the families, too
judged='/all$|generate|^gate/' # of the benchmarks of the judge; those of each subject and family take four minutes more
jobs=$(nproc 2>/dev/null || echo 2)

# install_packages [PACKAGE…]: what is missing of these and of what every build needs
install_packages() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "bootstrap: this system has no apt. Install what Debian calls ${tools[*]} ${packages[*]}," >&2
    echo "bootstrap: and for the engines ${engines[*]}; going on with what is there." >&2
    return
  fi
  local missing=() package
  for package in "${tools[@]}" "${packages[@]}" "${engines[@]}" "$@"; do
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

# configure PRESET [ARG…]: with the choices of CMakePresets.json, in the directory that it names
configure() {
  cmake --preset "$1" -Wno-dev --log-level=WARNING "${@:2}" >/dev/null
}

# The tests start these programs: the examples' interpreters, and a reader of the schema.
install_test_programs() {
  local programs=(python3 python3-jsonschema python3-yaml)
  command -v node >/dev/null || programs+=(nodejs)
  install_packages "${programs[@]}" "$@"
}

# The same for all tests: a browser for the report, what checks the proofs, and compilers that have to draw the same cases.
install_all_test_programs() {
  local browser=()
  command -v chromium >/dev/null || browser=(chromium)
  install_test_programs "${browser[@]}"
  install_proof_checker
  (install_packages "${compilers[@]}") || echo "bootstrap: SameCases will be skipped" >&2
}

# What checks the proofs, and builds the oracle that is extracted of them.
install_proof_checker() {
  local of_proofs
  mapfile -t of_proofs < <(packages_of proofs)
  install_packages "${of_proofs[@]}"
}

# The page of replays is bundled from packages of npm; without them all else is built.
install_replay() {
  local folder=src/tool/replay
  [ "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ] && return
  command -v npm >/dev/null || (install_packages nodejs npm) || true
  (cd "$folder" && npm ci --no-audit --no-fund --loglevel=error >&2) ||
    echo "bootstrap: npm cannot install what replays of scenes are bundled from; the program will write none" >&2
}

# build TARGET [PRESET]: of all components
build() {
  install_packages
  install_replay
  configure "${2:-default}" -DCAROM_COMPONENTS=all
  cmake --build build --parallel "$jobs" --target "$1" >&2
}

# The program alone, without scenes. A build of all components stays one.
build_program() {
  if grep -qsx 'CAROM_COMPONENTS:STRING=all' build/CMakeCache.txt; then
    build carom_programs
    return
  fi
  mapfile -t packages < <(packages_of "${program[@]}")
  install_packages
  configure default -DCAROM_COMPONENTS=program
  cmake --build build --parallel "$jobs" --target carom_programs >&2
}

# run_tests DIRECTORY [ARG…]: one more at a time than there are processors, since some wait for programs that hang.
run_tests() {
  exec ctest --test-dir "$1" --output-on-failure --parallel "$((jobs + 1))" "${@:2}"
}

# Of what is ours, the files whose names match.
sources() {
  find src oracles properties tests docs/examples .ci .github -name node_modules -prune -o -type f "$@" -print
}

# clang-tidy reads the whole tree many files at a time, and a few files each by itself.
lint() {
  local status=0 files preset=lint-all checks='-bugprone-suspicious-include'
  if [ "${1:-}" = change ]; then
    mapfile -t files < <(git diff --name-only --diff-filter=d HEAD -- '*.cpp' && git ls-files --others --exclude-standard -- '*.cpp')
    set -- "${files[@]}"
    [ $# -eq 0 ] && set -- '^$' # no source has changed
  fi
  if [ $# -gt 0 ]; then
    preset=lint checks=''
  else
    set -- '^(?!.*/replay_page\.cpp$)' # the one source that is generated
  fi
  mapfile -t files < <(sources -name '*.[ch]pp')
  clang-format --dry-run --Werror "${files[@]}" || status=1
  mapfile -t files < <(sources '(' -name '*.sh' -o -path '.ci/*' ')')
  shellcheck "${files[@]}" || status=1
  configure "$preset"
  run-clang-tidy -quiet -p "build-$preset" -checks="$checks" -j "$jobs" "$@" 2> >(grep -v ' warnings\? generated\.$' >&2) || status=1
  return "$status"
}

# Clang's libFuzzer, which Debian has in a package of its own, with the version in its name.
install_fuzzer() {
  install_packages clang
  echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -x c++ - -fsanitize=fuzzer,address -o /dev/null 2>/dev/null && return
  local version
  version=$(clang++ -dumpversion)
  install_packages "libclang-rt-${version%%.*}-dev"
}

# fuzz_one TARGET SECONDS: what it finds out stays in build-fuzz/found/TARGET, findings in build-fuzz/findings.
fuzz_one() {
  local target=$1 seconds=$2 directories=("build-fuzz/found/$1" "build-fuzz/tests/fuzz/seeds/$1") known options
  for known in corpora regressions; do
    [ -d "tests/fuzz/$known/$target" ] && directories+=("tests/fuzz/$known/$target")
  done
  options=(-max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 "-artifact_prefix=build-fuzz/findings/$target-")
  case "$target" in json_* | protocol_*) options+=(-dict=tests/fuzz/carom.dict) ;; esac
  mkdir -p "${directories[0]}" build-fuzz/findings
  if "build-fuzz/tests/fuzz/$target" "${options[@]}" "${directories[@]}" >"build-fuzz/$target.log" 2>&1; then
    echo "$target: $(tail -n 1 "build-fuzz/$target.log"), nothing found"
  else
    tail -n 60 "build-fuzz/$target.log"
    echo "$target: a finding; tests/fuzz/README.md says what to do with it"
    return 1
  fi
}

# run_scene FILE [ARG…]: into build/scenes/NAME, and its verdict in a line. A million impulses of the gas are judged in part.
run_scene() {
  local file=$1 name options=()
  shift
  name=$(basename "$file" .json)
  [ "$name" = gas ] && options=(--judge-every 100)
  mkdir -p build/scenes
  local status=0
  build/carom scene "$file" --out "build/scenes/$name" "${options[@]}" "$@" >"build/scenes/$name.txt" || status=1
  echo "$name: $(tail -n 1 "build/scenes/$name.txt")"
  return "$status"
}

command=${1:-build}
[ $# -gt 0 ] && shift
case "$command" in
packages) install_packages ;;
build) build_program ;;
package)
  install_packages dpkg-dev file
  build carom_package everything
  ls build/package/*.deb
  ;;
package-test)
  install_packages dpkg-dev file debootstrap python3
  build carom_package everything
  exec python3 tests/package/package_test.py build/package build/tests/package/installed .
  ;;
component-test)
  install_packages debootstrap python3
  exec python3 tests/package/components_test.py build/tests/package/components . "$@"
  ;;
ci-test)
  install_packages debootstrap git python3 python3-yaml
  exec python3 tests/package/ci_test.py . build/tests/package/ci "$@"
  ;;
gate)
  build_program
  exec build/carom gate "$@"
  ;;
engines)
  command -v npm >/dev/null || install_packages nodejs npm
  (cd src/subjects/engines/npm && npm ci --no-audit --no-fund >&2)
  build_program
  exec build/carom gate --engines "$@"
  ;;
scenes)
  build carom_programs
  status=0
  for file in docs/examples/scenes/*.json; do
    run_scene "$file" "$@" || status=1
  done
  exit "$status"
  ;;
quick)
  build carom_unit_tests
  run_tests build --label-regex '^unit$' --label-exclude '^thorough$' "$@"
  ;;
test)
  if [ "${1:-}" = all ]; then
    install_all_test_programs
    build carom_all_tests everything
    run_tests build "${@:2}"
  fi
  install_test_programs
  build carom_default_tests
  run_tests build --label-exclude '^thorough$' "$@"
  ;;
proofs)
  install_proof_checker
  build carom_programs
  python3 tests/proofs/check_proofs.py properties/proofs build/proofs --each
  python3 tests/proofs/false_laws_test.py properties/proofs build/false_laws
  python3 tests/proofs/build_bridge.py properties/proofs build/proofs
  exec python3 tests/proofs/bridge_test.py build/carom build/proofs/proved "${1:-10000}" docs/examples/*.json* \
    docs/findings/engines/witnesses/*.json
  ;;
bench)
  install_packages python3
  build carom_benchmarks
  build/tests/benchmarks/solvers --benchmark_out=build/solvers.json --benchmark_out_format=json "$@"
  build/tests/benchmarks/judge_rate "--benchmark_filter=$judged" "$@"
  exec python3 tests/benchmarks/against_note.py build/solvers.json
  ;;
compare)
  revision=${1:?bootstrap: compare needs a REVISION}
  shift
  install_packages python3 git
  build carom_benchmarks
  [ -e build-compare/source ] && git worktree remove --force build-compare/source
  git worktree add --quiet --force --detach build-compare/source "$revision"
  cmake -S build-compare/source -B build-compare/build -G Ninja -Wno-dev --log-level=WARNING \
    -DCAROM_BUILD_TESTS=ON -DCAROM_UNITY=ON >/dev/null
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
  install_all_test_programs
  configure sanitize
  cmake --build build-sanitize --parallel "$jobs" --target carom_all_tests >&2
  run_tests build-sanitize "$@"
  ;;
tsan)
  install_packages
  configure tsan
  cmake --build build-tsan --parallel "$jobs" --target carom_programs carom_tool_tests >&2
  run_tests build-tsan --label-regex '^tool$' --label-exclude '^thorough$' "$@"
  ;;
fuzz)
  install_packages
  install_fuzzer
  configure fuzz
  cmake --build build-fuzz --parallel "$jobs" --target carom_fuzzers >&2
  status=0
  for source in build-fuzz/tests/fuzz/seeds/*; do
    fuzz_one "$(basename "$source")" "${1:-30}" || status=1
  done
  exit "$status"
  ;;
same-cases)
  install_packages "${compilers[@]}"
  exec bash tests/properties/families/same_cases.sh . build-same-cases "$@"
  ;;
coverage)
  install_all_test_programs
  install_packages gcovr
  configure coverage
  cmake --build build-coverage --parallel "$jobs" --target carom_all_tests >&2
  find build-coverage -name '*.gcda' -delete
  ctest --test-dir build-coverage --output-on-failure --parallel "$jobs" "$@" >&2
  gcovr --root . --object-directory build-coverage --exclude-unreachable-branches --csv \
    --filter src/ --filter oracles/ --filter properties/ -j "$jobs" |
    python3 tests/house/coverage_by_folder.py
  ;;
mutation)
  install_packages python3
  exec python3 tests/mutation/mutate.py "$@"
  ;;
lint)
  install_packages clang clang-format clang-tidy shellcheck
  lint "$@"
  ;;
*)
  sed -n '3,/^set/{/^set/d;p}' src/bootstrap.sh >&2
  exit 2
  ;;
esac
