// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/image.h"
#include "measure/cost/cell_meter.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// Draws and measures the cells of contact sheets, one after the other. Made, used and destroyed
/// with one context current.
class CellMaker {
  public:
    using Panorama = std::shared_ptr<const EnvironmentImage>;
    using Cancelled = std::function<bool()>;

    /// Says where cells come from. What the functions use outlives the maker.
    struct Supplies {
        TimedFrames::Supplies frames; ///< of what is measured
        std::filesystem::path programCache;
        /// Returns the picture of a scene's environment; null where it needs none.
        std::function<Result<Panorama>(const Scene&)> panorama;
        /// Draws a scene as large as a cell, with the picture of its environment.
        std::function<Checked<Image>(const Scene&, const Panorama&)> draw;
    };

    explicit CellMaker(Supplies supplies) : supplies_(std::move(supplies)) {}

    /// Gets the picture of the scene's environment, unless it is that of the scene before.
    Result<void> surround(const Scene& scene);

    /// Returns the scene in the environment that surrounds it.
    Checked<Image> draw(const Scene& scene);

    /// Returns what is asked for of the scene's object; `cellPixels`: of a side of the pictures
    /// whose error is measured.
    CellNumbers measure(const Scene& scene, std::size_t object,
                        const std::vector<CellNumber>& numbers, int cellPixels,
                        const Cancelled& isCancelled = {});

    /// Why times and errors cannot be measured at all, where that was tried.
    const std::optional<Error>& meterProblem() const { return meterProblem_; }

  private:
    bool hasMeter();

    Supplies supplies_;
    std::unique_ptr<CellMeter> meter_;
    std::optional<Error> meterProblem_;
    bool hasPanorama_ = false;
    std::optional<BlockValues> environment_; ///< whose picture it is
    Panorama panorama_;
};

} // namespace patina
