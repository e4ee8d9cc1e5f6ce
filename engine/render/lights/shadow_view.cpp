// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/shadow_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/vectors.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// A wider cone gets the six faces of a light that shines everywhere, since one face cannot cover
/// it.
constexpr double widestCone = glm::radians(75.0);

/// Is the least ratio of the nearest to the farthest depth, which keeps the precision of depths.
constexpr double nearestShare = 1e-3;

/// Holds the position, direction and angle of a light in world space, as its descriptor gives them.
struct LightFrame {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, -1.0, 0.0}; ///< unit
    double angle = 0.0;                   ///< radians: the widest of its angles
};

glm::dvec3 unit(const glm::dvec3& v) {
    const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return size > 1e-30 ? glm::normalize(v / size) : glm::dvec3(0.0, -1.0, 0.0);
}

glm::dvec3 inWorld(const Parameter& parameter, const glm::dvec3& value,
                   const glm::dmat4& cameraToWorld) {
    const bool isPoint = parameter.space == Space::CameraPoint;
    const bool ofCamera = isPoint || parameter.space == Space::CameraDirection;
    return ofCamera ? glm::dvec3(cameraToWorld * glm::dvec4(value, isPoint ? 1.0 : 0.0)) : value;
}

LightFrame frameOf(const Block& light, const Values& values, const glm::dmat4& cameraToWorld) {
    LightFrame frame;
    for (const Parameter& parameter : light.parameters) {
        const Value& given = givenValue(parameter, values);
        const Value& value = isFinite(given) ? given : parameter.defaultValue;
        const auto* triple = std::get_if<glm::dvec3>(&value);
        const auto* number = std::get_if<double>(&value);
        if (triple != nullptr && parameter.space != Space::None) {
            const glm::dvec3 limited = glm::clamp(*triple, parameter.min, parameter.max);
            const glm::dvec3 placed = inWorld(parameter, limited, cameraToWorld);
            const bool isPoint =
                parameter.space == Space::WorldPoint || parameter.space == Space::CameraPoint;
            (isPoint ? frame.position : frame.direction) = isPoint ? placed : unit(placed);
        } else if (number != nullptr && infoOf(parameter.type).isAngle) {
            const double limited = std::clamp(*number, parameter.min, parameter.max);
            frame.angle = std::max(frame.angle, glm::radians(limited));
        }
    }
    return frame;
}

/// Turns the frame to `forward`. Its rotation about that axis does not matter, but must not jump
/// while `forward` moves a little.
void turnTo(ShadowView& view, const glm::dvec3& forward) {
    const glm::dvec3 aside =
        std::abs(forward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    view.forward = forward;
    view.right = glm::normalize(glm::cross(aside, forward));
    view.up = glm::cross(forward, view.right);
}

glm::dvec3 seenFrom(const ShadowView& view, const glm::dvec3& x) {
    const glm::dvec3 d = x - view.origin;
    return {glm::dot(d, view.right), glm::dot(d, view.up), glm::dot(d, view.forward)};
}

/// Calls `use` for the corners of all boxes in the view's frame; skips corners that are not finite.
template <class Use>
void eachCorner(const ShadowView& view, std::span<const CasterBox> casters, Use use) {
    for (const CasterBox& caster : casters) {
        for (int corner = 0; !caster.bounds.empty() && corner < 8; ++corner) {
            const glm::dvec4 point = caster.world * cornerOf(caster.bounds, corner);
            const glm::dvec3 seen = seenFrom(view, glm::dvec3(point));
            if (isFinite(seen)) {
                use(seen);
            }
        }
    }
}

struct Range {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& x) {
        lower = glm::min(lower, x);
        upper = glm::max(upper, x);
    }
    bool empty() const { return !(lower.x <= upper.x); }
};

/// Rounds a size up to the next power of 2^(1/12).
double stepped(double size) {
    return std::exp2(std::ceil(12.0 * std::log2(std::max(size, 1e-9))) / 12.0);
}

/// Sets a square window about the range's middle, whose texels lie on a fixed grid. It has a margin
/// of two texels for filters.
void fitWindow(ShadowView& view, const Range& range, int texels) {
    const glm::dvec2 size(range.upper - range.lower);
    const double side = stepped(std::max(size.x, size.y)) * texels / (texels - 5.0);
    view.texel = side / texels;
    const glm::dvec2 corner =
        view.texel * glm::floor((glm::dvec2(range.lower + range.upper) - side) / 2.0 / view.texel);
    view.window = glm::dvec4(1.0 / side, 1.0 / side, -corner.x / side, -corner.y / side);
}

