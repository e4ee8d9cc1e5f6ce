// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

#include "cli/cli.h"
#include "editor/editor.h"

int main(int argc, char** argv) {
    // A file over the allowed size is then an error of the call that writes it, as a full disk is.
    std::signal(SIGXFSZ, SIG_IGN);
    if (argc > 1 && patina::isCommand(argv[1])) {
        return patina::runCommand(argc, argv);
    }
    return patina::runEditor(argc, argv);
}
