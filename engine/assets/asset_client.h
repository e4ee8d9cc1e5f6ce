// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assets/file_rights.h"
#include "assets/texture_maker.h"
#include "core/error.h"
#include "core/image.h"
#include "core/mesh.h"
#include "core/progress.h"

namespace patina {

/// Holds what to do to a mesh while it is read.
struct MeshRequest {
    std::filesystem::path file;
    bool fitUnitBox = false; ///< uniform scale and centring into [-0.5, 0.5]^3 * 2 (radius one)
    bool flipNormals = false;
    double scale = 1.0;

    friend bool operator==(const MeshRequest&, const MeshRequest&) = default;
};

/// Represents a mesh that lies in memory shared with (or handed over by) the files process.
/// Unmapped with the last copy of the pointer.
class SharedMesh {
  public:
    virtual ~SharedMesh() = default;
    virtual MeshView view() const = 0;

    /// Returns what was repaired while reading ("12 of 500 triangles had no area and were left
    /// out"); empty when nothing was. A sentence for the message list, without a final stop.
    virtual const std::string& remarks() const = 0;
};

/// The client side of the `patina-files` process, which reads and writes every foreign format.
/// Started on first use, kept warm, limited in memory and time, killed on cancel, restarted after
/// a crash. Calls block; make them from a worker thread. Thread-safe: calls queue up.
class AssetClient {
  public:
    struct Options {
        std::filesystem::path program;  ///< empty: `patina-files` beside this program, or in
                                        ///< ../libexec/patina
        double timeLimitSeconds = 20.0; ///< of the process' own work on one request, so that a
                                        ///< busy machine fails no fair one
        double waitLimitSeconds = 60.0; ///< for one request by the clock, for one that hangs
        std::size_t memoryLimitBytes = std::size_t(2) << 30;
    };

    explicit AssetClient(Options options);
    AssetClient();
    ~AssetClient();
    AssetClient(const AssetClient&) = delete;
    AssetClient& operator=(const AssetClient&) = delete;

    /// Sets what may be read from now on. Before, nothing is withheld and no link is allowed.
    void setRights(FileRights rights);

    /// Returns where the links lie that a mesh was last read without: they are outside its folder,
    /// and nobody allowed them.
    std::vector<std::string> refusedLinks(const std::filesystem::path& mesh) const;

    /// Returns a triangle list of the whole file: node transforms applied, normals and tangents
    /// there, vertices joined and ordered. Errors name the file and what was wrong, also when the
    /// process crashed ("stopped unexpectedly while reading"), ran out of time or memory, or was
    /// cancelled.
    Result<std::shared_ptr<const SharedMesh>> loadMesh(const MeshRequest&, Progress* = nullptr);

    /// Writes PNG, JPEG, EXR, HDR, ...; 8-bit formats are decoded from sRGB to linear.
    Result<Image> loadImage(const std::filesystem::path& file, Progress* = nullptr);

    /// Returns an image for a surface, with its smaller versions. Some of the work is done on the
    /// caller's thread.
    Result<std::shared_ptr<const TexturePicture>>
    loadTexture(const std::filesystem::path& file, TextureDecoding decoding, Progress* = nullptr);

    /// Chooses the format by extension: .png and .jpg are encoded to sRGB, .exr and .hdr keep
    /// linear floats. Written atomically.
    Result<void> saveImage(const std::filesystem::path& file, const Image&, Progress* = nullptr);

    /// Returns the bytes of such a file, for standard output. `extension` such as ".png".
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
