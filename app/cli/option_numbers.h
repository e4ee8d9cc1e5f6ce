// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace patina {

/// Holds what a number on the command line has to be.
struct OptionNumber {
    const char* what;                  ///< "a time"
    std::string expected;              ///< "seconds above 0 such as 30"
    std::function<bool(double)> holds; ///< asked of finite numbers only
    /// How a text is read; what is no finite number gives nothing.
    std::function<std::optional<double>(std::string_view)> read;
};

/// The number that was given. Throws CLI::ValidationError, before anything is done, for what is no
/// finite number ("nan", "inf", "1e999") or not as it has to be.
double optionNumber(const std::string& option, const std::string& text, const OptionNumber& wanted);

/// Adds --seconds, a time above 0.
void addSecondsOption(CLI::App& command, double& seconds, const std::string& description);

} // namespace patina
