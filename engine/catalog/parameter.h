// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/parameter_type.h"
#include "core/value.h"

namespace patina {

/// Tells how a slider maps its length to the value.
enum class Scale { Linear, Log };

/// Tells where a vec3's numbers are counted from; the packer turns camera space into world space,
/// so that a block only ever sees world space.
enum class Space { None, WorldPoint, WorldDirection, CameraPoint, CameraDirection };

/// Tells what the shader generator does with a parameter.
enum class Compiled {
    No,       ///< a uniform: changing it never compiles
    Yes,      ///< its state is part of the program: a choice, a bool, whether a curve bends
    WhenZero, ///< a float: only whether it is zero is part of the program
    WhenEqual ///< a float: only whether it is the same as `equalTo` is part of the program
};

/// Says as what a number tells how wide a highlight is. Pictures may widen highlights by it.
enum class HighlightWidth {
    None,     ///< it does not
    Slope,    ///< of tiny mirrors, 0 .. 1
    Exponent, ///< of a power of n.h, 0 or more
    Angle     ///< of a bell curve over the angle between n and h, in radians
};

/// Holds one choice of an enum parameter, or one level of an accuracy choice.
struct EnumValue {
    std::string id;
    std::string label;
    std::string doc;
    bool exact = false;  ///< accuracy choices only: the level the others are measured against
    Values fills{};      ///< parameters of the same block that choosing this sets; see fills.h
    std::string table{}; ///< accuracy choices only: id of the block's table that the level reads

    friend bool operator==(const EnumValue&, const EnumValue&) = default;
};

/// A range outside which the editor warns that nothing real looks like that.
struct PhysicalRange {
    double min = 0.0;
    double max = 0.0;
    std::string message;

    friend bool operator==(const PhysicalRange&, const PhysicalRange&) = default;
};

/// A former id of a parameter, so that old files keep their values.
struct Migration {
    std::string from; ///< the id it had
    int until = 1;    ///< the last version of the block in which it had that id

    friend bool operator==(const Migration&, const Migration&) = default;
};

/// One parameter as its descriptor declares it. The only declaration there is: the GLSL struct,
/// the C++ struct, the widget, the command line and the preset check all come from it.
struct Parameter {
    std::string id; ///< dotted, shared across blocks where the meaning is the same
    std::string label;
    std::string doc; ///< the tooltip, in plain words
    ParameterType type = ParameterType::Float;
    Value defaultValue = 0.0;
    double min = 0.0; ///< hard range: what typing and files may reach (per component)
    double max = 1.0;
    double softMin = 0.0; ///< the slider's range
    double softMax = 1.0;
    double step = 0.01;
    Scale scale = Scale::Linear;
    std::string unit;
    int decimals = 3;
    std::string group;
    bool advanced = false;
    std::string enabledWhen;       ///< expression over sibling parameters; empty: always enabled
    std::vector<EnumValue> values; ///< enum only
    Compiled compiled = Compiled::No;
    std::vector<std::string> components; ///< what a vector's numbers are called
    std::string equalTo;                 ///< Compiled::WhenEqual: id of another float of the block
    Space space = Space::None;
    bool emission = false;     ///< a colour that is added once per pixel, whatever the light
    bool transparency = false; ///< a share of the light that passes: it lowers the opacity
    HighlightWidth highlight = HighlightWidth::None;
    std::string role; ///< what the program reads it as (ParameterRole::word); empty: nothing
    std::vector<std::string> textureChannels; ///< how an image may drive it; empty: it may not
    std::optional<PhysicalRange> physical;
    std::vector<Migration> migrations;

    friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// The place of the choice with this id; 0 where there is none.
std::size_t indexOf(const std::vector<EnumValue>& values, std::string_view id);

/// Number of float components a value of this type has in the shader (an enum, int or bool has 1).
int componentCount(ParameterType type);

/// Returns what the numbers of a vec2 or vec3 are called: as its descriptor says, else x, y, z.
/// Empty for the other types.
std::vector<std::string> componentNames(const Parameter& parameter);

/// `value` forced into the parameter's type and hard range; the default where the alternative is
/// wrong or a number is not finite.
Value conformed(const Parameter& parameter, const Value& value);

/// "diffuse.color" -> "diffuseColor": the field's name in GLSL and C++.
std::string fieldName(std::string_view parameterId);

} // namespace patina
