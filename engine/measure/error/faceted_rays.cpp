// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/faceted_rays.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/trigonometric.hpp>

#include "catalog/parameter_layout.h"
#include "core/convex_facets.h"
#include "render/pass/refraction_packer.h"
#include "scene/environment.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/refracted_wavelengths.h"
#include "shading/program/compiled_block.h"

namespace patina {
namespace {

/// Is the largest half float, at which programs clamp light.
constexpr double brightest = 65504.0;

std::uint32_t hashed(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

std::uint32_t reversed(std::uint32_t x) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 32; ++i) {
        bits |= ((x >> i) & 1u) << (31 - i);
    }
    return bits;
}

double scrambled(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    for (const std::uint32_t factor : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u}) {
        x ^= x * factor;
    }
    return (reversed(x) >> 8) / 16777216.0;
}

/// Returns the place in its pixel, from the middle, where the ray of a round begins, as
/// passes/environment_points.glsl; rows count from the bottom.
glm::dvec2 placeInPixel(std::uint32_t round, std::uint32_t column, std::uint32_t row,
                        std::uint32_t series) {
    constexpr std::uint32_t use = 9;
    const std::uint32_t seed = hashed(column + hashed(row + hashed(use + 16u * series)));
    std::uint32_t pascal = round ^ (round >> 16);
    pascal ^= (pascal & 0xff00ff00u) >> 8;
    pascal ^= (pascal & 0xf0f0f0f0u) >> 4;
    pascal ^= (pascal & 0xccccccccu) >> 2;
    pascal ^= (pascal & 0xaaaaaaaau) >> 1;
    return {scrambled(round, hashed(seed)) - 0.5, scrambled(pascal, hashed(seed + 1)) - 0.5};
}

/// Returns `d` as a unit vector, or another where it has no length.
glm::dvec3 unitOr(const glm::dvec3& d, const glm::dvec3& other) {
    const double length = glm::length(d);
    return length > 1e-30 ? d / length : other;
}

glm::dvec3 limitedLight(const glm::dvec3& x) {
    glm::dvec3 light(0.0);
    for (int channel = 0; channel < 3; ++channel) {
        light[channel] = x[channel] > 0.0 ? std::min(x[channel], brightest) : 0.0;
    }
    return light;
}

/// Returns the number with a role among a block's values; null where the block has none.
double* numberWithRole(const BlockPlace& place, std::string_view role,
                       std::vector<double>& values) {
    const ParameterField* field = place.layout.withRole(role);
    return field == nullptr ? nullptr : &values[field->offset];
}

} // namespace

Result<FacetedRays> FacetedRays::of(const BufferedObject& object, std::size_t index,
                                    const BufferedScene& around) {
    const EffectSet& effects = object.pipeline->effects;
    if (!effects.refraction || !followsFacets(effects.refraction->block())) {
        return failure("the object refracts what is seen through it");
    }
    if (effects.isShownRefracted) {
        return failure("other objects are seen through it");
    }
    if (effects.mirrorsByTerm) {
        return failure("its Fresnel term is not that of an index");
    }
    const auto code = compiledBlock(effects.refraction->block());
    if (!code) {
        return tl::unexpected(code.error());
    }
    FacetedRays rays;
    rays.body_ = *code;
    rays.reflections_ = innerReflections(*effects.refraction);
    rays.background_ = around.scene.background;
    rays.takeLights(object, around.scene.objects[index].material, around.scene);
    if (auto body = rays.takeBody(around.scene.objects[index], around); !body) {
        return tl::unexpected(body.error());
    }
    if (auto sky = rays.takeSky(around); !sky) {
        return tl::unexpected(sky.error());
    }
    const Camera& camera = around.view.camera;
    const glm::dmat4 view = viewMatrix(camera);
    const double angle = glm::radians(std::clamp(camera.fieldOfView, 1.0, 170.0));
    const double pixel = 2.0 * std::tan(0.5 * angle) / around.view.size.y;
    rays.eye_ = eye(camera);
    rays.right_ = pixel * glm::dvec3(glm::row(view, 0));
    rays.up_ = pixel * glm::dvec3(glm::row(view, 1));
    rays.before_ = -glm::dvec3(glm::row(view, 2));
    rays.series_ = static_cast<std::uint32_t>(around.view.environmentSeries);
    return rays;
}

