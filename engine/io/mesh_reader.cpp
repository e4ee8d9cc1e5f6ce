// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "io/assimp_reader.h"
#include "io/gltf_reader.h"
#include "io/mesh_finisher.h"
#include "io/obj_reader.h"
#include "io/ply_header.h"
#include "io/text_file.h"

namespace patina {
namespace {

// Is the share of reading in the whole time, for the progress bar.
constexpr double shareOfReading = 0.7;

std::string formatOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return std::tolower(c); });
    return extension;
}

/// Tells whether a text format is in UTF-16. The libraries expect supersets of ASCII, and their
/// errors on any other text are misleading.
bool isUtf16Text(const std::filesystem::path& file, const std::string& format) {
    static constexpr std::array<std::string_view, 5> textFormats = {".obj", ".gltf", ".dae", ".ply",
                                                                    ".off"};
    const std::string found = startOf(file, 2);
    return std::ranges::find(textFormats, format) != textFormats.end() &&
           (found == "\xff\xfe" || found == "\xfe\xff");
}

/// Tells whether a byte order mark makes Assimp fail; it skips one in the other formats.
bool hasTextThatMarksHoldUp(const std::string& format) {
    return format == ".ply" || format == ".fbx";
}

using Folder = std::shared_ptr<MeshFolder>;

Result<RawMesh> readGeneralObj(const Folder& folder, const ReportProgress& report) {
    return objForAssimp(folder->file()).and_then([&](const std::optional<std::string>& text) {
        return text ? readWithAssimp(folder, *text, report) : readWithAssimp(folder, report);
    });
}

/// Reads glTF 1.0 with Assimp, which reads the text form but little of the binary one.
Result<RawMesh> readFormerGltf(const Folder& folder, const std::string& format,
                               const ReportProgress& report) {
    auto mesh = readWithAssimp(folder, report);
    if (!mesh && format == ".glb") {
        return failure("is binary glTF 1.0, which is not read here",
                       "glTF 2.0, or 1.0 with its JSON in a .gltf file");
    }
    return mesh;
}

Result<RawMesh> readTriangles(const Folder& folder, bool byMaterial, const ReportProgress& report) {
    const std::filesystem::path& file = folder->file();
    const std::string format = formatOf(file);
    if (isUtf16Text(file, format)) {
        return failure("is text in UTF-16", "UTF-8, in which most programs can save it again");
    }
    if (format == ".ply" && !hasWholePlyHeader(file)) {
        return failure("is not a PLY file, or its header is cut short");
    }
    if (format == ".obj") {
        if (auto mesh = readPlainObj(file, byMaterial, report)) {
            return std::move(*mesh);
        }
        return readGeneralObj(folder, report);
    }
    if (format == ".gltf" || format == ".glb") {
        auto mesh = readGltf(*folder, report);
        if (!mesh) {
            return tl::unexpected(mesh.error());
        }
        if (*mesh) {
            return std::move(**mesh);
        }
        return readFormerGltf(folder, format, report);
    }
    const bool isHeldUp = hasTextThatMarksHoldUp(format) && startsWithMark(file);
    const auto text = isHeldUp ? textOf(file) : std::nullopt;
    return text ? readWithAssimp(folder, *text, report) : readWithAssimp(folder, report);
}

/// Tells whether a mesh is incomplete without a file: materials and images are not needed.
bool isMissed(const MeshFolder::Refused& file) {
    const std::string format = formatOf(file.path);
    static constexpr std::array<std::string_view, 13> looks = {
        ".mtl",  ".png", ".jpg", ".jpeg", ".tga",      ".bmp",   ".tif",
        ".webp", ".dds", ".ktx", ".ktx2", ".material", ".shader"};
    return std::ranges::find(looks, format) == looks.end();
}

/// Appends to the remarks which files the mesh is incomplete without.
std::string withRefused(std::string remarks, const MeshFolder& folder) {
    for (const MeshFolder::Refused& file : folder.refused()) {
        if (isMissed(file)) {
            remarks += (remarks.empty() ? "" : "; ") + refusal("file", file.path).problem;
        }
    }
    return remarks;
}

/// Returns the error to show: where files were refused, that is the reason for all that followed.
Error reasonOf(const Error& error, const MeshFolder& folder) {
    const auto& refused = folder.refused();
    const auto missed = std::ranges::find_if(refused, isMissed);
    return missed == refused.end() || isRefusal(error) ? error : refusal("file", missed->path);
}

} // namespace

Result<MeshReading> readMesh(const Folder& folder, const MeshOptions& options,
                             const MeshStorage& storage, const ReportProgress& report) {
    const ReportProgress reading = [&](double done) { report(shareOfReading * done); };
    std::shared_ptr<void> leftovers;
    return OrdinaryFile::open(folder->file(), maxAssetBytes)
        .and_then(
            [&](const OrdinaryFile&) { return readTriangles(folder, options.byMaterial, reading); })
        .and_then([&](RawMesh mesh) {
            report(shareOfReading);
            leftovers = std::move(mesh.leftovers);
            return finishMesh(std::move(mesh), options, storage);
        })
        .map([&](std::string remarks) {
            return MeshReading{withRefused(std::move(remarks), *folder), leftovers};
        })
        .map_error([&](Error error) {
            error = reasonOf(error, *folder);
            error.file = folder->file().string();
            return error;
        });
}

std::vector<std::string> missedPlaces(const MeshFolder& folder) {
    std::vector<std::string> places;
    for (const MeshFolder::Refused& file : folder.refused()) {
        if (isMissed(file) && std::ranges::find(places, file.place) == places.end()) {
            places.push_back(file.place);
        }
    }
    return places;
}

} // namespace patina
