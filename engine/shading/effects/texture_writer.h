// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "material/texture_use.h"
#include "shading/effects/data_layout.h"
#include "shading/program/source_builder.h"

namespace patina {

struct EffectSet;

/// Returns the name of the sampler of EffectSet::textures[index].
std::string samplerName(std::size_t index);

/// Writes what images bring into a program: their samplers, and statements of main. Where the set
/// has none, nothing.
class TextureWriter {
  public:
    TextureWriter(const EffectSet& set, const ObjectLayout& layout) : set_(set), layout_(layout) {}

    /// Writes texture coordinates, for the vertex stage, and the statements of its main. They are
    /// there without an image, too, if `always`.
    std::string writeVertex(SourceBuilder& out, bool always = false) const;

    /// Writes samplers and functions.
    void writeDeclarations(SourceBuilder& out) const;

    /// Writes those that opacity() needs alone.
    void writeOpacityDeclarations(SourceBuilder& out) const;

    /// Perturbs the normal of the Surface `s`.
    std::string relief() const;

    /// Changes the fields of a struct that holds the values of a kind: "models" with the slots
    /// inside, or a part by itself.
    std::string values(std::string_view kind, const std::string& variable) const;

    /// Works the opacity out, from an expression for that of the material, and leaves what is cut
    /// away undrawn. Sets `alpha` to the expression that counts from then on.
    std::string opacity(std::string& alpha) const;

  private:
    bool has(TextureRole role) const;
    bool hasFiles() const;
    void writeSamplers(SourceBuilder& out) const;
    std::string texel(std::size_t index) const;
    std::string changed(std::size_t index, const std::string& value) const;

    const EffectSet& set_;
    const ObjectLayout& layout_;
};

} // namespace patina
