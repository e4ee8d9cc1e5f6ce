// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cells/cell_maker.h"

#include <algorithm>
#include <utility>

#include "measure/stability/white_sky_albedo.h"

namespace patina {

Result<void> CellMaker::surround(const Scene& scene) {
    const BlockValues* wanted = scene.part(kinds::environment);
    std::optional<BlockValues> environment =
        wanted == nullptr ? std::nullopt : std::optional(*wanted);
    if (hasPanorama_ && environment == environment_) {
        return {};
    }
    return supplies_.panorama(scene).map([&](Panorama panorama) {
        environment_ = std::move(environment);
        hasPanorama_ = true;
        panorama_ = std::move(panorama);
    });
}

Checked<Image> CellMaker::draw(const Scene& scene) {
    if (const auto surrounded = surround(scene); !surrounded) {
        return tl::unexpected(oneError(surrounded.error()));
    }
    return supplies_.draw(scene, panorama_);
}

CellNumbers CellMaker::measure(const Scene& scene, std::size_t object,
                               const std::vector<CellNumber>& kinds, int cellPixels,
                               const Cancelled& isCancelled) {
    const auto wants = [&kinds](CellNumber kind) {
        return std::ranges::find(kinds, kind) != kinds.end();
    };
    const auto noted = [](const Result<double>& number) {
        return number ? std::optional(*number) : std::nullopt;
    };
    CellNumbers numbers;
    if (wants(CellNumber::Albedo)) {
        numbers.albedo = whiteSkyAlbedo(*supplies_.frames.catalog, scene.objects[object].material);
    }
    if ((!wants(CellNumber::Time) && !wants(CellNumber::Error)) || !hasMeter()) {
        return numbers;
    }
    if (!surround(scene)) {
        return numbers;
    }
    const CellMeter::Subject subject{scene, object, panorama_};
    if (wants(CellNumber::Time)) {
        numbers.milliseconds = noted(meter_->milliseconds(subject));
    }
    if (wants(CellNumber::Error)) {
        numbers.error = noted(meter_->error(subject, glm::ivec2(cellPixels), isCancelled));
    }
    return numbers;
}

bool CellMaker::hasMeter() {
    if (meter_ == nullptr && !meterProblem_) {
        auto meter = CellMeter::create(supplies_.frames, supplies_.programCache);
        if (meter) {
            meter_ = std::move(*meter);
        } else {
            meterProblem_ = meter.error();
        }
    }
    return meter_ != nullptr;
}

} // namespace patina
