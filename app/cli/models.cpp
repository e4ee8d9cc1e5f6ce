// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "catalog/catalog.h"
#include "catalog/descriptor.h"
#include "catalog/settings.h"
#include "catalog/value_json.h"
#include "cli/family_table.h"
#include "scene/picture_choice_text.h"

namespace patina {
namespace {

std::string joined(const std::vector<EnumValue>& values) {
    std::string out;
    for (const EnumValue& value : values) {
        out += (out.empty() ? "" : " | ") + value.id;
    }
    return out;
}

/// Returns a default value as JSON without the newline at its end.
std::string defaultOf(const Parameter& parameter) {
    if (std::holds_alternative<NumberList>(parameter.defaultValue)) {
        return textOf(parameter.defaultValue);
    }
    std::string written = writeJson(toJson(parameter.defaultValue));
    written.pop_back();
    return written;
}

void printParameters(const Block& block) {
    for (const Parameter& parameter : block.parameters) {
        std::cout << fmt::format("    {:<24} {:<7} {:<26} {}\n", parameter.id,
                                 infoOf(parameter.type).word, defaultOf(parameter),
                                 infoOf(parameter.type).range(parameter));
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        std::cout << fmt::format("    {:<24} {:<7} {:<26} {}\n", choice.id, "level",
                                 choice.values.front().id, joined(choice.values));
    }
}

void printBlock(const Block& block) {
    std::cout << fmt::format("  {} - {}{}\n", block.id, block.label,
                             block.shipped ? "" : " (yours)");
    if (!block.summary.empty()) {
        std::cout << "    " << block.summary << '\n';
    }
    printParameters(block);
    std::cout << '\n';
}

/// Returns the kinds of blocks, with the lighting models first.
std::vector<std::string> kindsOf(const Catalog& catalog) {
    std::vector<std::string> kinds;
    for (const Block& block : catalog.blocks) {
        if (kinds.empty() || kinds.back() != block.kind) {
            kinds.push_back(block.kind);
        }
    }
    std::stable_partition(kinds.begin(), kinds.end(),
                          [](const std::string& kind) { return kind == kinds::models; });
    return kinds;
}

/// Describes how exactly a scene's picture is drawn, as settings of its own.
Block pictureSettings() {
    Block picture;
    picture.kind = settingsDescriptors().front().block.kind;
    picture.id = "picture";
    picture.label = "Picture";
    for (const PictureChoiceText& text : pictureChoiceTexts()) {
        AccuracyChoice choice{text.id, text.label, text.doc, {}};
        for (const PictureChoiceText::Level& level : text.levels) {
            EnumValue value;
            value.id = level.id;
            value.label = level.label;
            value.doc = level.doc;
            value.exact = choice.values.empty();
            choice.values.push_back(value);
        }
        picture.accuracy.push_back(choice);
    }
    return picture;
}

std::vector<Block> allSettings() {
    std::vector<Block> all;
    for (const Descriptor& descriptor : settingsDescriptors()) {
        all.push_back(descriptor.block);
    }
    all.push_back(pictureSettings());
    return all;
}

void printTable(const Catalog& catalog) {
    for (const std::string& kind : kindsOf(catalog)) {
        std::cout << kind << "\n\n";
        for (const Block* block : catalog.ofKind(kind)) {
            printBlock(*block);
        }
    }
    std::cout << "settings\n\n";
    for (const Block& block : allSettings()) {
        printBlock(block);
    }
}

void printJson(const Catalog& catalog) {
    nlohmann::json array = nlohmann::json::array();
    for (const Block& block : catalog.blocks) {
        array.push_back(toJson(block));
    }
    for (const Block& block : allSettings()) {
        array.push_back(toJson(block));
    }
    std::cout << writeJson(array);
}

/// Tells whether shipped blocks are there, without which the command fails; mistakes in a user's
/// own block do not make it fail.
bool hasShippedBlocks(const Catalog& catalog) {
    return std::any_of(catalog.blocks.begin(), catalog.blocks.end(),
                       [](const Block& block) { return block.shipped; });
}

} // namespace

void addModels(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "models", "List every block of every kind and the settings of scenes, with parameters");
    auto json = std::make_shared<bool>(false);
    auto family = std::make_shared<bool>(false);
    auto* asJson =
        command->add_flag("--json", *json, "Print an array of the descriptors as they were loaded");
    command
        ->add_flag(
            "--table", *family,
            "Print a table of the lighting models in Markdown: claims, albedo, formula, source")
        ->excludes(asJson);
    command->callback([json, family, &status] {
        const Catalog catalog = loadCatalog(standardBlockRoots());
        report(catalog.errors);
        if (*family) {
            std::cout << familyTable(catalog);
        } else {
            *json ? printJson(catalog) : printTable(catalog);
        }
        status = hasShippedBlocks(catalog) ? 0 : 1;
    });
}

} // namespace patina
