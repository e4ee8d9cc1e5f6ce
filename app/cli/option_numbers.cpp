// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/option_numbers.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/number_text.h"

namespace patina {

double optionNumber(const std::string& option, const std::string& text,
                    const OptionNumber& wanted) {
    const std::optional<double> number = wanted.read(text);
    if (!number || !wanted.holds(*number)) {
        throw CLI::ValidationError(
            option, fmt::format("not {}: \"{}\"; expected {}", wanted.what, text, wanted.expected));
    }
    return *number;
}

void addSecondsOption(CLI::App& command, double& seconds, const std::string& description) {
    command
        .add_option_function<std::string>(
            "--seconds",
            [&seconds](const std::string& text) {
                seconds = optionNumber("--seconds", text,
                                       {"a time", "seconds above 0 such as 30",
                                        [](double time) { return time > 0.0; }, parseNumber});
            },
            description)
        ->default_str(fmt::format("{}", seconds));
}

} // namespace patina
