#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Builds and checks Carom from a fresh Debian 12 on: bash src/bootstrap.sh [COMMAND] [ARG…]. The default is `build`.
#   packages  install the missing packages of all components (with sudo if you are not root)
#   build     install the packages that the program needs, and build it at build/carom, without scenes
#   package   build the Debian packages in build/package: carom, carom-scene, and libcarom-PART-dev for each component
#   package-test  package, then install and test every package in a bare Debian 12 made by debootstrap, as root
#   component-test  [COMPONENT…]: configure, build, install and use each component in a bare Debian 12, with only the
#             packages that it needs, as root
#   ci-test   [NAME…]: run the scripts of docs/guide/ci.md unchanged in a bare Debian 12, as root. NAME is action,
#             github, gitlab, script or container. All of them take an hour on two cores
#   gate      build, then run `build/carom gate ARG…`
#   engines   build, install the npm engines, then run `build/carom gate --engines ARG…`
#   scenes    build carom-scene too, run every scene of docs/examples/scenes into build/scenes, and print one verdict
#             a line
#   time      build carom-scene too, then run `build/carom time ARG…`
#   quick     build and run the fastest unit tests: the first answer to an edit
#   wasm      build the judge in WebAssembly, the npm package build-wasm/carom-VERSION.tgz and the page build-wasm/page
#   test      build, then run the tests that a change needs (`ctest ARG…`). The heavy tests run a sample of their cases
#   test all  run all tests with all their cases, the proofs, the browser, the installed libraries and every
#             instruction set
#   proofs    build, check the proofs, and print the axioms of each theorem. Then compare the oracle that is extracted
#             from the proofs with the C++ oracle on 10,000 collisions. It takes six minutes on two cores
#   bench     build, then print the times of solvers, batches, judge and gate. tests/benchmarks/plain_note.cpp is the
#             note in plain C++. The exit status is 1 if a solver takes more than four times as long as this, or if a
#             batch is slower
#   compare   REVISION: run the benchmarks of that revision and of this tree in turn, and print the ratios
#   sanitize  run the tests with assertions, AddressSanitizer and UndefinedBehaviorSanitizer, in build-sanitize
#   tsan      run the tests that start programs and threads under ThreadSanitizer, in build-tsan
#   fuzz      [SECONDS]: run each target of tests/fuzz for that long (default 30) with clang's libFuzzer, in build-fuzz
#   same-cases [CASES]: build the families with other compilers and instruction sets, including 32-bit x86 and 64-bit
#             Arm under qemu, in build-same-cases, and compare every bit of the cases that they draw
#   coverage  run the tests and print the share of the lines of each folder that they run, in build-coverage
#   mutation  change one operator, sign, number, comparison or term of the judge at a time, and check that the tests
#             notice, in build-mutation; `mutation --help` explains its figures
#   lint      run clang-format, shellcheck, and clang-tidy on all files, in build-lint-all
#   lint FILE…  run clang-tidy on these files only, in build-lint; `lint change` takes the files that differ from HEAD
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# packages_of COMPONENT…: the Debian packages that the components need
packages_of() {
  local component
  for component in "$@"; do sed -n "s/^$component //p" src/package/needs.txt | tr ' ' '\n'; done | sort -u
}

program=(impulse judge report program) # `carom` and the components below it
mapfile -t packages < <(packages_of "${program[@]}" kit scenes)
tools=(g++ cmake ninja-build gnuplot-nox)
engines=(libbullet-dev libode-dev libbox2d-dev) # the gate reports an engine as absent if its package is not installed
batch_systems=(openmpi-bin slurm-client slurmctld slurmd) # the tests of docs/guide/scale.md run shards under these
compilers=(clang g++-i686-linux-gnu g++-aarch64-linux-gnu qemu-user) # these build the families, too
judged='/all$|generate|^gate/' # of the judge's benchmarks; those of one subject alone take longer
jobs=$(nproc 2>/dev/null || echo 2)

# install_packages [PACKAGE…]: installs the missing packages among these and those that every build needs
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

