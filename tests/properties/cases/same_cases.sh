#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Draws the same cases with other compilers and for other instruction sets, and compares every bit:
#
#  same_cases.sh SOURCE WORK [CASES]
#
# The script builds the families and same_cases_main.cpp in each way below, in the folder WORK, and runs the program.
# The checksums of the first thousand cases of each family must equal first_thousand.txt. Those of the first CASES
# (default 20000) must equal those of the first build. `src/bootstrap.sh same-cases` installs the compilers for other
# machines. Exit status: 0 if all builds draw the same cases, 1 if one build draws others, 77 if some could not be built
# and the others agree.
set -euo pipefail

source=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)
cases=${3:-20000}
table=$source/tests/properties/cases/first_thousand.txt
foreign=(i386 arm64)

# The compile option of the families. Without this option the cases may differ, so the script ends here if
# properties/CMakeLists.txt lacks it.
contraction=$(grep -o -m 1 -e '-ffp-contract=off' "$source/properties/CMakeLists.txt")

# Links the folders under the names that headers use, and the libraries whose headers are the same on every machine.
include() {
  mkdir -p "$work/include/carom"
  ln -sfn "$source/src/collision" "$work/include/carom/collision"
  ln -sfn "$source/oracles" "$work/include/carom/oracles"
  ln -sfn "$source/properties" "$work/include/carom/properties"
  local library
  for library in CGAL boost fmt; do
    ln -sfn "/usr/include/$library" "$work/include/$library"
  done
}

# Downloads Debian's GMP and MPFR for other architectures, and unpacks them in WORK.
foreign_libraries() {
  local apt=$work/apt arch
  mkdir -p "$apt/lists/partial" "$apt/archives/partial"
  {
    echo "APT::Architectures { \"$(dpkg --print-architecture)\"; $(printf '"%s"; ' "${foreign[@]}")};"
    echo "Dir::State::lists \"$apt/lists\"; Dir::Cache \"$apt\"; APT::Sandbox::User \"root\";"
  } >"$apt/apt.conf"
  # If one package source is out of date, another may still have the packages.
  APT_CONFIG=$apt/apt.conf apt-get update -qq || true
  for arch in "${foreign[@]}"; do
    (cd "$apt" && APT_CONFIG=apt.conf apt-get download -qq "libgmp-dev:$arch" "libmpfr-dev:$arch") || return
    for package in "$apt"/lib*_"$arch".deb; do
      dpkg-deb --extract "$package" "$work/$arch" || return
    done
  done
}

# together NAME FILE…: writes a source that includes the files. Most of a file's compile time is spent on headers, so
# the files of a folder compile together.
together() {
  local name=$1
  shift
  printf '#include "%s"\n' "$@" >"$work/$name.cpp"
}

# draw NAME RUNNER COMPILER [OPTION…]: builds the program, and writes the checksums to NAME.thousand and NAME.all.
draw() {
  local name=$1 runner=$2 part objects=() compiling=()
  shift 2
  mkdir -p "$work/$name"
  for part in cases program; do
    objects+=("$work/$name/$part.o")
    "$@" -std=c++20 -DNDEBUG -DFMT_HEADER_ONLY -isystem "$work/include" -isystem /usr/include/eigen3 "$contraction" \
      -c "$work/$part.cpp" -o "$work/$name/$part.o" &
    compiling+=($!)
  done
  for part in "${compiling[@]}"; do wait "$part"; done
  "$@" "${objects[@]}" -o "$work/$name/same_cases" -lmpfr -lgmp
  # The runner is empty or one word.
  # shellcheck disable=SC2086
  $runner "$work/$name/same_cases" 1000 >"$work/$name.thousand"
  # shellcheck disable=SC2086
  $runner "$work/$name/same_cases" "$cases" >"$work/$name.all"
}

status=0
first=
# not_built NAME REASON
not_built() {
  echo "$1: NOT BUILT, $2"
  [ "$status" -eq 1 ] || status=77
}

# agree NAME RUNNER COMPILER [OPTION…]: draws the cases and compares them.
agree() {
  local name=$1
  if ! command -v "$3" >/dev/null || { [ -n "$2" ] && ! command -v "$2" >/dev/null; }; then
    not_built "$name" "there is no ${2:+$2 or }$3"
    return
  fi
  draw "$@"
  first=${first:-$name}
  if diff "$table" "$work/$name.thousand" && diff "$work/$first.all" "$work/$name.all"; then
    echo "$name: the same cases (${*:3})"
  else
    echo "$name: OTHER CASES (${*:3})"
    status=1
  fi
}

# cross ARCH TRIPLET: prints the options to link libraries of another architecture statically.
cross() { printf '%s\n' -isystem "$work/$1/usr/include/$2" -isystem "$work/$1/usr/include" "-L$work/$1/usr/lib/$2" -static; }

include
together cases "$source"/properties/{draws,features}/*.cpp \
  "$source"/properties/cases/{beyond_domain,body_pairs,choices,families,family,friction,polyhedron,published,sweep}.cpp
together program "$source"/oracles/exact/rational.cpp "$source"/tests/properties/cases/same_cases{,_main}.cpp
agree gcc "" g++ -O2
agree gcc-O0 "" g++ -O0
agree without-packets "" g++ -O2 -DEIGEN_DONT_VECTORIZE
agree native "" g++ -O3 -march=native
agree clang-native "" clang++ -O3 -march=native
if foreign_libraries; then
  mapfile -t options < <(cross i386 i386-linux-gnu)
  # Some kernels run no 32-bit programs, and qemu-i386 runs them everywhere.
  agree x86-32 qemu-i386 i686-linux-gnu-g++ -O2 -msse2 -mfpmath=sse "${options[@]}"
  mapfile -t options < <(cross arm64 aarch64-linux-gnu)
  agree aarch64 qemu-aarch64 aarch64-linux-gnu-g++ -O2 "${options[@]}"
else
  not_built "x86-32 and aarch64" "GMP and MPFR for them cannot be downloaded"
fi
exit "$status"
