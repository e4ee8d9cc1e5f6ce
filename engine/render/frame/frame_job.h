// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "core/image.h"
#include "gl/driver.h"
#include "render/frame/frame_description.h"
#include "render/frame/frame_passes.h"
#include "render/frame/pass_stopwatch.h"
#include "render/gpu/step_budget.h"
#include "render/plan/frame_planner.h"

namespace patina {

/// Makes a picture of a scene in steps. One job makes one frame after the other of its view and
/// keeps its memory; the jobs of other views, which share meshes, images and programs, may take
/// their steps in between.
class FrameJob {
  public:
    enum class Progress { More, Done };
    using Clock = StepBudget::Clock;
    using Deadline = StepBudget::Deadline;
    static constexpr Deadline never = StepBudget::never;

    explicit FrameJob(std::shared_ptr<RenderResources> shared);

    /// Begins a frame; the last one is dropped if it is not done. The scene and the view's scene of
    /// effects must not change until the first step ends; for later steps the job has copies. The
    /// meshes must not change until the frame is done. It takes at most 256 samples of an
    /// environment.
    void begin(const Scene& scene, const View& view, const MeshSource& meshes,
               FramePurpose purpose);

    /// Works on the frame until about the deadline. A frame for a window that is known to be quick
    /// is finished in spite of the deadline; programs and images that are missing for it are made
    /// one per step. The picture does not depend on the steps. A frame that cannot be drawn is
    /// Done, too; see failure().
    Progress step(Deadline deadline);
    Progress step(std::chrono::milliseconds patience) { return step(Clock::now() + patience); }

    /// Returns why there is no frame; nothing when there is one.
    const std::optional<Error>& failure() const { return failure_; }

    /// Returns 0 when all programs of the frame are there, else a hash of those that are missing.
    /// It must be called right after begin().
    std::uint64_t missingPrograms();

    /// Returns true for a sketch that is not worth its time: the whole frame takes little time, or
    /// hardly more.
    bool isNeedless() const { return isNeedless_; }

    /// Returns true when the frame shows the same meshes as this scene, so that it is worth
    /// finishing first. It is meant for a frame that takes several steps.
    bool hasMeshesOf(const Scene& scene) const;

    /// Notes the time that a window's frame has taken in all its steps, by which the next one is
    /// cut into tiles.
    void noteTime(double milliseconds) { passes_.solid.noteTime(milliseconds); }

    /// Has the passes of frames timed from now on, each as it is waited for; null: no more. What is
    /// before the first pass counts as "preparation", show() as "picture passes and tone curve".
    void setStopwatch(PassStopwatch* stopwatch) { stopwatch_ = stopwatch; }

    /// Takes the values of the passes, of the exposure and of the tone curve from the scene, so
    /// that show() draws the last picture with them. Returns false where that picture is not there
    /// any more, or the programs for `effects`, which is the scene whose effects the programs have.
    bool takePasses(const Scene& scene, const Scene& effects);

    /// Draws the picture into a framebuffer, tone mapped and sRGB encoded. A `share` below 1 blends
    /// it with what is there, except for a sketch. Does nothing after a failure.
    void show(unsigned framebuffer, double share = 1.0);

    /// Returns the picture, RGBA with straight alpha and rows from the top: if `display` as 8-bit
    /// display values / 255, else as linear floats multiplied by the exposure. `exposure`, in
    /// stops, replaces the scene's. The error is failure() or that of the driver.
    Result<Image> read(bool display, std::optional<double> exposure = {});

    /// Returns the samples per pixel of the environment's light in the picture; 0 where none are
    /// taken.
    int environmentSamples() const { return gpu_.environment.samples(); }

    /// Returns EnvironmentLight::radiance() of the last frame, which is valid until the next one is
    /// begun.
    EnvironmentRadiance environmentRadiance() const { return gpu_.environment.radiance(); }

    /// Returns true when a mean of frames with an environment is there, in this size.
    bool holdsPicture(glm::ivec2 size) const { return gpu_.environment.holds(size); }

    /// Returns the size in pixels of what show() draws.
    glm::ivec2 size() const { return size_; }

    /// Returns true when the last frame's picture is there to be read.
    bool hasPicture() const { return hasPicture_ && !failure_; }

    /// Frees the targets that a frame is drawn into; the next frame makes them again. A picture
    /// that passes are drawn over stays, with the depths that they read, for takePasses().
    void releaseTargets();

    /// Returns the report of the last frame that was drawn.
    const FrameReport& report() const { return gpu_.report; }

  private:
    /// Holds copies of the scenes for a frame that takes several steps.
    struct Kept {
        Scene scene;
        std::optional<Scene> effects;
    };

    /// Remembers how far the frame is.
    struct Cursor {
        std::size_t prepared = 0; ///< is the number of passes that are prepared
        bool isFirstStep = true;
        bool isKept = false;
        bool isDrawing = false;
        bool areObjectsDrawn = false;
        bool isDone = false;
    };

    void followCatalog();
    void makePlan(const Scene& scene, const MeshSource& meshes, bool freezesEffects = false);
    void beginReport();
    Progress pause();
    Progress fail(const Error& error);
    std::size_t passCount() { return passes_.prepared(gpu_.data).size(); }
    bool prepare(Deadline began, Deadline deadline);
    bool prepareSome();
    bool isLarge();
    Progress draw(Deadline deadline);
    bool drawPass(Pass& pass);
    void lap(std::string_view name);
    bool drawPasses(std::span<Pass* const> passes);
    bool drawObjects();
    Progress finish();
    void prewarm();
    void drawUnseen();
    bool hasFrozenPrograms();
    void showIn(unsigned framebuffer, glm::ivec2 size, double exposure, double share = 1.0);

    std::shared_ptr<RenderResources> shared_;
    std::shared_ptr<const Catalog> catalog_; ///< is the catalogue that the passes use
    FramePurpose purpose_ = FramePurpose::Window;
    FramePlanner planner_;
    FramePlan plan_;
    PreparedFrame prepared_{plan_};
    FrameGpu gpu_;
    FramePasses passes_;
    StepBudget budget_{gl::isSoftware()};
    FrameDescription description_;
    std::optional<Error> failure_;
    Clock::time_point began_;
    Cursor at_;
    bool isNeedless_ = false;
    bool hasPicture_ = false; ///< says that the last frame's picture is in the targets
    View view_;               ///< is the view as it is drawn, smaller for a sketch
    glm::ivec2 size_{0};      ///< is the size of the picture
    double exposure_ = 0.0;
    Kept kept_;
    PassStopwatch* stopwatch_ = nullptr; ///< is null unless passes are timed
    MeshSource meshes_;                  ///< is empty except while a frame only compiles programs
};

} // namespace patina
