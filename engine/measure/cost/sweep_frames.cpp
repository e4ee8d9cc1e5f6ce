// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/sweep_frames.h"

#include <algorithm>
#include <utility>

#include "measure/choice/pass_choices.h"
#include "measure/cost/measured_scene.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina {
namespace {

/// Is the number of an environment's directions with which errors of a material are measured. Every
/// frame has the same ones: a frame has too few at once to sample the model's lobe, which depends
/// on the levels.
constexpr int sampledDirections = 4 * SurfaceBufferDrawer::plainSamples;

} // namespace

SweepFrames::SweepFrames(CostSweep::Subject subject, const CostSweep::Options& options,
                         glm::ivec2 size)
    : subject_(std::move(subject)), scope_(options.scope), size_(size) {
    (isOfMaterial() ? leaveSurfaces : leaveGround)(subject_.scene);
    subject_.scene.accuracy = PictureAccuracy(); // the picture has a chart of its own
    const Catalog& catalog = *subject_.catalog;
    choices_ = isOfMaterial() ? materialChoices(subject_.scene, subject_.object, catalog)
                              : choicesOfPicture(subject_.scene, catalog);
    std::erase_if(choices_, [&options](const Choice& choice) {
        return !options.only.empty() &&
               std::ranges::find(options.only, choice.id) == options.only.end();
    });
    counted_ = isOfMaterial() ? sharingMaterial(subject_.scene, subject_.object)
                              : std::vector<bool>(subject_.scene.objects.size(), true);
}

ChosenFrame SweepFrames::of(const ChosenLevels& levels) const {
    ChosenFrame frame{subject_.scene, View()};
    frame.view.size = size_;
    frame.view.camera = subject_.camera;
    frame.view.environmentImage = subject_.environment;
    frame.view.samples = isOfMaterial() ? 1 : 0;
    choose(frame, subject_.object, choices_, levels, *subject_.catalog);
    return frame;
}

ChosenFrame SweepFrames::captured(const ChosenLevels& levels) const {
    ChosenFrame frame = of(levels);
    if (isOfMaterial()) {
        frame.view.numbers = HdrNumbers::Full;
        frame.view.environmentSamples = sampledDirections;
        frame.samplesAtOnce = SurfaceBufferDrawer::plainSamples;
    }
    frame.isFinished = hasPassLevel(levels);
    return frame;
}

ChosenFrame SweepFrames::empty() const {
    ChosenFrame frame = of({});
    if (!isOfMaterial()) {
        frame.scene.passes.clear();
    }
    for (std::size_t i = 0; i < counted_.size(); ++i) {
        frame.scene.objects[i].visible = frame.scene.objects[i].visible && !counted_[i];
    }
    return frame;
}

} // namespace patina