# configure PRESET [ARG…]: applies a preset of CMakePresets.json in the directory that the preset names
configure() {
  cmake --preset "$1" -Wno-dev --log-level=WARNING "${@:2}" >/dev/null
}

# Installs the programs that the tests start: the interpreters of the examples, and a reader of the schema.
install_test_programs() {
  local programs=(python3 python3-jsonschema python3-yaml)
  command -v node >/dev/null || programs+=(nodejs)
  install_packages "${programs[@]}" "$@"
}

# Installs the programs of all tests: those of install_test_programs, a browser for the report, the proof checker, the
# compilers that must draw the same cases, and batch systems.
install_all_test_programs() {
  local browser=()
  command -v chromium >/dev/null || browser=(chromium)
  install_test_programs "${browser[@]}"
  install_proof_checker
  (install_packages "${compilers[@]}") || echo "bootstrap: SameCases will be skipped" >&2
  (install_packages "${batch_systems[@]}") || echo "bootstrap: BatchSystems will be skipped" >&2
}

# Installs the proof checker and the compiler of the oracle that is extracted from the proofs.
install_proof_checker() {
  local of_proofs
  mapfile -t of_proofs < <(packages_of proofs)
  install_packages "${of_proofs[@]}"
}

# Installs the npm packages of the replay page. Without them, everything else is built.
install_replay() {
  local folder=src/tool/replay
  [ "$folder/node_modules/.package-lock.json" -nt "$folder/package-lock.json" ] && return
  command -v npm >/dev/null || (install_packages nodejs npm) || true
  (cd "$folder" && npm ci --no-audit --no-fund --loglevel=error >&2) ||
    echo "bootstrap: npm cannot install what replays of scenes are bundled from; the program will write none" >&2
}

# build TARGET [PRESET]: configures all components and builds TARGET
build() {
  install_packages
  install_replay
  configure "${2:-default}" -DCAROM_COMPONENTS=all
  cmake --build build --parallel "$jobs" --target "$1" >&2
}

# Builds the program without scenes. A build directory that has all components keeps them.
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

install_web() {
  local of_web
  mapfile -t of_web < <(packages_of web)
  command -v npm >/dev/null || of_web+=(nodejs npm)
  install_packages "${of_web[@]}"
}

# build_web TARGET…: configures the judge in WebAssembly, with Debian's emscripten, and builds the targets
build_web() {
  npm ci --prefix src/web/page --no-audit --no-fund --loglevel=error >&2
  (
    # Emscripten finds Debian's acorn by NODE_PATH, and trips over `fetch` in later versions of node.
    export NODE_PATH=/usr/share/nodejs NODE_OPTIONS=--no-experimental-fetch
    bash src/web/libraries.sh build-wasm/libraries
    configure wasm
    cmake --build build-wasm --parallel "$jobs" --target "$@" >&2
  )
}

# run_tests DIRECTORY [ARG…]: runs one test more at a time than there are processors, because some tests wait for
# programs that hang.
run_tests() {
  exec ctest --test-dir "$1" --output-on-failure --parallel "$((jobs + 1))" "${@:2}"
}

# Lists Carom's own files whose names match.
sources() {
  find src oracles properties tests docs/examples .ci .github -name node_modules -prune -o -type f "$@" -print
}

# clang-tidy reads unity files if it checks the whole tree, and single files if FILEs are named.
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
    set -- '^(?!.*/replay_page\.cpp$)' # the page of replays as a generated source
  fi
  mapfile -t files < <(sources -name '*.[ch]pp')
  clang-format --dry-run --Werror "${files[@]}" || status=1
  mapfile -t files < <(sources '(' -name '*.sh' -o -path '.ci/*' ')')
  shellcheck "${files[@]}" || status=1
  configure "$preset"
  run-clang-tidy -quiet -p "build-$preset" -checks="$checks" -j "$jobs" "$@" 2> >(grep -v ' warnings\? generated\.$' >&2) || status=1
  return "$status"
}

