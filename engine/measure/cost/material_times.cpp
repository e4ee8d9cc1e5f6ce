// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/material_times.h"

#include "gl/driver.h"
#include "measure/time/timed_frames.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina {
namespace {

constexpr glm::ivec2 timesSizeOnCpu{256, 256};
constexpr glm::ivec2 timesSizeOnDevice{1024, 1024};
constexpr int pairsOfMaterial = 9;

/// Times frames of the subject's object with one material after the other.
class MaterialFrames {
  public:
    MaterialFrames(const CostSweep::Subject& subject, TimedFrames& frames)
        : subject_(subject), frames_(frames) {
        scene_ = subject.scene;
        scene_.ground.mode = GroundMode::Off;
        view_.size = frames.size();
        view_.camera = subject.camera;
        view_.environmentImage = subject.environment;
        view_.samples = 1;
    }

    Result<std::size_t> countPixels() {
        const auto buffer = frames_.renderer().surfaces().capture(scene_, view_, frames_.meshes());
        if (!buffer) {
            return tl::unexpected(buffer.error());
        }
        std::size_t pixels = 0;
        for (std::size_t i = 0; i < buffer->pixels(); ++i) {
            pixels += buffer->objectAt(i) == subject_.object ? 1 : 0;
        }
        return pixels > 0 ? Result<std::size_t>(pixels)
                          : failure("no pixel shows the object", "a camera that sees it");
    }

    double with(const Material& material) {
        Scene scene = scene_;
        scene.objects[subject_.object].material = material;
        return frames_.timeOf(scene, view_);
    }

    MedianInterval empty() {
        Scene scene = scene_;
        scene.objects[subject_.object].visible = false;
        std::vector<double> times;
        frames_.timeOf(scene, view_); // this only warms up
        for (int i = 0; i < emptyFrames; ++i) {
            times.push_back(frames_.timeOf(scene, view_));
        }
        return medianInterval(std::move(times));
    }

  private:
    const CostSweep::Subject& subject_;
    TimedFrames& frames_;
    Scene scene_;
    View view_;
};

} // namespace

Result<std::vector<MaterialTime>> materialTimes(const CostSweep::Subject& subject,
                                                const std::vector<Material>& materials,
                                                const CostSweep::Options& options,
                                                const std::function<bool()>& isWanted) {
    if (subject.object >= subject.scene.objects.size() || materials.empty()) {
        return failure("there is nothing to measure", "an object and a material");
    }
    const glm::ivec2 size = options.size.x > 0 ? options.size
                            : gl::isSoftware() ? timesSizeOnCpu
                                               : timesSizeOnDevice;
    auto drawn = TimedFrames::create({subject.catalog, subject.meshes, subject.textures}, size,
                                     options.programCache);
    if (!drawn) {
        return tl::unexpected(drawn.error());
    }
    MaterialFrames frames(subject, **drawn);
    const auto pixels = frames.countPixels();
    if (!pixels) {
        return tl::unexpected(pixels.error());
    }
    const MedianInterval empty = frames.empty();
    std::vector<CostPairs> pairs(materials.size(), CostPairs(options.pairs, empty));
    std::vector<double> firsts;
    for (int round = 0; round <= pairsOfMaterial; ++round) {
        for (std::size_t i = 0; i < materials.size(); ++i) {
            if (!isWanted()) {
                return failure("it was cancelled");
            }
            const double first = frames.with(materials.front());
            const double other = frames.with(materials[i]);
            if (!(*drawn)->problems().empty()) {
                return tl::unexpected((*drawn)->problems().front());
            }
            if (round > 0) { // the first one only warms up
                firsts.push_back(first);
                pairs[i].add(first, other);
            }
        }
    }
    const ExactFrame exact{medianInterval(firsts).median, empty, *pixels};
    std::vector<MaterialTime> times;
    for (const CostPairs& each : pairs) {
        const ChoiceCost cost = withTimes(each.cost(), exact);
        times.push_back({cost.nanosecondsPerPixel, cost.belowNoise});
    }
    return times;
}

} // namespace patina
