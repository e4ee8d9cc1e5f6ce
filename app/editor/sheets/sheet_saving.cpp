// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/sheet_saving.h"

#include <string>
#include <utility>

#include "material/file_suffixes.h"
#include "material/preset_file.h"
#include "sheet/sheet_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& preset, const Material& material, const Catalog& catalog) {
    const auto reading = readPreset(preset, catalog);
    return reading && reading->material == material;
}

bool mayName(const fs::path& file, const fs::path& preset) {
    std::error_code unknown; // then it may not
    return isShippedPreset(preset) ||
           fs::equivalent(preset.parent_path(), file.parent_path(), unknown);
}

/// Returns the first of "name", "name 2", "name 3" ... in the sheet's folder that is free or holds
/// the material.
fs::path presetBeside(const fs::path& file, const std::string& stem, const Material& material,
                      const Catalog& catalog) {
    const auto called = [&](int number) {
        const std::string name = number == 1 ? stem : stem + ' ' + std::to_string(number);
        return file.parent_path() / (name + std::string(presetSuffix));
    };
    int number = 1;
    while (fs::exists(fs::symlink_status(called(number))) &&
           !holds(called(number), material, catalog)) {
        ++number;
    }
    return called(number);
}

} // namespace

Result<Sheet> saveSheet(const fs::path& file, Sheet sheet, const Material& start,
                        const Catalog& catalog) {
    const fs::path whole = fs::absolute(file);
    std::string stem = whole.filename().string();
    if (stem.ends_with(sheetEnding)) {
        stem.resize(stem.size() - sheetEnding.size());
    }
    if (sheet.name.empty()) {
        sheet.name = stem;
    }
    const bool isNamed = !sheet.preset.empty() && mayName(whole, sheet.preset) &&
                         holds(sheet.preset, start, catalog);
    if (!isNamed) {
        const fs::path preset = presetBeside(whole, stem, start, catalog);
        if (!fs::exists(preset)) {
            if (const auto written = writePreset(preset, start, catalog); !written) {
                return tl::unexpected(written.error());
            }
        }
        sheet.preset = preset.string();
    }
    return writeSheet(whole, sheet).map([&sheet] { return std::move(sheet); });
}

} // namespace patina
