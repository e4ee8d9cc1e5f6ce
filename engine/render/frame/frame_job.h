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
#include "render/gpu/step_budget.h"
#include "render/plan/frame_planner.h"

namespace patina {

/// Represents a frame on its way from a scene to a picture: its plan, its targets and how far it
/// is. One job makes one frame after the other of its view and keeps its memory; the jobs of other
/// views, which share what is in the GPU's memory, may take their steps in between.
class FrameJob {
  public:
    enum class Progress { More, Done };
    using Clock = StepBudget::Clock;
    using Deadline = StepBudget::Deadline;
    static constexpr Deadline never = StepBudget::never;

    explicit FrameJob(std::shared_ptr<RenderResources> shared);

    /// Begins a frame in place of the last one, done or not. The scene, and the one of the view's
    /// effects, stay as they are until the first step ends; for the steps that follow the job has
    /// copies. The meshes' triangles stay until the frame is done. Of an environment's samples it
    /// takes at most 256.
    void begin(const Scene& scene, const View& view, const MeshSource& meshes,
               FramePurpose purpose);

    /// Works on the frame until about the deadline. A frame for a window that is known to take
    /// little is finished whatever the deadline, and what such a one lacks is made one thing at a
    /// step. The picture does not depend on the steps. Done is one, too, that cannot be drawn.
    Progress step(Deadline deadline);
    Progress step(std::chrono::milliseconds patience) { return step(Clock::now() + patience); }

    /// Why there is no frame; nothing when all is well.
    const std::optional<Error>& failure() const { return failure_; }

    /// Returns a number that tells which programs are missing: 0 when all are there, and the same
    /// while the same ones are missing. The frame was just begun.
    std::uint64_t missingPrograms();

    /// Says of a sketch that the whole frame takes little, or hardly more than it did.
    bool isNeedless() const { return isNeedless_; }

    /// Tells whether the frame has the same meshes in view as this scene, so that it is worth
    /// finishing first. It is one that takes several steps.
    bool hasMeshesOf(const Scene& scene) const;

    /// Notes what the frame for a window has taken, with all its steps: the next one goes by it.
    void noteTime(double milliseconds) { passes_.solid.noteTime(milliseconds); }

    /// Brings the frame into a framebuffer, tone mapped and sRGB encoded; below a share of 1 it is
    /// mixed with what is there. A sketch is shown whole.
    void show(unsigned framebuffer, double share = 1.0);

    /// Returns the frame as linear floats (RGBA, straight alpha), with the exposure in them, or as
    /// the 8-bit display values / 255. An exposure that is given takes the place of the scene's.
    Result<Image> read(bool display, std::optional<double> exposure = {});

    /// Samples per pixel of the environment's light in the picture; 0 where programs look at none.
    int environmentSamples() const { return gpu_.environment.samples(); }

    /// Returns the light of the scene's environment in small, as the last frame had it; it stays
    /// until the next one is begun.
    EnvironmentRadiance environmentRadiance() const { return gpu_.environment.radiance(); }

    /// Tells whether the picture of an environment is there, in this size.
    bool holdsPicture(glm::ivec2 size) const { return gpu_.environment.holds(size); }

    /// Gives the buffers that a frame is drawn in back to the driver; the next frame makes them
    /// again.
    void releaseTargets();

    /// The figures of the last frame that was drawn.
    const FrameReport& report() const { return gpu_.report; }

  private:
    /// Holds what a frame that takes several steps shows.
    struct Kept {
        Scene scene;
        std::optional<Scene> effects;
    };

    /// Says how far the frame is.
    struct Cursor {
        std::size_t prepared = 0; ///< so many of the passes
        bool isFirstStep = true;
        bool isKept = false;
        bool isDrawing = false;
        bool areObjectsDrawn = false;
        bool isDone = false;
    };

    void followCatalog();
    void makePlan(const Scene& scene, const MeshSource& meshes, bool holdsEffects = false);
    void beginReport();
    Progress pause();
    Progress fail(const Error& error);
    std::size_t passCount() { return passes_.prepared(gpu_.data).size(); }
    bool prepare(Deadline began, Deadline deadline);
    bool prepareSome();
    bool isLarge();
    Progress draw(Deadline deadline);
    bool drawPasses(std::span<Pass* const> passes);
    bool drawObjects();
    Progress finish();
    void prewarm();
    void drawUnseen();
    bool hasHeldPrograms();
    void showIn(unsigned framebuffer, glm::ivec2 size, double exposure, double share = 1.0);

    std::shared_ptr<RenderResources> shared_;
    std::shared_ptr<const Catalog> catalog_; ///< the one that the passes know
    FramePurpose purpose_ = FramePurpose::Window;
    FramePlanner planner_;
    FramePlan plan_;
    FrameGpu gpu_;
    FramePasses passes_;
    StepBudget budget_{gl::isSoftware()};
    FrameDescription description_;
    std::optional<Error> failure_;
    Clock::time_point began_;
    Cursor at_;
    bool isNeedless_ = false;
    View view_;          ///< as it is drawn
    glm::ivec2 size_{0}; ///< of the picture
    double exposure_ = 0.0;
    Kept kept_;
    MeshSource meshes_; ///< of a frame that is drawn for its programs
};

} // namespace patina
