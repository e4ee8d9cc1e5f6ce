// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/interaction.h"

#include <utility>

namespace patina {

Interaction::Interaction(std::function<void()> announce) : announce_(std::move(announce)) {}

int Interaction::begin(std::optional<ParameterTarget> dragged) {
    token_ = ++lastToken_;
    dragged_ = std::move(dragged);
    announce_();
    return token_;
}

void Interaction::end(int token) {
    if (token == 0 || token == token_) {
        drop();
        announce_();
    }
}

void Interaction::drop() {
    token_ = 0;
    dragged_.reset();
}

} // namespace patina