Result<void> FacetedRays::takeBody(const Object& object, const BufferedScene& around) {
    const ConvexFacets facets = convexFacetsOf(around.meshes(object));
    if (facets.planes.empty()) {
        return failure(fmt::format("its mesh is no convex body of flat facets: {}", facets.whyNot));
    }
    const glm::dmat4 world = worldMatrix(object);
    const glm::dmat3 turn = glm::inverseTranspose(glm::dmat3(world));
    glm::dvec3 middle(0.0);
    for (const FacetPlane& plane : facets.planes) {
        const glm::dvec3 n = glm::normalize(turn * plane.normal);
        const glm::dvec3 x(world * glm::dvec4(plane.offset * plane.normal, 1.0));
        planes_.push_back({n, glm::dot(n, x)});
        middle += x / double(facets.planes.size());
        if (!std::isfinite(glm::dot(n, x))) {
            return failure("it is flat");
        }
    }
    size_ = 0.0;
    for (const Plane& plane : planes_) {
        size_ = std::max(size_, 2.0 * std::abs(plane.offset - glm::dot(plane.n, middle)));
    }
    return {};
}

/// Takes the numbers that programs get: those of the block, and the index of each wavelength.
void FacetedRays::takeLights(const BufferedObject& object, const Material& material,
                             const Scene& scene) {
    const ObjectLayout& layout = object.pipeline->object;
    std::vector<glm::vec4> data = object.data;
    packRefraction(data, *object.pipeline, material, scene);
    const BlockPlace& place = *layout.refraction;
    Light all;
    for (std::size_t i = 0; i < place.layout.floats; ++i) {
        const std::size_t at = static_cast<std::size_t>(place.first) + i / 4;
        all.values.push_back(double(data[at][static_cast<int>(i % 4)]));
    }
    const double* dispersion = numberWithRole(place, roles::dispersion, all.values);
    if (const auto wavelengths = wavelengthPlace(layout)) {
        for (int i = 0; i < wavelengths->count; ++i) {
            const glm::dvec4 each(data[static_cast<std::size_t>(wavelengths->first + i)]);
            Light light = all;
            *numberWithRole(place, roles::index, light.values) = each.w; // which it must have
            if (double* own = numberWithRole(place, roles::dispersion, light.values)) {
                *own = 0.0;
            }
            light.shares = glm::dvec3(each);
            lights_.push_back(light);
        }
    } else if (dispersion == nullptr || *dispersion == 0.0) {
        lights_.push_back(all);
    } else {
        for (int channel = 0; channel < 3; ++channel) {
            all.channel = channel;
            all.shares = glm::dvec3(0.0);
            all.shares[channel] = 1.0;
            lights_.push_back(all);
        }
    }
}

Result<void> FacetedRays::takeSky(const BufferedScene& around) {
    const BlockValues* part = around.scene.part(kinds::environment);
    const Block* block =
        part == nullptr ? nullptr : around.catalog.find(kinds::environment, part->id);
    if (block == nullptr) {
        return {};
    }
    const bool hasPicture = std::ranges::any_of(block->parameters, [](const Parameter& parameter) {
        return parameter.type == ParameterType::Texture;
    });
    if (hasPicture) {
        return failure("an image is what surrounds it");
    }
    const auto code = compiledBlock(*block);
    if (!code) {
        return tl::unexpected(code.error());
    }
    const double turn = glm::radians(environmentNumber(*part, *block, roles::rotate));
    sky_ = {*code, packed(*block, part->parameters, {}), std::cos(turn), std::sin(turn),
            environmentNumber(*part, *block, roles::limit)};
    return {};
}

/// Returns what is far away in a direction.
glm::dvec3 FacetedRays::far(const glm::dvec3& d) const {
    if (sky_.code == nullptr) {
        return background_;
    }
    const glm::dvec3 inside(sky_.cosine * d.x - sky_.sine * d.z, d.y,
                            sky_.sine * d.x + sky_.cosine * d.z);
    const glm::dvec3 light =
        limitedLight(sky_.code->environment(inside, glm::dvec3(1.0), sky_.values));
    const double brightness = glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722));
    return sky_.limit > 0.0 && brightness > sky_.limit ? light * (sky_.limit / brightness) : light;
}

