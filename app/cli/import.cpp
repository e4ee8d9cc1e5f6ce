// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "catalog/xdg_folders.h"
#include "cli/bundle_outcomes.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

struct ImportOptions {
    std::string file;
    std::string into;
};

bool importPresets(const ImportOptions& options) {
    const auto user = xdgDataFolder();
    if (options.into.empty() && !user) {
        report({Error{options.file, 0, 0, "there is no folder for presets", "--into FOLDER"}});
        return false;
    }
    const fs::path folder = options.into.empty() ? *user / "presets" : fs::path(options.into);
    const auto import = importBundle(options.file, folder);
    if (!import) {
        report({import.error()});
        return false;
    }
    const bool isAllDone = tellOutcomes(import->outcomes, options.file);
    std::cout << "in " << import->folder.string() << '\n';
    return isAllDone;
}

} // namespace

void addImport(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "import", "Unpack the presets and images of such a zip file into a new folder");
    auto options = std::make_shared<ImportOptions>();
    command->add_option("file", options->file, "The zip file")->required();
    command->add_option("--into", options->into,
                        "Where the folder is made; your presets where it is not given");
    command->callback([options, &status] { status = importPresets(*options) ? 0 : 1; });
}

} // namespace patina
