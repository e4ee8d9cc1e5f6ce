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

/// Tells which coordinate system a vec3's numbers are in; the packer transforms camera space to
/// world space, so that a block only ever sees world space.
enum class Space { None, WorldPoint, WorldDirection, CameraPoint, CameraDirection };

/// Tells what the shader generator does with a parameter.
enum class Compiled {
    No,       ///< the value is a uniform: changing it never compiles
    Yes,      ///< the state is part of the program: a choice, a bool, whether a curve bends
    WhenZero, ///< the program depends only on whether a float is zero
    WhenEqual ///< the program depends only on whether a float equals `equalTo`
};

/// Says which measure of a highlight's width a number is. Images may widen highlights by it.
enum class HighlightWidth {
    None,     ///< it is no measure of a width
    Slope,    ///< it is the slope of the microfacets, 0 .. 1
    Exponent, ///< it is the exponent of n.h, 0 or more
    Angle     ///< it is the width of a bell curve over the angle between n and h, in radians
};

/// Holds one choice of an enum parameter, or one level of an accuracy choice.
struct EnumValue {
    std::string id;
    std::string label;
    std::string doc;
    /// Is true for the first level of an accuracy choice only: the others are compared with it.
    bool exact = false;
    Values fills{}; ///< choosing this sets these parameters of the same block; see fills.h
    /// Is the id of the block's table that a level of an accuracy choice reads.
    std::string table{};

    friend bool operator==(const EnumValue&, const EnumValue&) = default;
};

/// Is a range outside which the editor warns that no real material has such values.
struct PhysicalRange {
    double min = 0.0;
    double max = 0.0;
    std::string message;

    friend bool operator==(const PhysicalRange&, const PhysicalRange&) = default;
};

/// Names a former id of a parameter, so that old files keep their values.
struct Migration {
    std::string from; ///< is the id it had
    int until = 1;    ///< is the last version of the block in which it had that id

    friend bool operator==(const Migration&, const Migration&) = default;
};

/// Declares one parameter as its descriptor does. Everything else comes from it: the GLSL struct,
/// the C++ struct, the widget, the command line and the preset check.
struct Parameter {
    std::string id; ///< is dotted, and the same across blocks where the meaning is the same
    std::string label;
    std::string doc; ///< is the tooltip, in plain words
    ParameterType type = ParameterType::Float;
    Value defaultValue = 0.0;
    /// Is the lower end of each component's hard range, which typed values and files cannot leave.
    double min = 0.0;
    double max = 1.0;
    double softMin = 0.0; ///< is the lower end of the slider's range
    double softMax = 1.0;
    double step = 0.01;
    Scale scale = Scale::Linear;
    std::string unit;
    std::string zeroText; ///< is shown in place of 0, as "automatic"; empty: 0 is
    int decimals = 3;
    std::string group;
    bool advanced = false;
    /// Is an expression over sibling parameters; empty: it is always enabled.
    std::string enabledWhen;
    std::vector<EnumValue> values; ///< is empty for all types but enum
    Compiled compiled = Compiled::No;
    std::vector<std::string> components; ///< names a vector's numbers
    std::string equalTo; ///< is the id of another float of the block, for Compiled::WhenEqual
    Space space = Space::None;
    bool emission = false; ///< the colour is added once per pixel, whatever the light
    /// The value is a transmitted share of the light: it lowers the opacity.
    bool transparency = false;
    HighlightWidth highlight = HighlightWidth::None;
    std::string role; ///< says what the program reads it as (ParameterRole::word); empty: nothing
    /// Lists the channels by which an image may drive it; empty: none may.
    std::vector<std::string> textureChannels;
    std::optional<PhysicalRange> physical;
    std::vector<Migration> migrations;

    friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// Returns the index of the choice with this id; 0 where there is none.
std::size_t indexOf(const std::vector<EnumValue>& values, std::string_view id);

/// Returns the number of float components that a value of this type has in the shader (an enum, int
/// or bool has 1).
int componentCount(ParameterType type);

/// Returns the names of the numbers of a vec2 or vec3: those of its descriptor, else x, y, z. The
/// list is empty for the other types.
std::vector<std::string> componentNames(const Parameter& parameter);

/// Returns `value` forced into the parameter's type and hard range; the default where the
/// alternative is wrong or a number is not finite.
Value conformed(const Parameter& parameter, const Value& value);

/// Returns the field's name in GLSL and C++: "diffuse.color" -> "diffuseColor".
std::string fieldName(std::string_view parameterId);

} // namespace patina
