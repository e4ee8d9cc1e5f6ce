// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/block_kind.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <vector>

#include "catalog/combing_role.h"
#include "catalog/index_trend.h"
#include "catalog/measured_file.h"
#include "catalog/picture_roles.h"

namespace patina {
namespace {

template <class... Functions>
constexpr auto functions(const Functions&... all) {
    return std::array<BlockFunction, sizeof...(all)>{all...};
}

using Field = ArgumentField::Type;

constexpr auto atInterface =
    std::to_array<ArgumentField>({{.key = "l", .type = Field::Direction},
                                  {.key = "n", .type = Field::Normal},
                                  {.key = "channel", .type = Field::Whole, .max = 2, .usual = 1},
                                  {.key = "leaves", .type = Field::Flag, .usual = 0}});
constexpr auto way = std::to_array<ArgumentField>({{.key = "way", .type = Field::Amount}});
constexpr auto edge =
    std::to_array<ArgumentField>({{.key = "silhouette", .type = Field::Flag, .usual = 0},
                                  {.key = "open", .type = Field::Flag, .usual = 0},
                                  {.key = "dihedral", .max = std::numbers::pi, .usual = 0}});
constexpr auto strand = std::to_array<ArgumentField>({{.key = "height", .usual = 0.5},
                                                      {.key = "n", .type = Field::Direction},
                                                      {.key = "nl", .usual = 1},
                                                      {.key = "size", .usual = 1},
                                                      {.key = "shade", .usual = 0.5},
                                                      {.key = "phase", .usual = 0.5}});
constexpr auto mark =
    std::to_array<ArgumentField>({{.key = "along", .usual = 0.5},
                                  {.key = "across", .usual = 0.5},
                                  {.key = "pixel", .usual = 0.1},
                                  {.key = "aspect", .max = 64, .usual = 1},
                                  {.key = "n", .type = Field::Direction},
                                  {.key = "t", .type = Field::Direction},
                                  {.key = "v", .type = Field::Direction},
                                  {.key = "radiance", .type = Field::Color, .usual = 1},
                                  {.key = "order", .usual = 0.5},
                                  {.key = "size", .usual = 0.5},
                                  {.key = "shade", .usual = 0.5},
                                  {.key = "phase", .usual = 0.5}});
constexpr auto layer = std::to_array<ArgumentField>({{.key = "depth"}, {.key = "opacity"}});
constexpr auto skyRay =
    std::to_array<ArgumentField>({{.key = "direction", .type = Field::Direction, .member = "d"},
                                  {.key = "picture", .type = Field::Color, .usual = 1.0}});

constexpr auto ofDirections = functions(BlockFunction{"", "vec3", "Directions", "d"});
constexpr auto ofFresnel =
    functions(BlockFunction{"", "vec3", "Incidence", "i"}, BlockFunction{"Tint", "vec3"});
constexpr auto ofRefraction =
    functions(BlockFunction{"", "vec3", "Interface", "c", true, atInterface},
              BlockFunction{"Mirrored", "float", "Interface", "c", false, atInterface},
              BlockFunction{"Left", "vec3", "float", "way", false, way});
constexpr auto ofOutline =
    functions(BlockFunction{"", "vec2", "Edge", "e", false, edge}, BlockFunction{"Color", "vec3"});
constexpr auto ofShells = functions(BlockFunction{"", "vec3", "Directions", "d"},
                                    BlockFunction{"Offset", "vec3", "Strand", "s", true, strand},
                                    BlockFunction{"Radius", "float", "Strand", "s", false, strand},
                                    BlockFunction{"Curl", "vec2", "Strand", "s", true, strand},
                                    BlockFunction{"Tint", "vec3", "Strand", "s", false, strand});
constexpr auto ofStrokes =
    functions(BlockFunction{"", "vec3", "MarkPoint", "m", false, mark},
              BlockFunction{"Share", "float", "MarkPoint", "m", false, mark},
              BlockFunction{"Size", "vec2", "MarkPoint", "m", false, mark},
              BlockFunction{"Along", "vec3", "MarkPoint", "m", true, mark},
              BlockFunction{"Shape", "float", "MarkPoint", "m", false, mark},
              BlockFunction{"Opacity", "float", "MarkPoint", "m", false, mark},
              BlockFunction{"Under", "vec3", "MarkPoint", "m", false, mark});
constexpr auto ofLights = functions(BlockFunction{"", "Illumination", "vec3", "x"});
constexpr auto ofShadows = functions(BlockFunction{"", "float", "ShadowPoint", "s"});
constexpr auto ofFog =
    functions(BlockFunction{"", "float", "FogRay", "ray"}, BlockFunction{"Color", "vec3"});
constexpr auto ofTransparency = functions(BlockFunction{"", "float", "Layer", "l", false, layer});
constexpr auto radiance = std::to_array<ArgumentField>({{.key = "radiance", .type = Field::Color}});
constexpr auto ofTone = functions(BlockFunction{"", "vec3", "vec3", "light", false, radiance});
constexpr auto ofPass = functions(BlockFunction{"", "vec3", "PicturePoint", "at"});
constexpr auto ofEnvironment = functions(BlockFunction{"", "vec3", "SkyRay", "o", false, skyRay});

constexpr std::array<std::string_view, 2> indexSources{"surface", "own"};
constexpr std::array<std::string_view, 2> strandLights{"surface", "strand"};
constexpr std::array<std::string_view, 2> layerings{"painted", "standing"};
constexpr std::array<std::string_view, 3> polarisations{"unpolarised", "s", "p"};
constexpr std::array<std::string_view, 2> falloffs{"polynomial", "inverse-square"};
constexpr std::array<std::string_view, 3> backdrops{"sharp", "blurred", "hidden"};

constexpr std::array<std::string_view, 5> blends{"replace", "over", "multiply", "screen", "add"};
constexpr std::array<std::string_view, 3> depthTests{"everywhere", "surfaces", "background"};

constexpr auto inModels = std::to_array<ParameterRole>(
    {{roles::index},
     {roles::wavelengths, ParameterType::Vec3},
     {roles::place, ParameterType::Vec3},
     {roles::placeNormal, ParameterType::Vec3},
     {roles::placeView, ParameterType::Vec3},
     {roles::placePixel},
     {roles::placeCurvature, ParameterType::Vec3},
     {roles::placeCurvatureMixed, ParameterType::Vec3},
     {roles::coordinates, ParameterType::Vec2},
     {roles::coordinatesRight, ParameterType::Vec2},
     {roles::coordinatesUp, ParameterType::Vec2},
     {roles::patternWidth},
     {grainRole, ParameterType::Measured},
     {.word = roles::diffuse, .type = ParameterType::Color, .mayRepeat = true},
     {.word = roles::screenLength, .mayRepeat = true}});
constexpr auto inPass = std::to_array<ParameterRole>(
    {{.word = roles::blend, .type = ParameterType::Enum, .choices = blends},
     {roles::blendAmount},
     {roles::threshold, ParameterType::Texture},
     {.word = roles::accuracy, .type = ParameterType::Enum, .mayRepeat = true},
     {.word = roles::depthTest, .type = ParameterType::Enum, .choices = depthTests}});
constexpr auto inFresnel = std::to_array<ParameterRole>(
    {{roles::indexOutside},
     {roles::indexInside},
     {roles::temperature},
     {roles::temperatureMeasured},
     {roles::temperatureSlope},
     {roles::expansion},
     {roles::index, ParameterType::Vec3},
     {roles::extinction, ParameterType::Vec3},
     {roles::wavelengths, ParameterType::Vec3},
     {.word = roles::polarisation, .type = ParameterType::Enum, .choices = polarisations},
     {roles::f0, ParameterType::Color}});
constexpr auto inRefraction = std::to_array<ParameterRole>(
    {{.word = roles::index, .isNeeded = true},
     {.word = roles::indexFrom, .type = ParameterType::Enum, .choices = indexSources},
     {roles::dispersion},
     {roles::thickness},
     {.word = roles::filter, .type = ParameterType::Color, .mayRepeat = true}});
constexpr auto inOutline =
    std::to_array<ParameterRole>({{.word = roles::width, .mayRepeat = true}});
constexpr auto inShells = std::to_array<ParameterRole>(
    {{.word = roles::length, .isNeeded = true},
     {.word = roles::density, .isNeeded = true},
     {.word = roles::lighting, .type = ParameterType::Enum, .choices = strandLights},
     {roles::combing, ParameterType::Vec3},
     {roles::fins, ParameterType::Bool}});
constexpr auto inStrokes = std::to_array<ParameterRole>(
    {{.word = roles::density, .isNeeded = true},
     {.word = roles::length, .isNeeded = true},
     {.word = roles::width, .isNeeded = true},
     {.word = roles::layering, .type = ParameterType::Enum, .choices = layerings}});
constexpr auto inLights = std::to_array<ParameterRole>(
    {{roles::color, ParameterType::Color},
     {roles::intensity},
     {.word = roles::falloff, .type = ParameterType::Enum, .choices = falloffs},
     {roles::constant},
     {roles::linear},
     {roles::quadratic},
     {roles::nearest},
     {roles::diffuseColor, ParameterType::Color},
     {roles::highlightColor, ParameterType::Color},
     {roles::ambientColor, ParameterType::Color},
     {roles::polarised},
     {roles::fieldDirection, ParameterType::Vec3}});
constexpr auto inSpecular =
    std::to_array<ParameterRole>({{roles::ambientColor, ParameterType::Color}});
constexpr auto inShadows = std::to_array<ParameterRole>(
    {{roles::samples, ParameterType::Enum}, {roles::angle, ParameterType::Angle}});
constexpr auto inFog = std::to_array<ParameterRole>({{roles::color, ParameterType::Color}});
constexpr auto inTransparency = std::to_array<ParameterRole>({{roles::layers, ParameterType::Int}});
constexpr auto inEnvironment = std::to_array<ParameterRole>(
    {{.word = roles::background, .type = ParameterType::Enum, .choices = backdrops},
     {roles::blur, ParameterType::Angle},
     {roles::rotate, ParameterType::Angle},
     {roles::directions, ParameterType::Int},
     {roles::limit}});

constexpr auto rows = std::to_array<BlockKind>({
    {.folder = kinds::models,
     .singular = "model",
     .plural = "models",
     .label = "Model",
     .word = "",
     .owner = BlockOwner::Material,
     .functions = ofDirections,
     .isPart = false,
     .hasTables = true,
     .roles = inModels},
    {.folder = kinds::fresnel,
     .singular = "fresnel",
     .plural = "Fresnel terms",
     .label = "Fresnel",
     .word = "Fresnel",
     .owner = BlockOwner::Material,
     .functions = ofFresnel,
     .hasTables = true,
     .roles = inFresnel},
    {.folder = kinds::specular,
     .singular = "specular",
     .plural = "highlights",
     .label = "Highlight",
     .word = "Specular",
     .owner = BlockOwner::Material,
     .functions = ofDirections,
     .needsSlot = true,
     .hasTables = true,
     .roles = inSpecular},
    {.folder = kinds::refraction,
     .singular = "refraction",
     .plural = "refractions",
     .label = "Refraction",
     .word = "Refraction",
     .owner = BlockOwner::Material,
     .functions = ofRefraction,
     .roles = inRefraction},
    {.folder = kinds::outline,
     .singular = "outline",
     .plural = "outlines",
     .label = "Outline",
     .word = "Outline",
     .owner = BlockOwner::Material,
     .functions = ofOutline,
     .roles = inOutline},
    {.folder = kinds::shells,
     .singular = "shells",
     .plural = "shells",
     .label = "Shells",
     .word = "Shells",
     .owner = BlockOwner::Material,
     .functions = ofShells,
     .absent = "No fur or grass",
     .roles = inShells},
    {.folder = kinds::strokes,
     .singular = "strokes",
     .plural = "strokes",
     .label = "Strokes",
     .word = "Strokes",
     .owner = BlockOwner::Material,
     .functions = ofStrokes,
     .absent = "No strokes",
     .roles = inStrokes},
    {.folder = kinds::lights,
     .singular = "light",
     .plural = "lights",
     .label = "Light",
     .word = "Light",
     .owner = BlockOwner::Light,
     .functions = ofLights,
     .isPart = false,
     .roles = inLights},
    {.folder = kinds::shadows, // they read maps that the graphics device has drawn
     .singular = "shadow",
     .plural = "shadows",
     .label = "Shadows",
     .word = "Shadow",
     .owner = BlockOwner::Light,
     .functions = ofShadows,
     .hasReference = false,
     .isInBlockLabels = true,
     .roles = inShadows},
    {.folder = kinds::fog,
     .singular = "fog",
     .plural = "kinds of fog",
     .label = "Fog",
     .word = "Fog",
     .owner = BlockOwner::Scene,
     .functions = ofFog,
     .roles = inFog},
    {.folder = kinds::transparency,
     .singular = "transparency",
     .plural = "kinds of transparency",
     .label = "Transparency",
     .word = "Transparency",
     .owner = BlockOwner::Scene,
     .functions = ofTransparency,
     .isInBlockLabels = true,
     .absent = "Sorted by object",
     .noneWord = "sorted",
     .roles = inTransparency},
    {.folder = kinds::environment,
     .singular = "environment",
     .plural = "environments",
     .label = "Environment",
     .word = "Environment",
     .owner = BlockOwner::Scene,
     .functions = ofEnvironment,
     .roles = inEnvironment},
    {.folder = kinds::tone,
     .singular = "tone",
     .plural = "tone curves",
     .label = "Tone curve",
     .word = "Tone",
     .owner = BlockOwner::Scene,
     .functions = ofTone,
     .isInBlockLabels = true,
     .absent = "None"},
    {.folder = kinds::pass, // they read the picture that the graphics device has drawn
     .singular = "pass",
     .plural = "picture passes",
     .label = "Picture pass",
     .word = "Pass",
     .owner = BlockOwner::Scene,
     .functions = ofPass,
     .isPart = false,
     .isInRow = true,
     .hasReference = false,
     .isInBlockLabels = true,
     .roles = inPass},
});

using Folders = std::map<BlockOwner, std::vector<std::string_view>>;

Folders partsByOwner() {
    Folders parts;
    for (const BlockKind& kind : blockKinds()) {
        if (kind.isPart) {
            parts[kind.owner].push_back(kind.folder);
        }
    }
    return parts;
}

} // namespace

std::span<const BlockKind> shippedBlockKinds() {
    return rows;
}

const BlockKind* findKind(std::string_view folder) {
    const auto all = blockKinds();
    const auto found = std::ranges::find(all, folder, &BlockKind::folder);
    return found == all.end() ? nullptr : &*found;
}

std::span<const std::string_view> partKinds(BlockOwner owner) {
    static const Folders parts = partsByOwner();
    const auto found = parts.find(owner);
    return found == parts.end() ? std::span<const std::string_view>() : found->second;
}

} // namespace patina
