// SPDX-License-Identifier: BSL-1.0
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include <carom/collision/json/text.hpp>

#include "commands/commands.hpp"
#include "io/memory_reserve.hpp"

namespace {

/// What is wrong may be told in words of a file or a program. Where it cannot be written, the exit status says it.
void complain(const std::string& what) {
  if (carom::tool::has_run_out_of_memory()) {
    std::fputs(carom::tool::out_of_memory, stderr);  // whatever came of it
    return;
  }
  constexpr std::size_t longest = 20'000;
  std::fputs(fmt::format("carom: {}\n", carom::printable(what, longest)).c_str(), stderr);
}

}  // namespace

int main(int argc, char** argv) {
  // Output that cannot be written is an error to tell, and not the end of a program that has reports to write.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return carom::tool::run_command_line(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs(carom::tool::out_of_memory, stderr);
  } catch (const std::system_error& error) {
    complain((std::ferror(stdout) != 0 ? "standard output: " : "") + std::string(error.what()));
  } catch (const std::exception& error) {
    complain(error.what());
  } catch (...) {
    complain("ended by what is no exception");
  }
  return carom::report::exit_usage;
}
