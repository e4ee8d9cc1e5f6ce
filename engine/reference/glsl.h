// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "reference/measured_values.h"
#include "reference/reference.h"

// This file declares the types and functions of GLSL for shader code that is compiled as C++ with
// `float` replaced by `double`. It lists names one by one, since a using-directive would also find
// the C library's abs(int).
namespace patina::reference {

using ivec3 = glm::ivec3;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using mat2 = glm::dmat2;
using mat3 = glm::dmat3;
using mat4 = glm::dmat4;

using glm::abs;
using glm::acos;
using glm::all;
using glm::any;
using glm::asin;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::degrees;
using glm::distance;
using glm::dot;
using glm::exp;
using glm::exp2;
using glm::faceforward;
using glm::floor;
using glm::fract;
using glm::inversesqrt;
using glm::length;
using glm::log;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::mod;
using glm::normalize;
using glm::pow;
using glm::radians;
using glm::reflect;
using glm::refract;
using glm::sign;
using glm::sin;
using glm::smoothstep;
using glm::sqrt;
using glm::step;
using glm::tan;
using glm::transpose;

/// Holds what fills a model's slot of one kind, null where it is empty, and the geometry of the
/// model's call.
struct FilledSlot {
    const Filler* filler = nullptr;
    const Geometry* geometry = nullptr;
};

/// Returns the slot of a kind among what fills a model's slots.
inline FilledSlot filledSlot(Fillers fillers, std::string_view kind, const Geometry& geometry) {
    for (const Filler& filler : fillers) {
        if (filler.block != nullptr && filler.block->kind == kind) {
            return {&filler, &geometry};
        }
    }
    return {nullptr, &geometry};
}

} // namespace patina::reference

#define OUT(T) T&
/// Reads four numbers, from `base` on, of a value that is a function.
#define PARAMETER_DATA(i)                                                                          \
    vec4(base[4 * (i)], base[4 * (i) + 1], base[4 * (i) + 2], base[4 * (i) + 3])
/// Read the table of the file whose number is the first at `base`.
#define MEASURED_BINS measuredBins(base[0])
#define MEASURED_VALUE(bin) measuredValue(base[0], bin)
#define precise // doubles are not reordered
