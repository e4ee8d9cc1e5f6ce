// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/plan/frame_planner.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/lights/fog_reach.h"
#include "shading/effects/material_hash.h"
#include "shading/effects/opacity.h"
#include "shading/effects/outline.h"
#include "shading/effects/shadows.h"
#include "shading/effects/shells.h"
#include "shading/effects/strokes.h"

namespace patina {
namespace {

/// Returns true when two objects have the same mesh, as neighbours in a scene often do; then it
/// need not be looked up again.
bool isOfOneMesh(const Object& a, const Object& b) {
    return a.mesh == b.mesh && a.part == b.part && a.fitUnitBox == b.fitUnitBox &&
           a.flipNormals == b.flipNormals;
}

/// Returns the scene whose effects the programs of a view have: the view's own if its objects and
/// lights match, else `scene`.
const Scene& effectsOf(const View& view, const Scene& scene) {
    const bool fits = view.effects != nullptr &&
                      view.effects->objects.size() == scene.objects.size() &&
                      view.effects->lights.size() == scene.lights.size();
    return fits ? *view.effects : scene;
}

/// Measures the fog between the eye and the frame's objects and ground.
FogReach fogReach(const FramePlan& plan, const Catalog& catalog) {
    FogReach fog(*plan.effects, catalog, glm::dvec3(plan.cameraToWorld[3]));
    if (!fog.asks()) {
        return fog;
    }
    for (const PlannedItem& item : plan.items) {
        fog.add(cornersWithin(*item.placement, plan.materials[item.material].shells));
    }
    if (plan.ground.isSeen) {
        fog.add(groundBounds(), worldMatrix(plan.ground.place));
    }
    return fog;
}

/// Returns the kinds of lights for which the objects of a list need no code. While a value is
/// dragged it returns 0, so that lists change data alone.
std::size_t missingKinds(FramePlan& plan, std::size_t lights) {
    return plan.isFrozen ? 0 : plan.lightKinds.missingKinds(plan.lightLists, lights);
}

/// Returns the largest share by which a transform enlarges areas; where it shears them, at most.
double areaScale(const glm::dmat4& world) {
    const glm::dmat3 m(world);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    const glm::dmat3 squares = glm::transpose(cofactors) * cofactors;
    double largest = 0.0; // eigenvalue, which no sum of a column is below (Gershgorin)
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 sizes = glm::abs(squares[i]);
        largest = std::max(largest, sizes.x + sizes.y + sizes.z);
    }
    return std::sqrt(largest);
}

/// Returns how many marks are drawn at most on a square metre of an item's mesh, by its nearest
/// point; a huge number where the eye is inside.
double marksOn(const FramePlan& plan, const PlannedItem& item) {
    const double perUnit = plan.materials[item.material].marks;
    if (!(perUnit > 0.0) || !item.isInPicture) {
        return 0.0;
    }
    const Ball& ball = item.placement->ball;
    const double middle = -(plan.worldToCamera * glm::dvec4(ball.center, 1.0)).z;
    const double nearest = std::max(middle - ball.radius, 1e-3 * ball.radius);
    const double unit = nearest * plan.pixelWidth() * plan.pixelsPerUnit();
    return perUnit * areaScale(item.placement->world) / std::max(unit * unit, 1e-30);
}

void count(FramePlan& plan) {
    plan.triangles = 0;
    plan.layered = 0;
    plan.edges = 0;
    for (const PlannedItem& item : plan.items) {
        const std::int64_t triangles = std::ssize(item.view.indices) / 3;
        plan.triangles += triangles;
        plan.layered += plan.materials[item.material].layers * triangles;
        // A closed mesh has three edges for two triangles.
        plan.edges += plan.materials[item.material].needsEdges() ? 3 * triangles / 2 : 0;
    }
}

void begin(FramePlan& plan, const Scene& scene, const View& view, PlanWish wish) {
    plan.scene = &scene;
    plan.effects = &effectsOf(view, scene);
    plan.view = &view;
    plan.isFrozen = wish.freezesEffects || plan.effects != &scene;
    plan.isUnseen = wish.isUnseen;
    plan.worldToCamera = viewMatrix(view.camera);
    plan.cameraToWorld = glm::inverse(plan.worldToCamera);
    plan.eye = eye(view.camera);
    plan.depths = DepthRange();
    plan.items.clear();
    plan.materials.clear();
}

} // namespace

void FramePlanner::make(FramePlan& plan, const Scene& scene, const View& view,
                        const MeshSource& meshes, const Catalog& catalog, PlanWish wish) {
    begin(plan, scene, view, wish);
    collect(plan, meshes, catalog);
    count(plan);
    addGround(plan);
    plan.effectView =
        plan.isFrozen ? EffectView() : effectView(plan.depths, fogReach(plan, catalog));
    plan.effectView.fitsEnvironment = view.isMoving;
}

