// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_plan.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "scene/scene_assignment.h"
#include "sheet/axis_steps.h"
#include "sheet/sheet_file.h"

namespace patina {
namespace {

/// Returns the scene in which an axis is planned: the start, or, where the start has not the axis'
/// value, the start with the first model of the other axis that has it.
Scene sceneFor(const SheetAxis& axis, const SheetAxis* other, const Scene& start,
               std::size_t object, const Catalog& catalog) {
    if (axis.kind != AxisKind::Value || other == nullptr || other->kind != AxisKind::Models ||
        plannedAxis(axis, start, object, catalog)) {
        return start;
    }
    std::vector<std::string> models = other->entries;
    if (models.empty()) {
        for (const Block* block : catalog.ofKind(kinds::models)) {
            models.push_back(block->id);
        }
    }
    for (const std::string& model : models) {
        Scene scene = start;
        if (applyStep(scene, object, *other, model, catalog) &&
            plannedAxis(axis, scene, object, catalog)) {
            return scene;
        }
    }
    return start;
}

Error ofAxis(const char* name, Error error) {
    error.problem = fmt::format("{}: {}", name, error.problem);
    return error;
}

/// Plans one axis, tries each of its steps and adds to `errors` why one cannot be applied.
Result<PlannedAxis> tried(const SheetAxis& axis, const Scene& scene, std::size_t object,
                          const Catalog& catalog, const char* name, Errors& errors) {
    auto planned = plannedAxis(axis, scene, object, catalog);
    if (!planned) {
        errors.push_back(ofAxis(name, planned.error()));
        return planned;
    }
    for (const SheetStep& step : planned->steps) {
        Scene cell = scene;
        if (const auto applied = applyStep(cell, object, axis, step.entry, catalog); !applied) {
            errors.push_back(ofAxis(name, applied.error()));
        }
    }
    return planned;
}

/// Returns the errors of limitMistakes() without their JSON pointers, since there is no file.
Errors mistakesOf(const Sheet& sheet) {
    Errors errors = limitMistakes(sheet);
    for (Error& error : errors) {
        error.file.clear();
    }
    return errors;
}

/// Returns a key that sorts axes in the order in which a cell applies them: by AxisKind, and of two
/// values the one that sets others first.
std::pair<AxisKind, bool> orderOf(const PlannedAxis& axis) {
    return {axis.axis.kind, !axis.setsOthers};
}

} // namespace

Checked<SheetPlan> SheetPlan::of(const Sheet& sheet, Scene start, std::size_t object,
                                 std::shared_ptr<const Catalog> catalog) {
    if (object >= start.objects.size()) {
        return tl::unexpected(oneError(failure("there is no object", "a scene with one").value()));
    }
    Errors errors = mistakesOf(sheet);
    if (sheet.y && sheet.y->kind == sheet.x.kind && sheet.y->value == sheet.x.value) {
        errors.push_back(failure("both axes are of the same", "two different ones").value());
    }
    if (!errors.empty()) {
        return tl::unexpected(std::move(errors));
    }
    const SheetAxis* y = sheet.y ? &*sheet.y : nullptr;
    SheetPlan plan;
    const auto x = tried(sheet.x, sceneFor(sheet.x, y, start, object, *catalog), object, *catalog,
                         "x", errors);
    if (x) {
        plan.x_ = *x;
    }
    if (y != nullptr) {
        const auto planned = tried(*y, sceneFor(*y, &sheet.x, start, object, *catalog), object,
                                   *catalog, "y", errors);
        if (planned) {
            plan.y_ = *planned;
        }
    }
    if (errors.empty()) {
        errors = mistakesOf(plan.shown(sheet));
    }
    if (!errors.empty()) {
        return tl::unexpected(std::move(errors));
    }
    plan.hasControlRow_ = sheet.hasControlRow;
    plan.start_ = std::move(start);
    plan.object_ = object;
    plan.catalog_ = std::move(catalog);
    return plan;
}

Sheet SheetPlan::shown(Sheet sheet) const {
    sheet.x = x_.axis;
    if (y_) {
        sheet.y = y_->axis;
    }
    return sheet;
}

std::string SheetPlan::rowLabel(int row) const {
    if (isControl(row)) {
        return "Start";
    }
    return y_ ? y_->steps[static_cast<std::size_t>(row)].label : std::string();
}

std::string SheetPlan::cellLabel(int column, int row) const {
    if (isControl(row)) {
        return "Start";
    }
    const auto label = [](const PlannedAxis& axis, int step) {
        return fmt::format("{} {}", axis.title, axis.steps[static_cast<std::size_t>(step)].label);
    };
    return label(x_, column) + (y_ ? ", " + label(*y_, row) : std::string());
}

Result<Scene> SheetPlan::scene(int column, int row) const {
    Scene cell = start_;
    return apply(cell, object_, column, row).map([&cell] { return std::move(cell); });
}

Result<void> SheetPlan::apply(Scene& scene, std::size_t object, int column, int row) const {
    if (isControl(row)) {
        return {};
    }
    std::vector<std::pair<const PlannedAxis*, int>> axes{{&x_, column}};
    if (y_) {
        axes.emplace_back(&*y_, row);
    }
    std::ranges::stable_sort(axes, {}, [](const auto& axis) { return orderOf(*axis.first); });
    for (const auto& [axis, step] : axes) {
        const std::string& entry = axis->steps[static_cast<std::size_t>(step)].entry;
        if (auto applied = applyStep(scene, object, axis->axis, entry, *catalog_); !applied) {
            return applied;
        }
    }
    return {};
}

} // namespace patina
