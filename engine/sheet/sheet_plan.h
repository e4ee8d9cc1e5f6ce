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

/// Pairs what a step of an axis is in data with what users read.
struct SheetStep {
    std::string entry; ///< is an entry as in SheetAxis::entries
    std::string label; ///< is what users see

    friend bool operator==(const SheetStep&, const SheetStep&) = default;
};

/// Holds an axis with all of its steps, also where the sheet gave none.
struct PlannedAxis {
    SheetAxis axis;
    std::string title;            ///< is shown: "Metalness", "Key: Intensity (EV)", "Model"
    std::vector<SheetStep> steps; ///< has one step at least
    bool setsOthers = false;      ///< says that its value sets others, which other axes override

    friend bool operator==(const PlannedAxis&, const PlannedAxis&) = default;
};

/// Says for a sheet of one object of a scene which steps its axes have and which scene each cell
/// shows. It depends on nothing but the sheet, the scene and the catalogue.
class SheetPlan {
  public:
    /// Plans a sheet of `start`'s object with this number. Every step that cannot be applied is an
    /// error that names its axis. Where an axis goes through models and the other one through a
    /// value, it is enough that one model has the value: scene() is an error for the others.
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

    std::string rowLabel(int row) const; ///< is "Start" for the control row; empty without a y axis
    std::string cellLabel(int column, int row) const; ///< reads "Metalness 0.5, Smoothness 0"

    /// Returns the sheet with the steps of this plan written out in its axes.
    Sheet shown(Sheet sheet) const;

    /// Returns the scene of a cell, which is the start in the control row. It is an error where a
    /// step cannot be applied together with the other axis' one.
    Result<Scene> scene(int column, int row) const;

    /// Applies a cell's steps to a scene and its object of this number; the control row changes
    /// nothing. After an error the scene may be changed in part.
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
