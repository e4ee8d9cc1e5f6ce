// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/image.h"
#include "render/gpu/texture_source.h"
#include "render/surfaces/pixel_probe.h"
#include "render/view.h"

namespace patina {

struct SurfaceBuffer;

/// Draws scenes with OpenGL 4.1 core. Made, used and destroyed with one context current.
class Renderer {
  public:
    struct Options {
        std::filesystem::path programCache; ///< folder for program binaries; empty: none on disk
    };

    static Result<std::unique_ptr<Renderer>> create(Options options);
    ~Renderer();

    /// Blocks may have changed on disk: sources are assembled anew; programs that still assemble to
    /// the same text are kept, and the last good one is used where the new one does not compile.
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Where the images of materials come from; without one none are shown.
    void setTextures(TextureSource source);

    /// Draws into a framebuffer object of the current context, tone mapped and sRGB encoded.
    /// The report is valid until the next call; drawing allocates nothing when only values changed.
    const FrameReport& draw(const Scene& scene, const View& view, const MeshSource& meshes,
                            unsigned framebuffer);

    /// As draw(), for a window that must not stand still: a frame of very many triangles, or one
    /// that takes long, is only prepared, and the result is false. Then proceed() draws it bit by
    /// bit, each time for about as long as `patience`, until it is true, and show() brings it into
    /// a framebuffer. Until then the meshes' triangles stay where they are. Another frame, drawn or
    /// captured, takes the place of one that is not done. Of an environment's samples it takes at
    /// most 256.
    bool drawSmall(const Scene& scene, const View& view, const MeshSource& meshes,
                   unsigned framebuffer);
    bool proceed(std::chrono::milliseconds patience);

    enum class Sketch {
        Needless, ///< the whole frame takes little, or hardly more than its sketch would
        Begun,    ///< goes on with proceed() and show(), as drawSmall()
        Shown
    };

    /// A first look at a frame that may take long: half as wide and high, with one sample per pixel
    /// and stretched to the view's size. Only begun where `patience` is over before it is done.
    Sketch sketch(const Scene& scene, const View& view, const MeshSource& meshes,
                  unsigned framebuffer, std::chrono::milliseconds patience);

    /// What the last drawSmall(), with all that followed, has taken: the next one goes by it.
    void noteTime(double milliseconds);
    void show(unsigned framebuffer);

    /// Whether a frame of this view would have to wait for programs to be made or loaded: 0 if not,
    /// else a number that is the same while the same ones are lacking. Takes the place of a frame
    /// that is not done.
    std::uint64_t missingPrograms(const Scene& scene, const View& view, const MeshSource& meshes);

    /// Makes what a frame of this view is drawn into, while its programs are made elsewhere. Takes
    /// the place of a frame that is not done.
    void makeTargets(const Scene& scene, const View& view, const MeshSource& meshes);

    /// Makes the programs that a frame of this view would need, so that it need not wait for them.
    /// Nothing is shown, and the report stays; false when they are all there. Takes the place of a
    /// frame that is not done.
    bool prewarm(const Scene& scene, const View& view, const MeshSource& meshes);

    /// Samples per pixel of the environment's light in the picture that was drawn last; 0 where
    /// programs look at none.
    int environmentSamples() const;

    /// Whether the frame that is not done has the same meshes in view as this scene, so that it is
    /// worth finishing first.
    bool hasMeshesOf(const Scene& scene) const;

    /// The same frame as linear floats before tone mapping (RGBA, straight alpha), or as the
    /// 8-bit display values / 255 when `display` is true. With an environment, a continued view is
    /// not drawn again where its picture is still there.
    Result<Image> capture(const Scene& scene, const View& view, const MeshSource& meshes,
                          bool display);

    /// As capture(), for a window that must not stand still: proceed() draws it bit by bit until it
    /// is true, and captured() reads it then. An error: there is nothing to show.
    Result<void> beginCapture(const Scene& scene, const View& view, const MeshSource& meshes);
    Result<Image> captured(bool display);

    /// The numerical check: the frame in muted grey with patterns where a number is not finite or
    /// negative before anything cuts it, or where the surface sends out more than arrives. A
    /// program of its own; draw() gives back what it took.
    const FrameReport& drawInspection(const Scene& scene, const View& view,
                                      const MeshSource& meshes, unsigned framebuffer);

    /// The same frame as drawInspection() shows it, or as it is before that: luminance in red,
    /// PixelDefect in green.
    Result<Image> captureInspection(const Scene& scene, const View& view, const MeshSource& meshes,
                                    bool display);

    /// The numbers of one pixel of that frame, (0, 0) at the top left; nothing where there is no
    /// object. Draws only that pixel.
    Result<std::optional<PixelProbe>> probe(const Scene& scene, const View& view,
                                            const MeshSource& meshes, glm::ivec2 pixel);

    /// What the programs of that frame have for each pixel, with one sample per pixel and all
    /// objects drawn as opaque ones, without the ground. Of an environment it has this round of
    /// directions, as frames draw them that are too short to look for the model's lobe.
    Result<SurfaceBuffer> captureSurfaces(const Scene& scene, const View& view,
                                          const MeshSource& meshes, int round = 0);

    /// The most directions of an environment that such a frame may draw: whole rounds.
    static constexpr int plainSamples = 12;

    /// Gives the buffers that a frame is drawn in back to the driver; the next frame makes them
    /// again. Programs and meshes stay.
    void releaseTargets();

    /// Returns the figures of the last draw or capture.
    const FrameReport& report() const;

  private:
    Renderer();
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