/// Returns the facet that x lies on, within what floats say of it, and whose normal n is.
const FacetedRays::Plane& FacetedRays::facetAt(const glm::dvec3& x, const glm::dvec3& n) const {
    const auto away = [&x](const Plane& plane) {
        return std::abs(plane.offset - glm::dot(plane.n, x));
    };
    const Plane* found = &*std::ranges::min_element(planes_, {}, away);
    const double near = away(*found) + 1e-6 * size_;
    for (const Plane& plane : planes_) {
        if (away(plane) < near && glm::dot(plane.n, n) > glm::dot(found->n, n)) {
            found = &plane;
        }
    }
    return *found;
}

/// Returns where a ray of the pixel meets the facet that its middle shows.
FacetedRays::Start FacetedRays::start(const SurfaceBuffer& buffer, std::size_t pixel,
                                      std::uint32_t round) const {
    const auto columns = static_cast<std::size_t>(buffer.size.x);
    const auto column = static_cast<std::uint32_t>(pixel % columns);
    const auto row = static_cast<std::uint32_t>(buffer.size.y) - 1u -
                     static_cast<std::uint32_t>(pixel / columns);
    const glm::dvec2 aside =
        isSampled() ? placeInPixel(round, column, row, series_) : glm::dvec2(0.0);
    const glm::dvec2 place = glm::dvec2(column, row) + 0.5 + aside - 0.5 * glm::dvec2(buffer.size);
    const glm::dvec3 d = glm::normalize(before_ + place.x * right_ + place.y * up_);
    const glm::dvec3 shown(buffer.normals[pixel]);
    const Plane& facet = facetAt(glm::dvec3(buffer.positions[pixel]), shown);
    constexpr double sameDirection = 1.0 - 1e-6;
    const glm::dvec3 n =
        glm::dot(facet.n, shown) > sameDirection ? facet.n : unitOr(shown, facet.n);
    const double along = glm::dot(facet.n, d);
    const double way = (facet.offset - glm::dot(facet.n, eye_)) / (along < 0.0 ? along : -1e-30);
    return {eye_ + way * d, n, -d};
}

/// Returns the facet that a ray inside meets after `way` metres; null where there is none.
const FacetedRays::Plane* FacetedRays::next(const glm::dvec3& x, const glm::dvec3& d,
                                            double& way) const {
    const Plane* found = nullptr;
    way = 1e300;
    for (const Plane& plane : planes_) {
        const double along = glm::dot(plane.n, d);
        const double left = plane.offset - glm::dot(plane.n, x);
        if (along > 1e-12 && left < way * along) {
            way = left / along;
            found = &plane;
        }
    }
    way = found == nullptr ? 0.0 : std::max(way, 0.0);
    return found;
}

/// Returns what is seen in the direction d from a place at the surface, inwards.
glm::dvec3 FacetedRays::inside(glm::dvec3 x, glm::dvec3 d, const Light& light) const {
    glm::dvec3 sum(0.0);
    double share = 1.0;
    double whole = 0.0;
    for (int i = 0; i <= reflections_; ++i) {
        double way = 0.0;
        const Plane* facet = next(x, d, way);
        const glm::dvec3 n = facet == nullptr ? d : facet->n;
        x += way * d;
        whole += way;
        const reference::Interface leaving{-d, -n, light.channel, true};
        const double kept = body_->mirrored(leaving, light.values);
        const glm::dvec3 left = body_->left(whole, light.values);
        const glm::dvec3 inner = unitOr(d - 2.0 * glm::dot(d, n) * n, d);
        if (kept < 1.0) {
            sum += share * (1.0 - kept) * left *
                   far(unitOr(body_->refract(leaving, light.values), inner));
        }
        share *= kept;
        d = inner;
        if (i == reflections_) {
            sum += share * left * far(d);
        }
    }
    return sum;
}

glm::dvec3 FacetedRays::seen(const SurfaceBuffer& buffer, std::size_t pixel,
                             std::uint32_t round) const {
    const Start from = start(buffer, pixel, round);
    const glm::dvec3 mirrored = far(2.0 * glm::dot(from.n, from.v) * from.n - from.v);
    glm::dvec3 sum(0.0);
    for (const Light& light : lights_) {
        const reference::Interface entering{from.v, from.n, light.channel, false};
        const glm::dvec3 d = unitOr(body_->refract(entering, light.values), -from.v);
        const double kept = body_->mirrored(entering, light.values);
        sum += light.shares * glm::mix(inside(from.x, d, light), mirrored, kept);
    }
    return limitedLight(sum);
}

} // namespace patina
