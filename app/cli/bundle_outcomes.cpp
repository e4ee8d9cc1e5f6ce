// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bundle_outcomes.h"

#include <iostream>

#include <fmt/format.h>

#include "cli/command.h"

namespace patina {

bool tellOutcomes(const std::vector<BundleOutcome>& outcomes, const std::string& file) {
    bool isAllDone = true;
    for (const BundleOutcome& outcome : outcomes) {
        if (outcome.problem.empty()) {
            std::cout << outcome.name << '\n';
        } else {
            isAllDone = false;
            report({Error{file, 0, 0, fmt::format("{}: {}", outcome.name, outcome.problem), {}}});
        }
    }
    return isAllDone;
}

} // namespace patina
