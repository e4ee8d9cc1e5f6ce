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

/// Draws and measures the cells of contact sheets, one after the other. It must be made, used and
/// destroyed with the same context current.
class CellMaker {
  public:
    using Panorama = std::shared_ptr<const EnvironmentImage>;
    using Cancelled = std::function<bool()>;

    /// Holds what cells are made with. What the functions refer to must outlive the maker.
    struct Supplies {
        TimedFrames::Supplies frames; ///< are for measured frames
        std::filesystem::path programCache;
        /// Returns the picture of a scene's environment; null where it needs none.
        std::function<Result<Panorama>(const Scene&)> panorama;
        /// Draws a scene as large as a cell, with the picture of its environment.
        std::function<Checked<Image>(const Scene&, const Panorama&)> draw;
    };

    explicit CellMaker(Supplies supplies) : supplies_(std::move(supplies)) {}

    /// Gets the picture of the scene's environment, unless the scene before had the same.
    Result<void> surround(const Scene& scene);

    /// Returns the picture of the scene with its environment.
    Checked<Image> draw(const Scene& scene);

    /// Measures the numbers that are asked for; what cannot be measured is empty. `cellPixels` is
    /// the side of the square picture whose error is measured.
    CellNumbers measure(const Scene& scene, std::size_t object,
                        const std::vector<CellNumber>& numbers, int cellPixels,
                        const Cancelled& isCancelled = {});

    /// Returns why times and errors cannot be measured at all; nothing where they can, or where it
    /// was not tried yet.
    const std::optional<Error>& meterProblem() const { return meterProblem_; }

  private:
    bool hasMeter();

    Supplies supplies_;
    std::unique_ptr<CellMeter> meter_;
    std::optional<Error> meterProblem_;
    bool hasPanorama_ = false;
    std::optional<BlockValues> environment_; ///< is the one that panorama_ belongs to
    Panorama panorama_;
};

} // namespace patina
