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

/// A named way to compute the same thing more cheaply; its first level is exact.
struct AccuracyChoice {
    std::string id;
    std::string label;
    std::string doc;
    std::vector<EnumValue> values;

    friend bool operator==(const AccuracyChoice&, const AccuracyChoice&) = default;
};

/// A kind of block that this block calls (a microfacet model calls a Fresnel block). A slot without
/// a default may stay empty: the block's call is then not in the shader.
struct Slot {
    std::string kind;         ///< folder name of the kind, e.g. "fresnel"
    std::string defaultBlock; ///< id of what fills it when nothing is chosen; empty: nothing does

    friend bool operator==(const Slot&, const Slot&) = default;
};

/// Holds what share of a surface a fog hides, said in its descriptor so that nobody has to run its
/// shader to know: 1 - exp(-(rate x)^power) of what is x metres away, or none up to `from`, all
/// behind `to` and evenly more between them. With `base` and `thickness` the rate is that up to the
/// height `base` and falls above it to 1/e with each `thickness`, and x stands for its mean over
/// the way. With `center` and `size` it fills a box along the axes of the scene. Ids of parameters.
struct Hiding {
    std::string rate; ///< empty: by `from` and `to`
    double power = 1.0;
    std::string from;
    std::string to;
    std::string base; ///< empty: the rate is the same at every height
    std::string thickness;
    std::string center; ///< empty: it fills no box but everything
    std::string size;
    bool atMost = false; ///< it hides so much or less

    friend bool operator==(const Hiding&, const Hiding&) = default;
};

/// A number, vector or colour that is 0 or less in every part, or is the same as another one; an
/// enum or an accuracy choice.
struct NeutralValue {
    std::string id;
    std::string word; ///< what is chosen, or the other parameter's id; empty: 0

    friend bool operator==(const NeutralValue&, const NeutralValue&) = default;
};

/// All that must be so for the block to do nothing (give exactly 0 everywhere, hide nothing), said
/// in its descriptor so that it can be left out.
using NeutralCase = std::vector<NeutralValue>;

/// Names the points a light cannot reach, said in its descriptor: those farther than `range` from
/// the point `from` (a range of 0 has no end), and those outside of the cone with `angle` between
/// its axis and its side. Ids of parameters; an empty one sets no limit.
struct Reach {
    std::string from;
    std::string range;
    std::string axis;
    std::string angle;

    friend bool operator==(const Reach&, const Reach&) = default;
};

/// Tells how a model wants to be lit.
enum class LightsWanted {
    All, ///< it is what a surface reflects, from wherever light comes
    Key  ///< by one light: it is a drawing, and the sum over several would be a veil upon it
};

/// Holds a lighting model, Fresnel term, light, ...: a descriptor and a GLSL file with one stem.
struct Block {
    std::string kind; ///< the folder: "models", "fresnel", "specular", "lights", ...
    std::string id;   ///< the stem of both files
    std::vector<std::string> formerIds; ///< by which older files still name it
    int version = 1;
    std::string label;
    std::string summary;
    std::string applications;
    std::string source; ///< paper and equation
    std::string doc;
    std::vector<Parameter> parameters;
    std::vector<AccuracyChoice> accuracy;
    std::vector<BlockTable> tables; ///< of the kinds that may have them only
    std::vector<Slot> slots;
    std::vector<std::string> claims;
    std::map<std::string, std::string> exemptions; ///< claim -> why it is not made
    std::vector<std::string> gates; ///< "light", "view": below which horizons the value is 0
    LightsWanted lighting = LightsWanted::All;                  ///< models only
    ShadowProjection shadowProjection = ShadowProjection::None; ///< lights only
    std::optional<Hiding> hides;                                ///< fog only
    std::optional<Reach> reach;                                 ///< lights only
    std::vector<NeutralCase> neutral;                           ///< one of them is enough
    std::filesystem::path descriptorFile;
    std::filesystem::path shaderFile;
    bool shipped = true; ///< false: from the user's folder

    const Parameter* parameter(std::string_view parameterId) const;

    /// The first parameter that has the role; null where none has.
    const Parameter* withRole(std::string_view role) const;

    const AccuracyChoice* accuracyChoice(std::string_view choiceId) const;
    const BlockTable* table(std::string_view tableId) const;
    const Slot* slot(std::string_view slotKind) const;
    bool hasClaim(std::string_view claim) const;
    bool hasGate(std::string_view gate) const;

    friend bool operator==(const Block&, const Block&) = default;
};

/// Returns the defaults of all parameters.
Values defaultValues(const Block& block);

/// Name of the block's parameter struct in GLSL and C++: "CookTorrance", "SchlickFresnel",
/// "PointLight", "LinearFog": the id in Pascal case, and the kind's word except for models.
std::string structName(const Block& block);

/// Name of the block's function: the struct's name with a small first letter.
std::string functionName(const Block& block);

} // namespace patina
