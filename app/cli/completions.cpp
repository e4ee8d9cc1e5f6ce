// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command.h"

namespace patina {
namespace {

/// Returns all options of a command as they are typed.
std::vector<std::string> optionsOf(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
        for (const std::string& name : option->get_snames()) {
            names.push_back("-" + name);
        }
    }
    return names;
}

/// Returns a script for bash: the commands, then each command's options, and files everywhere else.
std::string bashScript(const CLI::App& program) {
    std::vector<std::string> names;
    std::string cases;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        names.push_back(command->get_name());
        cases += fmt::format("        {}) words=\"{}\" ;;\n", command->get_name(),
                             fmt::join(optionsOf(*command), " "));
    }
    return fmt::format(R"(_patina() {{
    local word="${{COMP_WORDS[COMP_CWORD]}}" words=""
    case "${{COMP_WORDS[1]}}" in
{0}    esac
    if [ "$COMP_CWORD" = 1 ]; then
        COMPREPLY=($(compgen -W "{1}" -- "$word"; compgen -f -- "$word"))
    elif [ "${{word#-}}" != "$word" ]; then
        COMPREPLY=($(compgen -W "$words" -- "$word"))
    else
        COMPREPLY=($(compgen -f -- "$word"))
    fi
}}
complete -o filenames -F _patina patina
)",
                       cases, fmt::join(names, " "));
}

std::string zshScript(const CLI::App& program) {
    return "autoload -U +X compinit && compinit\nautoload -U +X bashcompinit && bashcompinit\n" +
           bashScript(program);
}

/// Returns a text in the quotes of fish.
std::string quoted(std::string text) {
    std::string out = "'";
    for (const char letter : text) {
        out += letter == '\'' || letter == '\\' ? std::string("\\") + letter
                                                : std::string(1, letter == '\n' ? ' ' : letter);
    }
    return out + "'";
}

std::string fishScript(const CLI::App& program) {
    std::string text;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        text += fmt::format("complete -c patina -n __fish_use_subcommand -a {} -d {}\n",
                            command->get_name(), quoted(command->get_description()));
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                text += fmt::format(
                    "complete -c patina -n '__fish_seen_subcommand_from {}' -l {} -d {}\n",
                    command->get_name(), name, quoted(option->get_description()));
            }
        }
    }
    return text;
}

} // namespace

void addCompletions(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "completions", "Print a script with which a shell completes commands and options");
    auto shell = std::make_shared<std::string>("bash");
    command->add_option("shell", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->callback([shell, &program, &status] {
        std::cout << (*shell == "fish"  ? fishScript(program)
                      : *shell == "zsh" ? zshScript(program)
                                        : bashScript(program));
        status = 0;
    });
}

} // namespace patina