ShadowView parallelView(const LightFrame& frame, std::span<const CasterBox> casters, int texels) {
    ShadowView view;
    turnTo(view, frame.direction);
    Range range;
    eachCorner(view, casters, [&range](const glm::dvec3& corner) { range.add(corner); });
    if (range.empty()) {
        return view;
    }
    view.isParallel = true;
    view.faces = 1;
    fitWindow(view, range, texels);
    const double margin =
        1e-3 * (range.upper.z - range.lower.z) + 1e-6 * glm::length(range.upper) + 1e-6;
    view.near = range.lower.z - margin;
    view.far = range.upper.z + margin;
    return view;
}

/// Sets the planes to enclose depths from `nearest` to `farthest`, with a margin.
void setDepths(ShadowView& view, double nearest, double farthest) {
    view.far = 1.01 * std::max(farthest, 1e-6);
    view.near = std::max(0.99 * nearest, nearestShare * view.far);
}

ShadowView coneView(const LightFrame& frame, std::span<const CasterBox> casters, int texels) {
    ShadowView view;
    view.origin = frame.position;
    turnTo(view, frame.direction);
    Range depths;
    eachCorner(view, casters, [&depths](const glm::dvec3& corner) { depths.add(corner); });
    if (depths.empty() || depths.upper.z <= 0.0) {
        return view;
    }
    view.faces = 1;
    setDepths(view, depths.lower.z, depths.upper.z);
    const double widest = std::tan(std::max(frame.angle, 1e-6)) * 1.001;
    Range slopes;
    if (depths.lower.z > view.near) {
        eachCorner(view, casters, [&slopes](const glm::dvec3& c) { slopes.add(c / c.z); });
    } else {
        slopes.add(glm::dvec3(widest));
        slopes.add(glm::dvec3(-widest));
    }
    slopes.lower = glm::clamp(slopes.lower, -widest, widest);
    slopes.upper = glm::clamp(slopes.upper, -widest, widest);
    fitWindow(view, slopes, texels);
    return view;
}

/// Returns the least depth of the boxes, in metres along the axes of the faces.
double nearestOf(const ShadowView& view, std::span<const CasterBox> casters) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const CasterBox& caster : casters) {
        Range box;
        eachCorner(view, {&caster, 1}, [&box](const glm::dvec3& corner) { box.add(corner); });
        if (!box.empty()) {
            const glm::dvec3 away = glm::max(glm::max(box.lower, -box.upper), glm::dvec3(0.0));
            nearest = std::min(nearest, std::max({away.x, away.y, away.z}));
        }
    }
    return nearest;
}

ShadowView sphereView(const LightFrame& frame, std::span<const CasterBox> casters, int texels) {
    ShadowView view;
    view.origin = frame.position;
    double farthest = 0.0;
    eachCorner(view, casters, [&farthest](const glm::dvec3& corner) {
        farthest = std::max(farthest, glm::length(corner));
    });
    if (!(farthest > 0.0)) {
        return view;
    }
    view.faces = 6;
    setDepths(view, nearestOf(view, casters), farthest);
    view.window = glm::dvec4(0.5);
    view.texel = 2.0 / texels;
    return view;
}

/// Returns the view turned to a face, as passes/shadows_local.glsl turns directions.
ShadowView faceOf(const ShadowView& view, int face) {
    ShadowView turned = view;
    const auto set = [&turned](const glm::dvec3& right, const glm::dvec3& up,
                               const glm::dvec3& forward) {
        turned.right = right;
        turned.up = up;
        turned.forward = forward;
    };
    switch (face) {
    case 1:
        set(-view.right, view.up, -view.forward);
        break;
    case 2:
        set(-view.forward, view.up, view.right);
        break;
    case 3:
        set(view.forward, view.up, -view.right);
        break;
    case 4:
        set(view.right, -view.forward, view.up);
        break;
    case 5:
        set(view.right, view.forward, -view.up);
        break;
    default:
        break;
    }
    return turned;
}

