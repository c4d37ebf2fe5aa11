// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>

#include <carom/collision/stepper.hpp>
#include <carom/subjects/protocol/exec.hpp>

namespace carom::subjects::protocol {

/// A program that answers `run`, from its specification "exec:PROGRAM ARG…". No shell is run. A session starts the
/// program once, and anew after a failure. A program that ends, hangs or writes no reply gives the answer Failed. If
/// the program cannot be started, or does not step, the stepper has the specification as its name, and `absent` has the
/// reason. Precondition: the specification begins with exec_prefix.
[[nodiscard]] Stepper exec_stepper(const std::string& specification, const ExecOptions& options);

}  // namespace carom::subjects::protocol
