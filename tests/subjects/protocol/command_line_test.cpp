// SPDX-License-Identifier: BSL-1.0
#include <stdexcept>

#include <gtest/gtest.h>

#include <carom/collision/json/text.hpp>
#include <carom/subjects/protocol/command_line.hpp>

namespace carom::subjects::protocol {
namespace {

using Words = std::vector<std::string>;

TEST(Words, AreSplitAndUnquotedAsAShellDoes) {
  EXPECT_EQ(split_words(""), Words{});
  EXPECT_EQ(split_words("  \t\n "), Words{});
  EXPECT_EQ(split_words("python3 solver.py"), (Words{"python3", "solver.py"}));
  EXPECT_EQ(split_words(" a  b\tc "), (Words{"a", "b", "c"}));
  EXPECT_EQ(split_words("'a b' \"c d\""), (Words{"a b", "c d"}));
  EXPECT_EQ(split_words("a'b'\"c\"d"), (Words{"abcd"}));
  EXPECT_EQ(split_words("'' \"\""), (Words{"", ""}));
  EXPECT_EQ(split_words(R"(a\ b \'c \\)"), (Words{"a b", "'c", R"(\)"}));
  EXPECT_EQ(split_words(R"("\"\\\$\`\n")"), (Words{R"("\$`\n)"}));
  EXPECT_EQ(split_words(R"('\n')"), (Words{R"(\n)"}));
  EXPECT_EQ(split_words("a\\\nb"), (Words{"ab"}));
}

TEST(Words, KeepWhatOnlyAShellWouldCarryOut) {
  EXPECT_EQ(split_words("a; rm -r $HOME | b > c & `d` $(e) *?[f] #g ~"),
            (Words{"a;", "rm", "-r", "$HOME", "|", "b", ">", "c", "&", "`d`", "$(e)", "*?[f]", "#g", "~"}));
}

TEST(Words, RefuseAQuotationThatIsNotClosed) {
  for (const char* text : {"'a", "\"a", "a\\", "\"a\\\""}) {
    EXPECT_THROW((void)split_words(text), std::invalid_argument) << text;
  }
}

TEST(Words, AreReadBackAsTheyWereQuoted) {
  for (const char* word : {"", "plain", "two words", "it's", "'", "\\", "\"$HOME\"", "a\nb", "ü"}) {
    EXPECT_EQ(split_words(quoted(word)), Words{word});
  }
}

}  // namespace
}  // namespace carom::subjects::protocol
