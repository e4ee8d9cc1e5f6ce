// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

#include "catalog/suggestion.h"
#include "cli/command.h"
#include "cli/terminal_text.h"
#include "gl/driver_cache.h"

namespace patina {
namespace {

constexpr std::array<AddCommand, 17> commands{
    addRender, addCompare, addEffects, addCost,        addEval,       addValidate,
    addModels, addCheck,   addMerge,   addExport,      addImport,     addLobe,
    addMatch,  addSheet,   addTable,   addApproximate, addCompletions};

void addCommands(CLI::App& program, int& status) {
    program.description("Patina edits lighting models. Without a command it opens the editor:\n"
                        "  patina [FILE...]");
    program.set_version_flag("--version", "patina " PATINA_VERSION);
    program.require_subcommand(1);
    for (const AddCommand add : commands) {
        add(program, status);
    }
}

/// Rewords the library's error for an option that is given twice, which speaks of what it requires.
std::string inOurWords(const std::string& reason) {
    constexpr std::string_view theirs = ": At Most 1 required but received ";
    const std::size_t at = reason.find(theirs);
    if (at == std::string::npos) {
        return reason;
    }
    const std::string times = reason.substr(at + theirs.size());
    return reason.substr(0, at) + ": given " + times + " times; expected once";
}

/// Prints help and version to standard output and returns 0; reports everything else as a mistake
/// and returns 1.
int answer(const CLI::App& program, const CLI::ParseError& reason) {
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&reason) != nullptr) {
        std::cerr << inOurWords(reason.what()) << "\nRun with --help for more information.\n";
        return 1;
    }
    return program.exit(reason, std::cout, std::cerr) == 0 ? 0 : 1;
}

std::vector<std::string> commandNames(CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        names.push_back(command->get_name());
    }
    return names;
}

bool isOneOf(std::string_view word, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), word) != names.end();
}

/// Tells whether a word can only be a command, perhaps a misspelt one: small letters, and not the
/// name of a file.
bool looksLikeACommand(std::string_view word) {
    const auto isLetter = [](unsigned char c) { return std::islower(c) != 0; };
    std::error_code status;
    return !word.empty() && std::all_of(word.begin(), word.end(), isLetter) &&
           !std::filesystem::exists(word, status);
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
    return isOneOf(firstArgument, commandNames(program)) || looksLikeACommand(firstArgument);
}

int runCommand(int argc, char** argv) {
    const TerminalGuard guard;
    CLI::App program("", "patina");
    int status = 0;
    addCommands(program, status);
    const std::string first = argc > 1 ? argv[1] : "";
    const std::vector<std::string> names = commandNames(program);
    if (looksLikeACommand(first) && !isOneOf(first, names)) {
        std::cerr << "patina: \"" << first << "\" is no command and no file; expected "
                  << oneOf(first, names) << '\n';
        return 1;
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& reason) {
        return answer(program, reason);
    } catch (const std::exception& reason) {
        std::cerr << "patina: " << reason.what() << '\n';
        return 1;
    }
    if (const auto& note = gl::driverCacheNote()) {
        report({*note});
    }
    std::cout.flush();
    if (!std::cout) {
        std::cerr << "patina: standard output takes no more; expected room on its disk, or a "
                     "reader that stays\n";
        return 1;
    }
    return status;
}

void report(const Errors& messages) {
    std::cerr << text(messages);
}

} // namespace patina
