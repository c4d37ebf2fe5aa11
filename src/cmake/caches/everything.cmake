# SPDX-License-Identifier: BSL-1.0
# All that there is, in the least time: what bootstrap.sh builds.
set(CAROM_BUILD_TESTS ON CACHE BOOL "")
set(CAROM_UNITY ON CACHE BOOL "")
