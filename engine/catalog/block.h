// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/block_kind.h"
#include "catalog/block_table.h"
#include "catalog/parameter.h"
#include "catalog/shadow_projection.h"

namespace patina {

/// Offers several levels of computing the same thing more cheaply; the first level is exact.
struct AccuracyChoice {
    std::string id;
    std::string label;
    std::string doc;
    std::vector<EnumValue> values;

    friend bool operator==(const AccuracyChoice&, const AccuracyChoice&) = default;
};

/// Names a kind of block that this block calls (a microfacet model calls a Fresnel block). A slot
/// without a default may stay empty: the block's call is then not in the shader.
struct Slot {
    std::string kind; ///< is the folder name of the kind, such as "fresnel"
    /// Is the id of the block that fills it when nothing is chosen; empty: none does.
    std::string defaultBlock;

    friend bool operator==(const Slot&, const Slot&) = default;
};

/// Says what share of a surface a fog hides, so that it is known without running the fog's shader.
/// What is x metres away is hidden by the share 1 - exp(-(rate x)^power); or by none up to `from`,
/// all beyond `to`, and linearly more between them. With `base` and `thickness` the rate is
/// constant up to the height `base` and falls above it to 1/e with each `thickness`; its mean along
/// the ray is used then. With `center` and `size` the fog fills a box along the axes of the scene.
/// All strings are ids of parameters.
struct Hiding {
    std::string rate; ///< empty: `from` and `to` are used
    double power = 1.0;
    std::string from;
    std::string to;
    std::string base; ///< empty: the rate is the same at every height
    std::string thickness;
    std::string center; ///< empty: the fog is everywhere
    std::string size;
    bool atMost = false; ///< the fog hides this share or less

    friend bool operator==(const Hiding&, const Hiding&) = default;
};

/// Describes when one parameter or accuracy choice is neutral: a number, vector or colour when it
/// is 0 or less in every part, or equals another one; an enum or an accuracy choice when a certain
/// value is chosen.
struct NeutralValue {
    std::string id;
    std::string word; ///< is the chosen value, or the id of the other parameter; empty: 0

    friend bool operator==(const NeutralValue&, const NeutralValue&) = default;
};

/// Lists all conditions under which the block does nothing (gives exactly 0 everywhere, hides
/// nothing), so that it can be left out.
using NeutralCase = std::vector<NeutralValue>;

/// Says which points a light cannot reach: those farther than `range` from the point `from` (a
/// range of 0 has no end), and those outside of the cone with `angle` between its axis and its
/// side. The strings are ids of parameters; an empty one sets no limit.
struct Reach {
    std::string from;
    std::string range;
    std::string axis;
    std::string angle;

    friend bool operator==(const Reach&, const Reach&) = default;
};

/// Says how a pass works over a picture.
struct PictureUse {
    bool isLinear = false; ///< colours are linear light from 0 to 1; else they are sRGB encoded
    bool readsSurfaces = false; ///< the depth, normal and object of each pixel are drawn for it
    /// Lists what it draws before its result, one image after the other: what a function's name
    /// has behind that of the block.
    std::vector<std::string> stages;

    friend bool operator==(const PictureUse&, const PictureUse&) = default;
};

/// Tells which lights a model uses.
enum class LightsWanted {
    All, ///< the model reflects light from wherever it comes
    /// Only the key light is used: the model is a drawing, which several lights would wash out.
    Key
};

/// Describes a lighting model, Fresnel term, light, ...: a descriptor and a GLSL file with one
/// stem.
struct Block {
    std::string kind; ///< is the folder: "models", "fresnel", "specular", "lights", ...
    std::string id;   ///< is the stem of both files
    std::vector<std::string> formerIds; ///< older files still use these for it
    int version = 1;
    std::string label;
    std::string summary;
    std::string applications;
    std::string source; ///< names paper and equation
    std::string doc;
    std::vector<Parameter> parameters;
    std::vector<AccuracyChoice> accuracy;
    std::vector<BlockTable> tables; ///< is empty unless the kind has tables
    std::vector<Slot> slots;
    std::vector<std::string> claims;
    std::map<std::string, std::string> exemptions; ///< maps a claim to why it is not made
    std::vector<std::string> gates; ///< names horizons ("light", "view") below which the value is 0
    LightsWanted lighting = LightsWanted::All;                  ///< applies to models only
    ShadowProjection shadowProjection = ShadowProjection::None; ///< applies to lights only
    std::optional<Hiding> hides;                                ///< applies to fog only
    std::optional<Reach> reach;                                 ///< applies to lights only
    PictureUse picture;                                         ///< applies to passes only
    std::vector<NeutralCase> neutral; ///< the block does nothing when one of them holds
    std::filesystem::path descriptorFile;
    std::filesystem::path shaderFile;
    bool shipped = true; ///< false: the block is from the user's folder

    const Parameter* parameter(std::string_view parameterId) const;

    /// Returns the first parameter that has the role; null where none has.
    const Parameter* withRole(std::string_view role) const;

    const AccuracyChoice* accuracyChoice(std::string_view choiceId) const;
    const BlockTable* table(std::string_view tableId) const;
    const Slot* slot(std::string_view slotKind) const;
    bool hasClaim(std::string_view claim) const;
    bool hasGate(std::string_view gate) const;

    friend bool operator==(const Block&, const Block&) = default;
};

/// Returns the defaults of all parameters by their ids.
Values defaultValues(const Block& block);

/// Returns the name of the block's parameter struct in GLSL and C++: "CookTorrance",
/// "SchlickFresnel", "PointLight", "LinearFog": the id in Pascal case, and the kind's word except
/// for models.
std::string structName(const Block& block);

/// Returns the name of the block's function: the struct's name with a lower-case first letter.
std::string functionName(const Block& block);

} // namespace patina