# Debian packages clang's libFuzzer separately, with the version in the package's name.
install_fuzzer() {
  install_packages clang
  echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -x c++ - -fsanitize=fuzzer,address -o /dev/null 2>/dev/null && return
  local version
  version=$(clang++ -dumpversion)
  install_packages "libclang-rt-${version%%.*}-dev"
}

# fuzz_one TARGET SECONDS: keeps new inputs in build-fuzz/found/TARGET and findings in build-fuzz/findings.
fuzz_one() {
  local target=$1 seconds=$2 directories=("build-fuzz/found/$1" "build-fuzz/tests/fuzz/seeds/$1") options
  [ -d "tests/fuzz/regressions/$target" ] && directories+=("tests/fuzz/regressions/$target")
  options=(-max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 "-artifact_prefix=build-fuzz/findings/$target-")
  case "$target" in json_* | protocol_*) options+=(-dict=tests/fuzz/carom.dict) ;; esac
  mkdir -p "${directories[0]}" build-fuzz/findings
  if "build-fuzz/tests/fuzz/$target" "${options[@]}" "${directories[@]}" >"build-fuzz/$target.log" 2>&1; then
    echo "$target: $(tail -n 1 "build-fuzz/$target.log"), nothing found"
  else
    tail -n 60 "build-fuzz/$target.log"
    echo "$target: a finding; docs/internals/fuzzing.md says what to do with it"
    return 1
  fi
}

# run_scene FILE [ARG…]: writes to build/scenes/NAME and prints the verdict in one line. It judges only every 100th
# impulse of the scene `gas`.
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
time)
  build carom_programs
  exec build/carom time "$@"
  ;;
wasm)
  install_web
  build_web carom_web
  ls -l build-wasm/*.tgz build-wasm/page
  ;;
quick)
  build carom_unit_tests
  run_tests build --label-regex '^unit$' --label-exclude '^thorough$' "$@"
  ;;
test)
  if [ "${1:-}" = all ]; then
    install_all_test_programs
    (install_web) || true # if something is missing, build_web fails below
    mkdir -p build-wasm
    rm -rf build-wasm/*.tgz build-wasm/page build-wasm/tests/web/replay_answers.js # the tests of Web need new ones
    build_web carom_web replay_answers 2>build-wasm/build.log & # its configure scripts need one processor only
    web=$!
    build carom_all_tests everything
    wait "$web" || {
      tail -n 20 build-wasm/build.log >&2
      if [ -e build-wasm/libraries/lib/libmpfr.a ] && [ -e build-wasm/build.ninja ]; then
        echo "bootstrap: the judge in WebAssembly does not compile" >&2
        exit 1
      fi
      echo "bootstrap: the tests Web.* will be skipped, because a tool or a library is missing" >&2
    }
    run_tests build --label-exclude '^sampled$' "${@:2}"
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
  exec python3 tests/proofs/bridge_test.py build/carom build/proofs/proved "${1:-10000}" \
    docs/examples/{contacts.jsonl,head_on.json} docs/findings/engines/witnesses/*.json
  ;;
bench)
  install_packages python3
  build carom_benchmarks everything
  build/tests/benchmarks/solvers --benchmark_out=build/solvers.json --benchmark_out_format=json "$@"
  build/tests/benchmarks/judge_rate "--benchmark_filter=$judged" "$@"
  exec python3 tests/benchmarks/against_note.py build/solvers.json
  ;;
compare)
  revision=${1:?bootstrap: compare needs a REVISION}
  shift
  install_packages python3 git
  build carom_benchmarks everything
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
  run_tests build-sanitize --label-exclude '^sampled$' "$@"
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
  exec bash tests/properties/cases/same_cases.sh . build-same-cases "$@"
  ;;
coverage)
  install_all_test_programs
  install_packages gcovr
  configure coverage
  cmake --build build-coverage --parallel "$jobs" --target carom_all_tests >&2
  find build-coverage -name '*.gcda' -delete
  ctest --test-dir build-coverage --output-on-failure --parallel "$jobs" --label-exclude '^sampled$' "$@" >&2
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
