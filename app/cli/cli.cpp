// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "cli/command.h"

namespace patina {
namespace {

constexpr std::array<AddCommand, 6> commands{addRender, addCompare,  addEffects,
                                             addEval,   addValidate, addModels};

void addCommands(CLI::App& program, int& status) {
    program.description("Patina edits lighting models. Without a command it opens the editor:\n"
                        "  patina [FILE...]");
    program.set_version_flag("--version", "patina " PATINA_VERSION);
    program.require_subcommand(1);
    for (const AddCommand add : commands) {
        add(program, status);
    }
}

/// Help and version go to standard output and succeed; everything else is a wrong command line.
int answer(const CLI::App& program, const CLI::ParseError& reason) {
    return program.exit(reason, std::cout, std::cerr) == 0 ? 0 : 1;
}

} // namespace

bool isCommand(std::string_view firstArgument) {
    constexpr std::array<std::string_view, 3> flags{"-h", "--help", "--version"};
    if (std::find(flags.begin(), flags.end(), firstArgument) != flags.end()) {
        return true;
    }
    CLI::App program;
    int status = 0;
    addCommands(program, status);
    const std::vector<CLI::App*> all = program.get_subcommands(nullptr);
    return std::any_of(all.begin(), all.end(), [firstArgument](const CLI::App* command) {
        return command->get_name() == firstArgument;
    });
}

int runCommand(int argc, char** argv) {
    CLI::App program("", "patina");
    int status = 0;
    addCommands(program, status);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& reason) {
        return answer(program, reason);
    } catch (const std::exception& reason) {
        std::cerr << "patina: " << reason.what() << '\n';
        return 1;
    }
    std::cout.flush();
    return status != 0 || !std::cout ? 1 : 0; // a full disk behind standard output is a failure
}

void report(const Errors& messages) {
    std::cerr << text(messages);
}

} // namespace patina
