# SPDX-License-Identifier: GPL-3.0-or-later
# All that there is, in the least time: what bootstrap.sh builds.
set(CAROM_BUILD_TESTS ON CACHE BOOL "")
set(CAROM_UNITY ON CACHE BOOL "")
