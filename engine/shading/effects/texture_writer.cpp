// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/texture_writer.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "catalog/combing_role.h"
#include "shading/effects/effect_set.h"

namespace patina {
namespace {

/// Returns a literal that GLSL takes for a float.
std::string literal(double value) {
    constexpr double maxFloat = std::numeric_limits<float>::max();
    std::string text =
        fmt::format("{}", static_cast<float>(std::clamp(value, -maxFloat, maxFloat)));
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

const char* swizzle(TextureChannel channel) {
    switch (channel) {
    case TextureChannel::Red:
        return "r";
    case TextureChannel::Green:
        return "g";
    case TextureChannel::Blue:
        return "b";
    case TextureChannel::Alpha:
        return "a";
    default:
        return "rgb";
    }
}

const char* mask(TextureChannel channel) {
    switch (channel) {
    case TextureChannel::Green:
        return "vec4(0.0, 1.0, 0.0, 0.0)";
    case TextureChannel::Blue:
        return "vec4(0.0, 0.0, 1.0, 0.0)";
    case TextureChannel::Alpha:
        return "vec4(0.0, 0.0, 0.0, 1.0)";
    default:
        return "vec4(1.0, 0.0, 0.0, 0.0)";
    }
}

const char* operation(TextureMode mode) {
    return mode == TextureMode::Multiply ? " * " : " + ";
}

} // namespace

std::string samplerName(std::size_t index) {
    return fmt::format("image{}", index);
}

bool TextureWriter::has(TextureRole role) const {
    return std::ranges::any_of(set_.textures,
                               [role](const BoundTexture& each) { return each.role == role; });
}

bool TextureWriter::hasFiles() const {
    return !std::ranges::all_of(set_.textures, &BoundTexture::isOfVertices);
}

std::string TextureWriter::writeVertex(SourceBuilder& out, bool always) const {
    std::string statements;
    if (hasFiles() || always) {
        out.addFile("passes/texture.vert");
        statements += "    placeImages();\n";
    }
    if (has(TextureRole::Height)) {
        out.addFile("passes/texture_height.vert");
        statements += "    placeHeights();\n";
    }
    if (set_.readsVertexColors()) {
        out.addFile("passes/vertex_color.vert");
        statements += "    placeVertexColor();\n";
    }
    return statements;
}

void TextureWriter::writeDeclarations(SourceBuilder& out) const {
    if (set_.readsVertexColors()) {
        out.addFile("passes/vertex_color.glsl");
    }
    if (!hasFiles()) {
        return;
    }
    out.addFile("passes/texture.glsl");
    if (std::ranges::any_of(set_.textures, &BoundTexture::isOfRoots)) {
        out.addFile("passes/texture_roots.glsl");
    }
    if (has(TextureRole::Normal)) {
        out.addFile("passes/texture_normal.glsl");
    }
    if (has(TextureRole::Height)) {
        out.addFile("passes/texture_height.glsl");
    }
    writeSamplers(out);
}

void TextureWriter::writeOpacityDeclarations(SourceBuilder& out) const {
    if (!set_.textures.empty()) {
        out.addFile("passes/texture_place.glsl");
        writeSamplers(out);
    }
}

void TextureWriter::writeSamplers(SourceBuilder& out) const {
    for (std::size_t i = 0; i < set_.textures.size(); ++i) {
        if (!set_.textures[i].isOfVertices) {
            out.add(fmt::format("uniform sampler2D {};\n", samplerName(i)));
        }
    }
}

/// Returns the part of the image that counts, as a colour where the value is one.
std::string TextureWriter::texel(std::size_t index) const {
    const BoundTexture& texture = set_.textures[index];
    const std::string whole = texture.isOfVertices
                                  ? "vertexColor"
                                  : fmt::format("texture({}, imagePlace({}))", samplerName(index),
                                                layout_.texture(index));
    const std::string read = whole + '.' + swizzle(texture.channel);
    const bool widens = texture.isColor() && texture.channel != TextureChannel::Color;
    const bool narrows = !texture.isColor() && texture.channel == TextureChannel::Color;
    if (narrows && texture.isOfVertices) {
        return "vertexGrey()";
    }
    const std::string taken = narrows ? "imageGrey(" + read + ")" : read;
    const std::string meant = texture.isOfRoots ? "imageSquare(" + taken + ")" : taken;
    return widens ? "vec3(" + meant + ")" : meant;
}

std::string TextureWriter::changed(std::size_t index, const std::string& value) const {
    const BoundTexture& texture = set_.textures[index];
    const std::string made = texture.mode == TextureMode::Replace
                                 ? texel(index)
                                 : value + operation(texture.mode) + texel(index);
    const Parameter* parameter = texture.parameter;
    const char* form = texture.isOfVertices ? "clamp(mix({}, {}, objectData[{}].w), {}, {})"
                                            : "imaged({}, {}, {}, {}, {})";
    return fmt::format(fmt::runtime(form), value, made, layout_.texture(index),
                       literal(parameter ? parameter->min : 0.0),
                       literal(parameter ? parameter->max : 1.0));
}

std::string TextureWriter::relief() const {
    std::string out;
    for (std::size_t i = 0; i < set_.textures.size(); ++i) {
        const int place = layout_.texture(i);
        if (set_.textures[i].role == TextureRole::Normal) {
            out += fmt::format("    s = normalMapped(s, texture({}, imagePlace({})).rgb, {});\n",
                               samplerName(i), place, place);
        } else if (set_.textures[i].role == TextureRole::Height) {
            out += fmt::format("    s = heightMapped(s, {}, {}, {});\n", samplerName(i),
                               mask(set_.textures[i].channel), place);
        }
    }
    return out;
}

std::string TextureWriter::values(std::string_view kind, const std::string& variable) const {
    std::string out;
    for (std::size_t i = 0; i < set_.textures.size(); ++i) {
        const BoundTexture& texture = set_.textures[i];
        if (texture.role != TextureRole::Input || texture.kind != kind ||
            texture.parameter->role == roles::combing) { // which is read where layers are placed
            continue;
        }
        const std::string field = variable + '.' + fieldName(texture.parameter->id);
        out += fmt::format("    {} = {};\n", field, changed(i, field));
    }
    return out;
}

std::string TextureWriter::opacity(std::string& alpha) const {
    for (std::size_t i = 0; i < set_.textures.size(); ++i) {
        if (set_.textures[i].role != TextureRole::Opacity) {
            continue;
        }
        const std::string there = fmt::format("    float there = {};\n", changed(i, alpha));
        if (set_.textures[i].cutOut) {
            return there + fmt::format("    if (there < objectData[{}].w) {{\n        discard;\n"
                                       "    }}\n",
                                       layout_.texture(i) + 1);
        }
        alpha = "there";
        return there + "    if (!(there > 0.0)) {\n        discard;\n    }\n";
    }
    return {};
}

} // namespace patina
