#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# Builds what the judge needs in WebAssembly: libraries.sh DIRECTORY. DIRECTORY gets include/ and lib/. GMP and MPFR are
# compiled from Debian's sources. Libraries of headers are linked from /usr/include. A library that is there already is
# not built again.
set -euo pipefail
out=$(realpath -m "${1:?libraries.sh: a DIRECTORY is needed}")
jobs=$(nproc 2>/dev/null || echo 2)
mkdir -p "$out/include" "$out/lib" "$out/sources"
cd "$out"

# source_of PACKAGE: downloads and unpacks Debian's source of PACKAGE, without its patches, into sources/PACKAGE. Debian
# usually lists no sources, so the lists of packages are copied, and name sources in the copy.
source_of() {
  local package=$1
  [ -e "sources/$package/.unpacked" ] && return
  if [ ! -e apt/.updated ]; then
    rm -rf apt
    mkdir -p apt/lists/partial apt/parts
    local file
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources; do
      [ -e "$file" ] && sed -E '/cdrom:/d; s/^deb( |\t|$)/deb-src\1/; s/^Types:.*/Types: deb-src/I' "$file" >"apt/parts/$(basename "$file")"
    done
    apt "update" >/dev/null
    touch apt/.updated
  fi
  rm -rf "sources/$package" "sources/${package}"_*
  mkdir -p "sources/$package"
  (cd sources && apt source --download-only "$package" >/dev/null)
  tar -xf sources/"${package}"_*.orig.tar.* -C "sources/$package" --strip-components=1
  touch "sources/$package/.unpacked"
}

apt() {
  apt-get -qq -o APT::Update::Error-Mode=any -o APT::Sandbox::User="$(id -un)" -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$out/apt/parts" \
    -o "Dir::State::lists=$out/apt/lists" "$@"
}

# emcc starts this compiler for each file. Without emcc, a file takes a fraction of the time.
compiler="$(em-config LLVM_ROOT)/clang-$(em-config CLANG_ADD_VERSION) --target=wasm32-unknown-emscripten"
compiler+=" --sysroot=$(em-config CACHE)/sysroot"

# compile LIBRARY SOURCES MAKE_ARG… -- CONFIGURE_ARG…: builds LIBRARY.a with its own configure script
compile() {
  local library=$1 sources=$2 makes=()
  shift 2
  while [ "$1" != -- ]; do
    makes+=("$1")
    shift
  done
  shift
  echo "libraries: building $library, see $out/$library.log" >&2
  (
    cd "sources/$sources"
    CC_FOR_BUILD=cc emconfigure ./configure --host=none --disable-shared --enable-static CFLAGS=-O2 "$@"
    emmake make -j"$jobs" CC="$compiler" "${makes[@]}"
  ) >"$out/$library.log" 2>&1 || {
    tail -n 20 "$out/$library.log" >&2
    exit 2
  }
}

# install_library LIBRARY SOURCES HEADER: puts the library in place last, because it stands for all
install_library() {
  cp "sources/$2/$3" include/
  cp "$(find "sources/$2" -name "$1.a" | head -n 1)" lib/
}

if [ ! -e lib/libgmp.a ]; then
  source_of gmp
  # Debian's tarball has no doc/. A configure script cannot see the format of doubles in WebAssembly.
  mkdir -p sources/gmp/doc
  printf 'all:\ninstall:\n' >sources/gmp/doc/Makefile.in
  gmp_cv_c_double_format='IEEE little endian' compile libgmp gmp 'SUBDIRS=mpn mpz mpq mpf .' -- --disable-assembly
  grep -q 'define HAVE_DOUBLE_IEEE_LITTLE_ENDIAN 1' sources/gmp/config.h
  install_library libgmp gmp gmp.h
fi
if [ ! -e lib/libmpfr.a ]; then
  source_of mpfr4
  compile libmpfr mpfr4 -C src -- "--with-gmp-include=$out/include" "--with-gmp-lib=$out/lib" --disable-thread-safe
  install_library libmpfr mpfr4 src/mpfr.h
fi
if [ ! -e include/pugixml.cpp ]; then
  source_of pugixml
  cp sources/pugixml/src/pugi* include/
fi
for header in boost CGAL eigen3/Eigen fmt nlohmann; do
  ln -sfn "/usr/include/$header" "include/$(basename "$header")"
done
