// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame/frame_description.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

/// Appends an item that is not there yet, so that effects keep the order in which objects have
/// them.
template <class Item>
void addOnce(std::vector<Item>& items, const Item& item) {
    if (std::ranges::find(items, item) == items.end()) {
        items.push_back(item);
    }
}

void addEffects(FrameReport& report, const Pipeline* pipeline) {
    if (pipeline == nullptr) {
        return;
    }
    for (const EffectLine& line : effectLines(pipeline->effects)) {
        addOnce(report.effects, line.effect);
    }
}

void addWarning(FrameReport& report, Error error) {
    ++report.warnings;
    report.messages.push_back(std::move(error));
}

} // namespace

void FrameDescription::write(const PreparedFrame& frame, FrameGpu& gpu, ProgramPass& programs,
                             const std::optional<Error>& shadowError) {
    countPrograms(frame, gpu.report);
    const int lostLights = gpu.data.lostLights();
    const int lostShadows = gpu.shadows.lost();
    if (sources_ == frame.sources && lostLights == lostLights_ && lostShadows == lostShadows_ &&
        shadowError == shadowError_) {
        return;
    }
    sources_ = frame.sources;
    lostLights_ = lostLights;
    lostShadows_ = lostShadows;
    shadowError_ = shadowError;
    writeEffects(frame, gpu, programs);
    writeLost(gpu.report);
}

void FrameDescription::countPrograms(const PreparedFrame& frame, FrameReport& report) {
    programs_.clear();
    for (const DrawBatch& batch : frame.list.batches()) {
        const DrawMaterial& material = frame.materials[batch.material];
        addOnce<const void*>(programs_, material.pipeline->program.get());
        if (material.pipeline->finsProgram) {
            addOnce<const void*>(programs_, material.pipeline->finsProgram.get());
        }
        if (material.pipeline->marksProgram) {
            addOnce<const void*>(programs_, material.pipeline->marksProgram.get());
        }
        if (frame.hasLines(batch.material)) {
            addOnce<const void*>(programs_, material.pipeline->outlineProgram.get());
        }
    }
    report.programs = static_cast<int>(programs_.size());
}

void FrameDescription::writeEffects(const PreparedFrame& frame, FrameGpu& gpu,
                                    ProgramPass& programs) {
    FrameReport& report = gpu.report;
    report.effects.clear();
    report.messages.clear();
    report.warnings = 0;
    for (std::size_t i = 0; i < frame.materials.size(); ++i) {
        const PlannedMaterial& material = frame.plan.materials[i];
        for (const Error& error : programs.entryOf(frame.plan, material, gpu.shared).errors) {
            addOnce(report.messages, error);
        }
        addEffects(report, frame.materials[i].pipeline.get());
    }
    addEffects(report, frame.ground.get());
}

void FrameDescription::writeLost(FrameReport& report) const {
    if (lostLights_ > 0) {
        addWarning(report, {{},
                            0,
                            0,
                            fmt::format("{} lights are left out because the graphics card's "
                                        "memory for lights is full",
                                        lostLights_),
                            {}});
    }
    if (lostShadows_ > 0) {
        addWarning(report, {{},
                            0,
                            0,
                            fmt::format("{} lights have no shadows because there is no room for "
                                        "more",
                                        lostShadows_),
                            {}});
    }
    if (shadowError_) {
        addWarning(report, *shadowError_);
    }
}

void FrameDescription::writeFailure(FrameReport& report, const Error& error) {
    report.messages.assign(1, error);
    report.warnings = 0;
    report.effects.clear();
    forget();
}

} // namespace patina
