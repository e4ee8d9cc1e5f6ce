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
#include "core/mesh.h"
#include "render/environment_image.h"
#include "render/hdr_numbers.h"
#include "render/pixel_probe.h"
#include "render/texture_source.h"
#include "scene/scene.h"

namespace patina {

/// Which frame is wanted, apart from the scene.
struct View {
    glm::ivec2 size{512, 512};      ///< pixels, each at least 1
    Camera camera;
    int samples = 0;                ///< MSAA, lowered to what the driver offers; 0: the scene's own
    HdrNumbers numbers = HdrNumbers::Half; ///< of the linear picture
    /// Whose effects the programs have; nothing: the scene's own. The same objects and lights with
    /// other values, so that a value may pass what makes an effect needless without a new program.
    const Scene* effects = nullptr;
    /// The picture of the scene's environment; nothing: it is not there yet, and black.
    std::shared_ptr<const EnvironmentImage> environmentImage;
    /// Directions per pixel that are drawn for an environment's light, from four on in whole rounds
    /// of four; 0: what takes about as long as the lights.
    int environmentSamples = 0;
    /// Directions of one series have nothing to do with those of another, whatever their number.
    int environmentSeries = 0;
    /// Where a frame that continues stops to add: so many samples are in the picture then.
    int mostSamples = 1 << 24;
    /// Nothing has changed but that more samples are wanted: the picture is the mean of all since
    /// the last frame that was new.
    bool isContinued = false;
};

/// Gives the triangles of a mesh name, or an empty view while it is not there yet.
using MeshSource = std::function<MeshView(const Object&)>;

/// What drawing a frame took and what it was made of.
struct FrameReport {
    int programs = 0;         ///< different programs used
    int compiled = 0;         ///< programs compiled (not found in memory or on disk) for this frame
    int uploadedBuffers = 0;  ///< uniform buffers written
    int drawnObjects = 0;
    int drawCalls = 0;        ///< for the objects; those of one mesh and material share one
    bool isWaiting = false;   ///< images are not whole yet: another frame shows more of them
    int shadowMaps = 0;       ///< depth maps drawn (six for a light that shines everywhere)
    int filledTables = 0;     ///< materials whose blocks' tables were filled (see block_table.h)
    std::vector<std::string> effects; ///< the blocks in the shaders, canonical order
    Errors messages;          ///< compile errors at the block's own file and line, lost lights, ...
    std::size_t warnings = 0; ///< so many of the messages, the last ones, say what was left out of
                              ///< a frame that is otherwise what was asked for
};

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
    std::uint64_t lackedPrograms(const Scene& scene, const View& view, const MeshSource& meshes);

    /// Makes what a frame of this view is drawn into, while its programs are made elsewhere. Takes
    /// the place of a frame that is not done.
    void makeTargets(const Scene& scene, const View& view, const MeshSource& meshes);

    /// Makes the programs that a frame of this view would need, so that it need not wait for them.
    /// Nothing is shown, and the report stays; false when they are all there. Takes the place of a
    /// frame that is not done.
    bool foresee(const Scene& scene, const View& view, const MeshSource& meshes);

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

    /// Of the last draw or capture.
    const FrameReport& report() const;

  private:
    Renderer();
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
