// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assets/file_rights.h"
#include "assets/mesh_block.h"
#include "assets/texture_maker.h"
#include "core/error.h"
#include "core/image.h"
#include "core/mesh.h"
#include "core/progress.h"

namespace patina {

/// Holds what to do to a mesh while it is read.
struct MeshRequest {
    std::filesystem::path file;
    bool fitUnitBox = false; ///< centres the mesh and scales it to fit a cube from -1 to 1
    bool flipNormals = false;
    double scale = 1.0;
    bool byMaterial = false; ///< makes the triangles of each material a part of their own

    friend bool operator==(const MeshRequest&, const MeshRequest&) = default;
};

/// Holds a mesh in memory that the files process handed over. The memory is unmapped with the last
/// copy of the pointer.
class SharedMesh {
  public:
    virtual ~SharedMesh() = default;

    /// Returns the parts; there is one at least, and no more where the request did not ask for
    /// them. They are in the order in which the file first uses their materials.
    virtual const std::vector<MeshPartView>& parts() const = 0;

    /// Returns the first part, which is the whole where there is no other one.
    MeshView view() const { return parts().front().view; }

    /// Returns what was repaired while reading ("12 of 500 triangles had no area and were left
    /// out"); empty when nothing was. It is one sentence for the message list, without a final
    /// stop.
    virtual const std::string& remarks() const = 0;
};

/// Talks to the `patina-files` process, which reads and writes every foreign format. The process is
/// started on first use, kept running, limited in memory and time, killed on cancel and started
/// again after a crash. Calls block, so a worker thread should make them; any thread may, and calls
/// queue up.
class AssetClient {
  public:
    struct Options {
        std::filesystem::path program;  ///< is the path of the program; empty for `patina-files`
                                        ///< beside this one, or in ../libexec/patina
        double timeLimitSeconds = 20.0; ///< limits the process' own work on one request, so that a
                                        ///< request does not fail because the machine is busy
        double waitLimitSeconds = 60.0; ///< limits one request by the clock, in case it hangs
        std::size_t memoryLimitBytes = std::size_t(2) << 30;
    };

    explicit AssetClient(Options options);
    AssetClient();
    ~AssetClient();
    AssetClient(const AssetClient&) = delete;
    AssetClient& operator=(const AssetClient&) = delete;

    /// Sets what may be read from now on. At first nothing is withheld and no link is allowed.
    void setRights(FileRights rights);

    /// Returns the paths of the files outside a mesh's folder that the mesh links to and that were
    /// not read last time, because nobody allowed them.
    std::vector<std::string> refusedLinks(const std::filesystem::path& mesh) const;

    /// Reads the whole file as one list of triangles, or as one for each material: node transforms
    /// are applied, each vertex has a normal and a tangent, and vertices are joined and ordered.
    /// Errors name the file and what was wrong, also when the process crashed ("stopped
    /// unexpectedly while reading"), ran out of time or memory, or was cancelled.
    Result<std::shared_ptr<const SharedMesh>> loadMesh(const MeshRequest&, Progress* = nullptr);

    /// Reads PNG, JPEG, EXR, HDR, ...; 8-bit formats are decoded from sRGB to linear. Errors are as
    /// above.
    Result<Image> loadImage(const std::filesystem::path& file, Progress* = nullptr);

    /// Reads an image for a surface and makes its smaller mip levels. Decoding and the levels are
    /// computed on the caller's thread.
    Result<std::shared_ptr<const TexturePicture>>
    loadTexture(const std::filesystem::path& file, TextureDecoding decoding, Progress* = nullptr);

    /// Writes an image atomically, in the format of the file's extension: .png and .jpg are encoded
    /// to sRGB, .exr and .hdr keep linear floats.
    Result<void> saveImage(const std::filesystem::path& file, const Image&, Progress* = nullptr);

    /// Returns the bytes of such a file, for standard output. `extension` has its dot: ".png".
    Result<std::string> encodeImage(const std::string& extension, const Image&);

    enum class Formats { meshes, images };

    /// Starts the process now, in the background, so that the first request finds it warm. Mesh
    /// formats cost 10 ms and 10 MB; image formats 0.3 s and 130 MB, so ask for those only when
    /// an image is sure to follow.
    void warmUp(Formats formats = Formats::meshes);

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
