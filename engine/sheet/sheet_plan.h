// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "core/error.h"
#include "scene/scene.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// Represents one step of an axis.
struct SheetStep {
    std::string entry; ///< as SheetAxis::entries has it
    std::string label; ///< for people

    friend bool operator==(const SheetStep&, const SheetStep&) = default;
};

/// Represents an axis whose steps are known.
struct PlannedAxis {
    SheetAxis axis;
    std::string title;            ///< for people: "Metalness", "Key: Intensity (EV)", "Model"
    std::vector<SheetStep> steps; ///< at least one
    bool setsOthers = false;      ///< a value that sets others with it, which one given alone beats

    friend bool operator==(const PlannedAxis&, const PlannedAxis&) = default;
};

/// Represents a sheet of one object of a scene: which steps its axes have, and which scene each
/// cell shows. A pure function of the scene.
class SheetPlan {
  public:
    /// Plans a sheet of `start`'s object with this number. Every step that cannot be is in the
    /// error, which names its axis. A value that some models of the other axis lack is none: their
    /// cells cannot be had.
    static Checked<SheetPlan> of(const Sheet& sheet, Scene start, std::size_t object,
                                 std::shared_ptr<const Catalog> catalog);

    int columns() const { return static_cast<int>(x_.steps.size()); }
    int rows() const { return sweptRows() + (hasControlRow_ ? 1 : 0); }
    bool isControl(int row) const { return row >= sweptRows(); }

    const PlannedAxis& x() const { return x_; }
    const std::optional<PlannedAxis>& y() const { return y_; }
    const Scene& start() const { return start_; }
    std::size_t object() const { return object_; }
    const std::shared_ptr<const Catalog>& catalog() const { return catalog_; }

    std::string rowLabel(int row) const; ///< "Start" of the control row; empty without a y axis
    std::string cellLabel(int column, int row) const; ///< "Metalness 0.5, Smoothness 0"

    /// Returns the sheet with the steps that its axes have, also where they were all that there
    /// are.
    Sheet shown(Sheet sheet) const;

    /// Returns the scene of a cell: the start in the control row. An error where the cell cannot
    /// be.
    Result<Scene> scene(int column, int row) const;

    /// Brings a cell's values into an object of a scene and into the scene itself. Nothing in the
    /// control row, which has none of its own.
    Result<void> apply(Scene& scene, std::size_t object, int column, int row) const;

  private:
    int sweptRows() const { return y_ ? static_cast<int>(y_->steps.size()) : 1; }

    PlannedAxis x_;
    std::optional<PlannedAxis> y_;
    bool hasControlRow_ = true;
    Scene start_;
    std::size_t object_ = 0;
    std::shared_ptr<const Catalog> catalog_;
};

} // namespace patina
