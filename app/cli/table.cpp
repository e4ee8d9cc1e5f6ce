// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/cost_request.h"
#include "cli/scene_setup.h"
#include "core/atomic_file.h"
#include "measure/lobe/table_files.h"

namespace patina {
namespace {

struct TableOptions {
    std::string preset;
    PictureOptions picture; ///< only its model, its blocks and its values are options
    std::string term = "whole";
    int size = 64;
    std::string out;
    bool hasCode = false;
};

Checked<void> table(const TableOptions& options) {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    report(catalog.errors);
    const auto setup = sceneFor(options.preset, options.picture, catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    const Material& material = setup->scene.objects.front().material;
    const std::string name = material.name.empty() ? material.model.id : material.name;
    const auto made = reflectanceTable(catalog, material, *lobeTermOf(options.term), options.size);
    if (!made) {
        return tl::unexpected(oneError(made.error()));
    }
    if (!options.out.empty()) {
        const auto written = writeFileAtomically(options.out, tableExr(*made, name));
        if (!written) {
            return tl::unexpected(oneError(written.error()));
        }
    }
    std::cout << (options.hasCode ? tableCode(*made, name) : tableText(*made) + '\n');
    return {};
}

std::string checkTableFile(const std::string& file) {
    return endingOf(file) == ".exr" ? std::string() : "expected a file that ends in .exr";
}

} // namespace

void addTable(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "table", "Write a reflectance that two numbers decide as a table for other programs");
    auto options = std::make_shared<TableOptions>();
    command->add_option("preset", options->preset, "A preset (*.patina.json)");
    command->add_option("--model", options->picture.model,
                        "This model in place of the preset's, or by itself with its defaults");
    command->add_option("--set", options->picture.sets, "Set a value: id=value");
    command->add_option("--term", options->term, "The whole model, or a term alone")
        ->check(CLI::IsMember({"whole", "diffuse", "highlight"}));
    command->add_option("--size", options->size, "Texels along each side")
        ->check(CLI::Range(2, 1024))
        ->capture_default_str();
    command->add_option("-o,--output", options->out, "A file: .exr")->check(checkTableFile);
    command->add_flag("--code", options->hasCode, "Print the GLSL code that reads the table");
    command->callback([options, &status] {
        const auto done = table(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
