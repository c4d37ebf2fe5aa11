// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <carom/subjects/protocol/command_line.hpp>

namespace carom::subjects::protocol {
namespace {

bool is_one_of(char letter, std::string_view letters) { return letters.find(letter) != std::string_view::npos; }

class Splitter {
 public:
  explicit Splitter(std::string_view text) : text_(text) {}

  std::vector<std::string> words() {
    while (at_ < text_.size()) {
      const char letter = text_[at_++];
      if (is_one_of(letter, " \t\n")) {
        end_word();
      } else if (letter == '\'') {
        until_quote();
      } else if (letter == '"') {
        until_double_quote();
      } else if (letter == '\\') {
        escaped();
      } else {
        add(letter);
      }
    }
    end_word();
    return words_;
  }

 private:
  void add(char letter) {
    in_word_ = true;
    word_ += letter;
  }

  void end_word() {
    if (in_word_) {
      words_.push_back(word_);
    }
    word_.clear();
    in_word_ = false;
  }

  /// Outside of quotes, a backslash removes a line end, and makes any other character literal.
  void escaped() {
    if (at_ == text_.size()) {
      throw std::invalid_argument("the command ends with \\; remove it, or double it");
    }
    const char letter = text_[at_++];
    if (letter != '\n') {
      add(letter);
    }
  }

  void until_quote() {
    in_word_ = true;
    while (at_ < text_.size() && text_[at_] != '\'') {
      add(text_[at_++]);
    }
    close('\'');
  }

  /// Within double quotes, a backslash escapes only characters that are special there.
  void until_double_quote() {
    in_word_ = true;
    while (at_ < text_.size() && text_[at_] != '"') {
      const char letter = text_[at_++];
      if (letter == '\\' && at_ < text_.size() && is_one_of(text_[at_], "$`\"\\\n")) {
        escaped();
      } else {
        add(letter);
      }
    }
    close('"');
  }

  void close(char quote) {
    if (at_ == text_.size()) {
      throw std::invalid_argument(std::string("a quote is not closed; add ") + quote);
    }
    ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool in_word_ = false;
  std::string word_;
  std::vector<std::string> words_;
};

}  // namespace

std::vector<std::string> split_words(std::string_view text) { return Splitter(text).words(); }

}  // namespace carom::subjects::protocol
