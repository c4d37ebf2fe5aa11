// SPDX-License-Identifier: BSL-1.0
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include <carom/collision/validate.hpp>

#include "io/input_file.hpp"
#include "io/usage_error.hpp"
#include "target.hpp"

namespace carom::fuzz {
namespace {

class FileOf {
 public:
  explicit FileOf(std::string_view text) : descriptor_(memfd_create("input", MFD_CLOEXEC)) {
    require(write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size()), "no file in memory");
  }
  ~FileOf() { close(descriptor_); }
  FileOf(const FileOf&) = delete;
  FileOf& operator=(const FileOf&) = delete;

  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void read_witness(std::string_view text) {
  try {
    const FileOf file(text);
    tool::JsonFile input(file.path());
    tool::for_each_collision(input, tool::OutOfRange::refused, [](const tool::ReadCollision& read) {
      const bool may_be_invalid = read.witness && read.witness->is_of_invalid();
      require(may_be_invalid || validate(read.one.collision).empty(), "an invalid collision was taken for a valid one");
    });
  } catch (const tool::UsageError&) {
    return;
  }
}

}  // namespace
}  // namespace carom::fuzz

CAROM_FUZZ_TARGET(json_witness) {
  carom::fuzz::read_witness(carom::fuzz::Input({data, size}).text());
  return 0;
}
