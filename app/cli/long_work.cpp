// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/long_work.h"

#include <atomic>
#include <csignal>
#include <iostream>

#include <unistd.h>

namespace patina {
namespace {

constexpr const char* emptyLine = "\r\033[K";

std::atomic<bool> stopWished{false};

void wishStop(int) {
    stopWished = true;
    std::signal(SIGINT, SIG_DFL);
}

} // namespace

LongWork::LongWork() : isWatched_(isatty(STDERR_FILENO) == 1) {
    stopWished = false;
    before_ = std::signal(SIGINT, wishStop);
}

LongWork::~LongWork() {
    report({});
    std::signal(SIGINT, before_);
}

bool LongWork::isStopped() const {
    return stopWished;
}

void LongWork::report(const std::string& text) {
    if (isWatched_) {
        std::cerr << emptyLine << text << std::flush;
    }
}

} // namespace patina
