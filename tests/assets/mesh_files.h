// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "assets/asset_client.h"
#include "support/program.h"

namespace patina::tests {

using LoadedMesh = Result<std::shared_ptr<const SharedMesh>>;

/// Has two triangles in the plane z = 0, seen from +z.
inline constexpr const char* squareObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// Writes a file with this content and loads it as the request says.
inline LoadedMesh loaded(const std::string& name, const std::string& content,
                         MeshRequest request = {}) {
    const TemporaryFolder folder;
    writeFile(folder / name, content);
    request.file = folder / name;
    AssetClient client;
    return client.loadMesh(request);
}

/// Returns the message of a file that must not load; "it loaded" when it did.
inline std::string complaintAbout(const std::string& name, const std::string& content) {
    const LoadedMesh mesh = loaded(name, content);
    return mesh ? "it loaded" : mesh.error().problem;
}

} // namespace patina::tests
