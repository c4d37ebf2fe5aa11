# SPDX-License-Identifier: GPL-3.0-or-later
# The solvers alone: cmake -S . -B build-solvers -C src/cmake/caches/solvers.cmake needs Eigen and nothing else.
set(CAROM_COMPONENTS impulse CACHE STRING "")
