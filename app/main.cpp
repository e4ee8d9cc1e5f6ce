// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli.h"
#include "editor/editor.h"

int main(int argc, char** argv) {
    if (argc > 1 && patina::isCommand(argv[1])) {
        return patina::runCommand(argc, argv);
    }
    return patina::runEditor(argc, argv);
}
