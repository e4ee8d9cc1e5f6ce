// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

#include <unistd.h>

#include "support/program.h"

namespace patina::tests {

/// Holds the state letter and the parent in /proc/<pid>/stat; factsOf() gives nothing when there is
/// no such process.
struct ProcessFacts {
    char state = 0;
    pid_t parent = 0;
};
inline std::optional<ProcessFacts> factsOf(pid_t process) {
    const std::string stat = readFile("/proc/" + std::to_string(process) + "/stat");
    const auto name = stat.rfind(')');
    ProcessFacts facts;
    if (name == std::string::npos ||
        std::sscanf(stat.c_str() + name + 1, " %c %d", &facts.state, &facts.parent) != 2) {
        return std::nullopt;
    }
    return facts;
}

inline bool isAlive(pid_t process) {
    const auto facts = factsOf(process);
    return facts && facts->state != 'Z';
}

/// Returns a living child of a process.
inline std::optional<pid_t> childOf(pid_t parent) {
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const pid_t process = std::atoi(entry.path().filename().c_str());
        const auto facts = process > 0 ? factsOf(process) : std::nullopt;
        if (facts && facts->parent == parent && facts->state != 'Z') {
            return process;
        }
    }
    return std::nullopt;
}

/// Waits until `isSo` returns true, at most ten seconds; returns false when it never did.
inline bool eventually(const std::function<bool()>& isSo) {
    using namespace std::chrono_literals;
    for (int i = 0; i < 2000 && !isSo(); ++i) {
        std::this_thread::sleep_for(5ms);
    }
    return isSo();
}

} // namespace patina::tests
