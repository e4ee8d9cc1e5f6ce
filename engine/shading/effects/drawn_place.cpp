// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/drawn_place.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "catalog/bending_roles.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

/// Are the roles, each with what a program of a picture sets its parameter to.
constexpr std::array<std::pair<std::string_view, const char*>, 6> placeSources{
    {{roles::place, "drawnPlace"},
     {roles::placeNormal, "drawnFacing()"},
     {roles::placeView, "drawnView()"},
     {roles::placePixel, "drawnPixel()"},
     {roles::placeCurvature, "drawnSide() * drawnCurvature"},
     {roles::placeCurvatureMixed, "drawnSide() * drawnCurvatureMixed"}}};

bool readsCurvature(const Block& block) {
    return block.withRole(roles::placeCurvature) != nullptr;
}

} // namespace

void DrawnPlaceEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    (void)subject;
    drawing = set.model && set.model->block().withRole(roles::place) != nullptr
                  ? &set.model->block()
                  : nullptr;
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
    text.out.addFile("passes/drawn_place.glsl");
    if (readsCurvature(*drawing)) {
        text.out.addFile("passes/drawn_curvature.glsl");
    }
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
    vertex.addFile("passes/drawn_place.vert");
    if (!readsCurvature(*drawing)) {
        return "    placeDrawing();\n";
    }
    vertex.addFile("passes/drawn_curvature.vert");
    return "    placeDrawing();\n    placeCurvature();\n";
}

} // namespace patina
