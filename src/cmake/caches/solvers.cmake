# SPDX-License-Identifier: BSL-1.0
# The solvers alone: cmake -S . -B build-solvers -C src/cmake/caches/solvers.cmake needs Eigen and nothing else.
set(CAROM_COMPONENTS impulse CACHE STRING "")
