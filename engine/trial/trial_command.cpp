// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/trial_command.h"

#include <cstdio>
#include <string_view>

#include "trial/block_trials.h"
#include "trial/trial_words.h"

namespace patina {

std::optional<int> runTrialCommand(int argc, char** argv) {
    if (argc < 4 || std::string_view(argv[1]) != trialCommandWord) {
        return std::nullopt;
    }
    tryBlocks({argv[2], argv[3], {argv + 4, argv + argc}}, [](const TrialReport& report) {
        std::puts(toLine(report).c_str());
        std::fflush(stdout);
    });
    return 0;
}

} // namespace patina
