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
    const char* what;     ///< names the kind of number, as in "a time"
    std::string expected; ///< describes what is allowed, as in "seconds above 0 such as 30"
    std::function<bool(double)> holds; ///< tells whether a finite number is allowed
    /// Reads a text; returns nothing for what is not a finite number.
    std::function<std::optional<double>(std::string_view)> read;
};

/// Returns the number that was given. Throws CLI::ValidationError, before anything is done, for
/// what is not a finite number ("nan", "inf", "1e999") or is not allowed.
double optionNumber(const std::string& option, const std::string& text, const OptionNumber& wanted);

/// Adds --seconds, a time above 0.
void addSecondsOption(CLI::App& command, double& seconds, const std::string& description);

} // namespace patina
