// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/cost_subject.h"

#include "document/document.h"
#include "document/scene_edits.h"
#include "resources/environment_library.h"
#include "resources/mesh_library.h"
#include "resources/mesh_snapshot.h"
#include "resources/texture_library.h"

namespace patina {

CostSweep::Subject costSubject(const Document& document, MeshLibrary& meshes,
                               TextureLibrary& textures, EnvironmentLibrary& environments) {
    const Scene scene = document.ownScene(document.selection().side());
    return {scene,
            static_cast<std::size_t>(document.selection().object()),
            scene.camera,
            meshSnapshot(scene, meshes),
            document.sharedCatalog(),
            textures.snapshot(),
            environments.image(environmentPicture(document, document.selection().side()))};
}

} // namespace patina
