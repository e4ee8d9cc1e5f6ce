// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/terminal_text.h"

#include <iostream>

#include <unistd.h>

#include "core/text.h"

namespace patina {

TerminalText::int_type TerminalText::overflow(int_type character) {
    if (traits_type::eq_int_type(character, traits_type::eof())) {
        return traits_type::not_eof(character);
    }
    const char c = traits_type::to_char_type(character);
    return terminal_.sputc(c != '\n' && c != '\t' && isControl(c) ? '?' : c);
}

TerminalGuard::TerminalGuard() : plain_(std::cout.rdbuf()), text_(*plain_) {
    if (isatty(STDOUT_FILENO) == 1) {
        std::cout.rdbuf(&text_);
    }
}

TerminalGuard::~TerminalGuard() {
    if (std::cout.rdbuf() == &text_) { // sync_with_stdio() may have given it another
        std::cout.rdbuf(plain_);
    }
}

} // namespace patina
