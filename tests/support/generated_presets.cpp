// SPDX-License-Identifier: GPL-3.0-or-later
// Writes presets of all models with random values into a new folder, each fifth with random blocks
// in its slots and accuracy choices, none with images. The same number gives the same preset:
//
//   patina-generated-presets COUNT FOLDER
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "gpu/random_scenes.h"
#include "material/model_swap.h"
#include "material/preset_file.h"

namespace patina::tests {
namespace {

Material generated(std::uint64_t number, RandomScenes& scenes, const Catalog& catalog) {
    Material material = scenes.scene(number).objects.front().material;
    material.name = fmt::format("Generated {}", number);
    material.textures.clear();
    if (number % 5 != 0) {
        material.parts.clear();
        material.accuracy.clear();
        material.opacity = 1.0;
    }
    const Block& model = *catalog.find(kinds::models, material.model.id);
    std::erase_if(material.parts,
                  [&model](const auto& part) { return !hasPlaceFor(model, part.first); });
    return material;
}

/// Writes "00000.patina.json" and so on; returns the exit status.
int writePresets(const std::filesystem::path& folder, std::uint64_t count) {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    RandomScenes scenes(catalog);
    std::filesystem::create_directories(folder);
    for (std::uint64_t number = 0; number < count; ++number) {
        const auto written = writePreset(folder / fmt::format("{:05}.patina.json", number),
                                         generated(number, scenes, catalog), catalog);
        if (!written) {
            std::cerr << written.error().text() << '\n';
            return 1;
        }
    }
    return 0;
}

} // namespace
} // namespace patina::tests

int main(int argc, char** argv) {
    std::uint64_t count = 0;
    const char* const end = argc == 3 ? argv[1] + std::strlen(argv[1]) : nullptr;
    if (argc != 3 || std::from_chars(argv[1], end, count).ptr != end) {
        std::cerr << "usage: " << argv[0] << " COUNT FOLDER\n";
        return 1;
    }
    return patina::tests::writePresets(argv[2], count);
}