ShadowView projectedView(ShadowProjection projection, const LightFrame& frame,
                         std::span<const CasterBox> casters, int texels) {
    switch (projection) {
    case ShadowProjection::Parallel:
        return parallelView(frame, casters, texels);
    case ShadowProjection::Cone:
        return frame.angle > widestCone ? sphereView(frame, casters, texels)
                                        : coneView(frame, casters, texels);
    case ShadowProjection::Sphere:
        return sphereView(frame, casters, texels);
    default:
        return {};
    }
}

double longestSide(std::span<const CasterBox> casters) {
    Range box;
    eachCorner(ShadowView(), casters, [&box](const glm::dvec3& corner) { box.add(corner); });
    const glm::dvec3 sides = box.upper - box.lower;
    return box.empty() ? 0.0 : std::max({sides.x, sides.y, sides.z});
}

} // namespace

glm::dvec4 cornerOf(const Bounds& box, int corner) {
    return {(corner & 1) != 0 ? box.upper.x : box.lower.x,
            (corner & 2) != 0 ? box.upper.y : box.lower.y,
            (corner & 4) != 0 ? box.upper.z : box.lower.z, 1.0};
}

ShadowView shadowViewOf(const Block& light, const Values& values, const glm::dmat4& cameraToWorld,
                        std::span<const CasterBox> casters, int texels) {
    const LightFrame frame = frameOf(light, values, cameraToWorld);
    ShadowView view = projectedView(light.shadowProjection, frame, casters, texels);
    view.size = longestSide(casters);
    return view;
}

glm::dmat4 shadowClip(const ShadowView& view, int face) {
    const ShadowView turned = faceOf(view, face);
    glm::dmat4 toView(1.0);
    const glm::dvec3 axes[] = {turned.right, turned.up, turned.forward};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            toView[column][row] = axes[row][column];
        }
        toView[3][row] = -glm::dot(axes[row], view.origin);
    }
    // Window coordinates 0 .. 1 are -1 .. 1 of clip space; a perspective divides by the depth.
    const glm::dvec2 scale(2.0 * view.window.x, 2.0 * view.window.y);
    const glm::dvec2 shift(2.0 * view.window.z - 1.0, 2.0 * view.window.w - 1.0);
    const double span = view.far - view.near;
    glm::dmat4 toClip(0.0);
    toClip[0][0] = scale.x;
    toClip[1][1] = scale.y;
    if (view.isParallel) {
        toClip[3] = glm::dvec4(shift, -(view.far + view.near) / span, 1.0);
        toClip[2][2] = 2.0 / span;
    } else {
        toClip[2] = glm::dvec4(shift, (view.far + view.near) / span, 1.0);
        toClip[3][2] = -2.0 * view.far * view.near / span;
    }
    return toClip * toView;
}

namespace {

/// Returns the origin of the map's coordinates relative to the view's origin. It is moved towards
/// the light by the rounding error of positions and depths, so that no surface shadows itself.
glm::dvec3 mapCorner(const ShadowView& view, double side) {
    const double farthest = std::max(std::abs(view.near), std::abs(view.far));
    const double rounding = 1e-6 * (farthest + view.far - view.near);
    return -side * view.window.z * view.right - side * view.window.w * view.up +
           (view.near + rounding) * view.forward;
}

void packParallel(std::span<glm::vec4> out, const ShadowView& view) {
    const double side = 1.0 / view.window.x;
    out[0] = glm::vec4(view.right / side, view.texel);
    out[1] = glm::vec4(view.up / side, view.layer);
    out[2] = glm::vec4(view.forward / (view.far - view.near), view.faces);
    out[3] = glm::vec4(view.origin + mapCorner(view, side), view.near);
    out[4] = glm::vec4(side, 0.0, 0.0, 0.0);
    out[5] = glm::vec4(view.far, view.size, 0.0, 0.0);
}

} // namespace

void packView(std::span<glm::vec4> out, const ShadowView& view) {
    if (view.isParallel) {
        return packParallel(out, view);
    }
    // Without a map every place is outside it, also as that of a light from very far away.
    const double there = view.faces > 0 ? 1.0 : 0.0;
    out[0] = glm::vec4(there * view.right, view.texel);
    out[1] = glm::vec4(there * view.up, view.layer);
    out[2] = glm::vec4(there * view.forward, view.faces);
    out[3] = glm::vec4(view.origin, view.near);
    out[4] = glm::vec4(view.window);
    out[5] = glm::vec4(view.far, view.size, 0.0, 0.0);
}

} // namespace patina
