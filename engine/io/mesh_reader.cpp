// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_reader.h"

#include <utility>

#include "io/assimp_reader.h"
#include "io/mesh_finisher.h"

namespace patina {
namespace {

constexpr double shareOfReading = 0.7; // of the whole time, for the progress bar

} // namespace

Result<std::string> readMesh(const std::filesystem::path& file, const MeshOptions& options,
                             const MeshStorage& storage, const ReportProgress& report) {
    const ReportProgress reading = [&](double done) { report(shareOfReading * done); };
    auto raw = readWithAssimp(file, reading);
    if (!raw) {
        return tl::unexpected(raw.error());
    }
    report(shareOfReading);
    return finishMesh(std::move(*raw), options, storage).map_error([&](Error error) {
        error.file = file.string();
        return error;
    });
}

} // namespace patina
