// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/plan/frame_plan.h"

namespace patina {
namespace {

/// A frame of more triangles is drawn in steps when there is a deadline.
constexpr std::int64_t maxTrianglesAtOnce = 200000;

/// Is the same number as in shaders/passes/picture.glsl.
constexpr double unitsHigh = 512.0;

} // namespace

glm::dmat4 FramePlan::worldToClip() const {
    const double aspect = double(view->size.x) / double(view->size.y);
    return projection(view->camera, aspect, depths) * worldToCamera;
}

double FramePlan::pixelWidth() const {
    return 2.0 / (view->size.y * projection(view->camera, 1.0, depths)[1][1]);
}

double FramePlan::pixelsPerUnit() const {
    return view->size.y / unitsHigh;
}

const Material& FramePlan::material(std::size_t number) const {
    return scene->objects[materials[number].object].material;
}

const BlockValues& FramePlan::transparency() const {
    const BlockValues* own = scene->part(kinds::transparency);
    const BlockValues* drawn = effects->part(kinds::transparency);
    return own != nullptr && own->id == drawn->id ? *own : *drawn;
}

bool FramePlan::hasManyTriangles(std::int64_t more) const {
    return triangles + layered + edges + more > maxTrianglesAtOnce;
}

void FramePlan::moveTo(const Scene& copy, const Scene& effectsCopy) {
    scene = &copy;
    effects = &effectsCopy;
}

} // namespace patina
