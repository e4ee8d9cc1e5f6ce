// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal_text.h"

#include <sstream>

#include <gtest/gtest.h>

namespace patina::terminal_text_test {
namespace {

std::string shown(const std::string& text) {
    std::ostringstream terminal;
    TerminalText filter(*terminal.rdbuf());
    std::ostream out(&filter);
    out << text;
    EXPECT_TRUE(out);
    return terminal.str();
}

TEST(TerminalText, EscapeSequences_DoNotReachTheTerminal) {
    EXPECT_EQ(shown("\x1b[31mred\x1b]0;title\a\x7f\r"), "?[31mred?]0;title???");
}

TEST(TerminalText, LinesTabsAndOtherLetters_Do) {
    EXPECT_EQ(shown("a\tb\nGrün “µ”\n"), "a\tb\nGrün “µ”\n");
}

} // namespace
} // namespace patina::terminal_text_test
