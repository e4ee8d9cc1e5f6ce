// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "catalog/parameter.h"
#include "catalog/shadow_projection.h"

namespace patina {

/// Maps the words that descriptors use to the values of an enumeration.
template <class T, std::size_t N>
using Words = std::array<std::pair<std::string_view, T>, N>;

inline constexpr Words<Scale, 2> scaleWords{{{"linear", Scale::Linear}, {"log", Scale::Log}}};

inline constexpr Words<Space, 5> spaceWords{{{"none", Space::None},
                                             {"worldPoint", Space::WorldPoint},
                                             {"worldDirection", Space::WorldDirection},
                                             {"cameraPoint", Space::CameraPoint},
                                             {"cameraDirection", Space::CameraDirection}}};

inline constexpr Words<HighlightWidth, 4> highlightWords{{{"none", HighlightWidth::None},
                                                          {"slope", HighlightWidth::Slope},
                                                          {"exponent", HighlightWidth::Exponent},
                                                          {"angle", HighlightWidth::Angle}}};

inline constexpr Words<LightsWanted, 2> lightingWords{
    {{"all", LightsWanted::All}, {"key", LightsWanted::Key}}};

inline constexpr Words<ShadowProjection, 4> shadowProjectionWords{
    {{"none", ShadowProjection::None},
     {"parallel", ShadowProjection::Parallel},
     {"cone", ShadowProjection::Cone},
     {"sphere", ShadowProjection::Sphere}}};

template <class T, std::size_t N>
std::optional<T> meaningOf(const Words<T, N>& words, std::string_view word) {
    for (const auto& [text, meaning] : words) {
        if (text == word) {
            return meaning;
        }
    }
    return std::nullopt;
}

template <class T, std::size_t N>
std::string_view wordFor(const Words<T, N>& words, T meaning) {
    for (const auto& [text, known] : words) {
        if (known == meaning) {
            return text;
        }
    }
    return {};
}

} // namespace patina
