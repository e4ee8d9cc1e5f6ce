// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "core/image.h"
#include "render/gpu/measured_store.h"
#include "render/gpu/texture_source.h"
#include "render/view.h"

namespace patina {

class FrameJob;
class InspectionDrawer;
class OverlayPicture;
class StretchedPicture;
class SurfaceBufferDrawer;
struct RenderResources;
struct ScreenTarget;

inline constexpr int largestShadowTexels = 2048;

/// Draws the frames of one view with OpenGL 4.1 core. Programs, meshes, images and shadow maps may
/// be shared with other views of the same context, which must be current for all calls.
class Renderer {
  public:
    struct Options {
        std::filesystem::path programCache; ///< is the folder of program binaries; empty for none
                                            ///< on disk
        /// Limits the texels of a shadow map per side, a power of two.
        int shadowTexels = largestShadowTexels;
        /// Limits the memory of all shadow maps together.
        std::int64_t shadowBytes = std::int64_t(256) << 20;
    };

    static Result<std::unique_ptr<Renderer>> create(Options options);
    ~Renderer();

    /// Makes a renderer for another view, which shares everything except its frames.
    std::unique_ptr<Renderer> forAnotherView() const;

    /// Sets the catalogue, also after blocks have changed on disk: sources are assembled again.
    /// Programs with the same text are kept, and the last good one is used where a new one does not
    /// compile. It applies to all views that share.
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Returns the catalogue that was set; null before.
    const Catalog* catalog() const;

    /// Sets where the images of materials come from; without a source none are shown. It applies to
    /// all views that share.
    void setTextures(TextureSource source);

    /// Sets where the tables of measured files come from; without a source a frame waits until they
    /// are read. It applies to all views that share.
    void setTables(MeasuredStore::Source source);

    /// Begins a frame; the last one is dropped if it is not done, since a view has one job. The
    /// framebuffer that is shown does not change until FrameJob::show().
    FrameJob& begin(const Scene& scene, const View& view, const MeshSource& meshes,
                    FramePurpose purpose);

    /// Returns the frame that was begun last.
    FrameJob& job() { return *job_; }
    const FrameJob& job() const { return *job_; }

    /// Draws a whole frame into a framebuffer object of the current context, tone mapped and sRGB
    /// encoded, with all the samples of an environment that the view wants. The report is valid
    /// until the next frame and has the errors. Drawing allocates nothing when only values changed.
    const FrameReport& draw(const Scene& scene, const View& view, const MeshSource& meshes,
                            unsigned framebuffer);

    /// Draws a finished picture into the window of the current context, and what is laid over it.
    void showInWindow(const StretchedPicture& picture, const OverlayPicture& overlay);

    /// Draws a finished picture into a target of another size, with its aspect.
    void showUndistorted(const StretchedPicture& picture, const ScreenTarget& target);

    /// Returns the same frame as FrameJob::read() does. With an environment, a continued view is
    /// not drawn again where its picture is still there.
    Result<Image> capture(const Scene& scene, const View& view, const MeshSource& meshes,
                          bool display);

    /// Returns the numerical check, which is made on first use. The next frame for a window
    /// destroys it to free its memory.
    InspectionDrawer& inspection();

    /// Returns the drawer of a frame's surface buffer, which is made on first use and kept.
    SurfaceBufferDrawer& surfaces();

    /// Returns the report of the numerical check while there is one, else of the last frame.
    const FrameReport& report() const;

  private:
    explicit Renderer(std::shared_ptr<RenderResources> shared);

    bool drawAll(const Scene& scene, const View& view, const MeshSource& meshes);

    std::shared_ptr<RenderResources> shared_;
    std::unique_ptr<FrameJob> job_;
    std::unique_ptr<InspectionDrawer> inspection_;  ///< is null unless it is in use
    std::unique_ptr<SurfaceBufferDrawer> surfaces_; ///< is null before its first use
};

} // namespace patina
