// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/drawn_place.h"

#include <array>

#include <fmt/format.h>

#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Is a role, and what a program of a picture sets its parameter to.
struct PlaceSource {
    std::string_view role;
    const char* source;
};

constexpr std::array<PlaceSource, 9> placeSources{
    {{roles::place, "drawnPlace"},
     {roles::placeNormal, "drawnFacing()"},
     {roles::placeView, "drawnView()"},
     {roles::placePixel, "drawnPixel()"},
     {roles::placeCurvature, "drawnSide() * drawnCurvature"},
     {roles::placeCurvatureMixed, "drawnSide() * drawnCurvatureMixed"},
     {roles::coordinates, "drawnCoordinates(s)"},
     {roles::coordinatesRight, "drawnCoordinatesRight(s)"},
     {roles::coordinatesUp, "drawnCoordinatesUp(s)"}}};

bool readsPlace(const Block& block) {
    return block.withRole(roles::place) != nullptr;
}

bool readsCoordinates(const Block& block) {
    return block.withRole(roles::coordinates) != nullptr;
}

bool bends(const Block& block) {
    return block.withRole(roles::placeCurvature) != nullptr;
}

/// Tells whether the values lay a pattern on the surface, or the model has no width that says so.
bool hasPattern(const Block& block, const Values& values) {
    const Parameter* width = block.withRole(roles::patternWidth);
    return width == nullptr || !isZero(*width, values);
}

void addCode(SourceBuilder& out, const Block& drawing) {
    if (readsPlace(drawing)) {
        out.addFile("passes/drawn_place.glsl");
    }
    if (bends(drawing)) {
        out.addFile("passes/drawn_curvature.glsl");
    }
    if (readsCoordinates(drawing)) {
        out.addFile("passes/drawn_coordinates.glsl");
    }
}

} // namespace

void DrawnPlaceEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    drawing = nullptr;
    if (set.model) {
        const Block& block = set.model->block();
        const bool isTold = readsPlace(block) || readsCoordinates(block);
        drawing = isTold && hasPattern(block, subject.material.model.parameters) ? &block : nullptr;
    }
}

void DrawnPlaceEffect::list(EffectListing& listing, const EffectSet&) const {
    if (drawing != nullptr) {
        listing.add("drawn place", {},
                    always("The model draws on the surface and is told where each pixel is."));
    }
}

void DrawnPlaceEffect::writeLight(SurfaceText& text) const {
    if (drawing == nullptr || !(text.isPicture() || text.isInspected())) {
        return;
    }
    addCode(text.out, *drawing);
    for (const auto& [role, source] : placeSources) {
        if (const Parameter* parameter = drawing->withRole(role)) {
            text.main += fmt::format("    model.{} = {};\n", fieldName(parameter->id), source);
        }
    }
}

std::string DrawnPlaceEffect::writeVertex(SourceBuilder& vertex) const {
    if (drawing == nullptr) {
        return {};
    }
    std::string statements;
    if (readsPlace(*drawing)) {
        vertex.addFile("passes/drawn_place.vert");
        statements += "    placeDrawing();\n";
    }
    if (bends(*drawing)) {
        vertex.addFile("passes/drawn_curvature.vert");
        statements += "    placeCurvature();\n";
    }
    if (readsCoordinates(*drawing)) {
        vertex.addFile("passes/texture.vert");
        vertex.addFile("passes/drawn_coordinates.vert");
        statements += "    placeImages();\n    placePattern();\n";
    }
    return statements;
}

int DrawnPlaceEffect::bufferValues() const {
    return static_cast<int>(placedParameters(*this).size());
}

void DrawnPlaceEffect::writeBuffer(SurfaceText& text, std::size_t place) const {
    if (drawing == nullptr || bends(*drawing)) {
        return;
    }
    addCode(text.out, *drawing);
    for (const auto& [role, source] : placeSources) {
        if (const Parameter* parameter = drawing->withRole(role)) {
            const char* value =
                componentCount(parameter->type) == 2 ? "vec4({}, 0.0, 0.0)" : "vec4(vec3({}), 0.0)";
            text.main += fmt::format("    noteValue({}, {});\n", place++,
                                     fmt::format(fmt::runtime(value), source));
        }
    }
}

std::vector<const Parameter*> placedParameters(const DrawnPlaceEffect& effect) {
    std::vector<const Parameter*> placed;
    if (effect.drawing != nullptr && !bends(*effect.drawing)) {
        for (const auto& [role, source] : placeSources) {
            if (const Parameter* parameter = effect.drawing->withRole(role)) {
                placed.push_back(parameter);
            }
        }
    }
    return placed;
}

bool laysPattern(const DrawnPlaceEffect& effect) {
    return effect.drawing != nullptr && readsCoordinates(*effect.drawing);
}

bool readsCurvature(const DrawnPlaceEffect& effect) {
    return effect.drawing != nullptr && bends(*effect.drawing);
}

} // namespace patina
