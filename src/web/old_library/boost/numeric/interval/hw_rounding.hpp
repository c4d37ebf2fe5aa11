// SPDX-License-Identifier: BSL-1.0
#pragma once

// Boost.Interval cannot change the direction of rounding in WebAssembly. The judge needs intervals of exact numbers
// only, so there is no rounding for built-in types. Code that needs it does not compile.
#include <boost/numeric/interval/rounded_arith.hpp>
#include <boost/numeric/interval/rounding.hpp>
