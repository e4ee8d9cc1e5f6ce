// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/material_export.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "core/atomic_file.h"
#include "exchange/format_writers.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

// The first looks say the most; the last one is what is left of a drawing.
constexpr std::array<std::string_view, 6> physicalLooks{
    "metal", "dielectric", "metallic-roughness", "grained-metal", "grained-dielectric", "matte"};
constexpr std::array<std::string_view, 7> openPbrLooks{
    "metal",       "dielectric", "metallic-roughness", "grained-metal", "grained-dielectric",
    "rough-matte", "matte"};
constexpr std::array<std::string_view, 3> classicalLooks{"blinn-phong", "metal", "matte"};

constexpr std::array<ExchangeFormat, 4> formats{{
    {".gltf", "glTF", {physicalLooks, true}},
    {".glb", "glTF, one file", {physicalLooks, true}},
    {".mtlx", "MaterialX", {openPbrLooks, true}},
    {".mtl", "MTL", {classicalLooks, false}},
}};

/// Returns a name that every format can hold, unlike those before it.
std::string usableName(std::string name, std::set<std::string>& used) {
    std::ranges::replace_if(
        name, [](unsigned char letter) { return letter >= 128 || std::isalnum(letter) == 0; }, '_');
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) {
        name = "material_" + name;
    }
    std::string unlike = name;
    for (int number = 2; !used.insert(unlike).second; ++number) {
        unlike = fmt::format("{}_{}", name, number);
    }
    return unlike;
}

/// Returns the files of an export, the images last.
std::vector<ExportedFile> filesOf(const fs::path& file, std::vector<ExportedLook>& looks) {
    std::set<std::string> unused;
    const std::string stem = usableName(file.stem().string(), unused); // a URI has no spaces
    const std::string name = file.filename().string();
    const std::string ending = endingOf(file);
    ExportImages images(stem + "-images");
    std::vector<ExportedFile> files;
    if (ending == ".gltf") {
        std::string buffer;
        files.push_back({name, writeGltf(looks, images, stem + ".bin", buffer)});
        files.push_back({stem + ".bin", std::move(buffer)});
    } else if (ending == ".glb") {
        files.push_back({name, writeGlb(looks, images)});
        return files; // the images are inside
    } else {
        files.push_back(
            {name, ending == ".mtlx" ? writeMaterialX(looks, images) : writeMtl(looks, images)});
    }
    files.insert(files.end(), images.files().begin(), images.files().end());
    return files;
}

Result<void> writeAll(const fs::path& folder, const std::vector<ExportedFile>& files) {
    // The file itself comes last: whoever sees it finds all that it names.
    for (auto file = files.rbegin(); file != files.rend(); ++file) {
        const fs::path path = folder / file->path;
        std::error_code failed;
        fs::create_directories(path.parent_path(), failed);
        if (const auto written = writeFileAtomically(path, file->bytes); !written) {
            return written;
        }
    }
    return {};
}

} // namespace

std::span<const ExchangeFormat> exchangeFormats() {
    return formats;
}

const ExchangeFormat* exchangeFormatOf(const fs::path& file) {
    const auto found = std::ranges::find(formats, endingOf(file), &ExchangeFormat::ending);
    return found == formats.end() ? nullptr : &*found;
}

Result<MaterialExport> exportMaterials(const fs::path& file, const std::vector<Material>& materials,
                                       const Catalog& catalog, const Progress& progress) {
    const ExchangeFormat* format = exchangeFormatOf(file);
    if (format == nullptr) {
        return failure("no format of other programs has this ending", ".gltf, .glb, .mtlx or .mtl");
    }
    std::vector<ExportedLook> looks;
    std::set<std::string> names;
    for (const Material& material : materials) {
        auto look = exportedLook(material, format->looks, catalog, progress);
        if (progress.cancelled) {
            return failure(cancelledExport);
        }
        if (!look) {
            return tl::unexpected(look.error());
        }
        look->material.name = usableName(look->material.name, names);
        looks.push_back(std::move(*look));
    }
    const std::vector<ExportedFile> files = filesOf(file, looks);
    if (const auto written = writeAll(file.parent_path(), files); !written) {
        return tl::unexpected(written.error());
    }
    MaterialExport result;
    for (ExportedLook& look : looks) {
        result.names.push_back(look.material.name);
        result.lines.push_back(std::move(look.lines));
    }
    return result;
}

std::string exportText(const std::vector<ExportLine>& lines) {
    std::string text;
    for (const ExportLine& line : lines) {
        text += fmt::format("  {:<12}  {}: {}\n", wordOf(line.kept), line.what, line.how);
    }
    return text;
}

} // namespace patina
