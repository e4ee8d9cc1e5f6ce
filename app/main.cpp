// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <memory>

#include "catalog/xdg_folders.h"
#include "cli/cli.h"
#include "editor/window/editor.h"
#include "trial/trial_command.h"
#include "trial/trial_gate.h"

namespace {

/// What users add to the blocks is compiled elsewhere before it is here.
void guardAgainstStrangers() {
    const auto cache = patina::xdgCacheFolder();
    patina::TrialGate::Options options;
    options.folder = cache ? *cache / "trials" : std::filesystem::path();
    patina::setBlockGate(std::make_shared<patina::TrialGate>(std::move(options)));
}

} // namespace

int main(int argc, char** argv) {
    // A file over the allowed size is then an error of the call that writes it, as a full disk is.
    std::signal(SIGXFSZ, SIG_IGN);
    if (const auto status = patina::runTrialCommand(argc, argv)) {
        return *status;
    }
    guardAgainstStrangers();
    if (argc > 1 && patina::isCommand(argv[1])) {
        return patina::runCommand(argc, argv);
    }
    return patina::runEditor(argc, argv);
}