void FramePlanner::collect(FramePlan& plan, const MeshSource& meshes, const Catalog& catalog) {
    const std::vector<Object>& objects = plan.scene->objects;
    materialKeys_.clear(objects.size());
    placements_.makeRoom(objects.size());
    plan.lightLists.begin(*plan.scene, catalog);
    plan.lightKinds.begin(*plan.effects, catalog);
    const glm::dmat4 worldToClip = plan.worldToClip();
    const Object* last = nullptr; // owns `mesh`
    MeshView mesh;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (!isDrawn(objects[i])) {
            continue;
        }
        if (last == nullptr || !isOfOneMesh(*last, objects[i])) {
            mesh = meshes(objects[i]);
            last = &objects[i];
        }
        if (!mesh.indices.empty()) {
            PlannedItem& item = plan.items.emplace_back(itemOf(plan, i, mesh, catalog));
            const double shells = plan.materials[item.material].shells;
            item.isInPicture = plan.isUnseen || !isOutside(*item.placement, worldToClip, shells);
            item.marks = marksOn(plan, item);
        }
    }
}

PlannedItem FramePlanner::itemOf(FramePlan& plan, std::size_t index, const MeshView& mesh,
                                 const Catalog& catalog) {
    const Placement& place = placements_.of(index, plan.scene->objects[index], mesh.bounds);
    const double shells = shellsLength(plan.scene->objects[index].material, catalog);
    Ball ball = place.ball;
    ball.radius += shells;
    const std::size_t lights = plan.lightLists.listFor(ball);
    if (!mesh.bounds.empty()) {
        plan.depths.add(cornersWithin(place, shells), plan.worldToCamera);
    }
    return {index,  mesh,
            &place, glm::distance(place.middle, plan.eye),
            lights, materialOf(plan, index, missingKinds(plan, lights), catalog)};
}

/// Returns the index of an object's material in the plan and adds it when it is new. Two objects
/// share one when their values and the effects of their programs are the same.
std::size_t FramePlanner::materialOf(FramePlan& plan, std::size_t object, std::size_t missing,
                                     const Catalog& catalog) {
    const Material& effects = plan.effects->objects[object].material;
    const Material& values = plan.scene->objects[object].material;
    std::uint64_t hash = materialHash(effects);
    if (plan.isFrozen) {
        hash = 31 * hash + materialHash(values);
    }
    if (missing != 0) {
        hash = 31 * hash + missing;
    }
    const std::size_t number = materialKeys_.find(hash, plan.materials.size());
    if (number == plan.materials.size()) {
        PlannedMaterial& material = plan.materials.emplace_back();
        material.object = object;
        material.missing = missing;
        material.isTransparent = isTransparent(effects, catalog);
        material.canShadow = canShadow(values, catalog);
        material.isOutlined = outlineChoice(effects, catalog).block != nullptr;
        material.shells = shellsLength(values, catalog);
        material.layers = layersOver(effects, catalog);
        material.hasFins = hasFins(effects, catalog);
        material.marks = marksPerUnit(values, catalog);
    }
    return number;
}

/// Places the ground if the scene of the effects shows one. While its opacity is dragged that scene
/// is kept, so that the ground stays at an opacity of 0.
void FramePlanner::addGround(FramePlan& plan) {
    plan.ground = PlannedGround();
    if (!isSeen(plan.effects->ground)) {
        return;
    }
    GroundUnder under;
    for (const PlannedItem& item : plan.items) {
        under.add(item.view.bounds, item.placement->world, lowestHeight(item));
    }
    if (const auto place = under.place(plan.scene->ground, plan.eye)) {
        plan.ground.isSeen = true;
        plan.ground.place = *place;
        plan.ground.lights = plan.lightLists.listFor(ballAround(*place));
        plan.ground.missing = missingKinds(plan, plan.ground.lights);
        patina::addGround(plan.depths, *place, plan.view->camera);
    }
}

bool FramePlanner::Lowest::isOf(const PlannedItem& item) const {
    return world == item.placement->world && vertices.data() == item.view.vertices.data() &&
           vertices.size() == item.view.vertices.size() && bounds == item.view.bounds;
}

/// Returns the lowest height of an object in the world; computes it only when the object has
/// changed.
double FramePlanner::lowestHeight(const PlannedItem& item) {
    if (lowest_.size() <= item.index) {
        lowest_.resize(item.index + 1);
    }
    Lowest& lowest = lowest_[item.index];
    if (!lowest.isOf(item)) {
        lowest = {item.placement->world, item.view.vertices, item.view.bounds,
                  lowestPoint(item.view, item.placement->world)};
    }
    return lowest.height;
}

} // namespace patina
