// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "catalog/value_error.h"
#include "core/value.h"

namespace patina {

struct Parameter;

/// Lists the types of parameters. A type is its name here, the row that `infoOf<Name>()` gives, and
/// the editor that `make<Name>Editor()` makes (app/editor/parameters/editor_factory.h).
#define PATINA_PARAMETER_TYPES(type)                                                               \
    type(Float) type(Int) type(Bool) type(Color) type(Vec2) type(Vec3) type(Angle) type(Enum)      \
        type(Texture) type(Measured) type(Curve) type(Ramp)

#define PATINA_ENUMERATOR(name) name,
enum class ParameterType { PATINA_PARAMETER_TYPES(PATINA_ENUMERATOR) };
#undef PATINA_ENUMERATOR

/// Is the largest number of components that a value has in the data of a shader.
inline constexpr int maxComponents = 72;

/// Describes the function that a block calls for a value that is a function: `<result>
/// <block><Field>(<argument> x, <Block> p)`.
struct ShaderFunction {
    std::string_view result; ///< GLSL type: "float", "vec3"

    /// Is GLSL that is also C++. It reads PARAMETER_DATA(i), the value's vec4s from 0, and ends in
    /// a return.
    std::string_view body;

    /// Is the word of state 0, in which the function is `plainBody` and reads nothing: the struct
    /// has a bool `<field><Word>` for it, which is true when the first number is 0. It is empty
    /// when there is no such state.
    std::string_view plainWord{};
    std::string_view plainBody{};

    std::string_view argument{"float"}; ///< GLSL type of x
    /// Is GLSL that stands before the function in a program: what it reads beside its numbers.
    std::string_view before{};
};

/// Holds everything that is known of a type of parameter; code that depends on the type reads it
/// here.
struct ParameterTypeInfo {
    std::string_view word;           ///< names the type in descriptors
    int components = 1;              ///< counts the numbers of a value in a shader's data; may be 0
    std::string_view glsl = "float"; ///< is the GLSL type of the field that holds it
    std::string_view cpp = "double"; ///< is the C++ type of the same field in the reference
    bool hasRange = true;            ///< a value is made of numbers, which have limits
    bool needsRange = true;          ///< a descriptor must give the limits
    bool isContinuous = true;        ///< a small change of a number changes the picture slightly
    bool isAlwaysCompiled = false;   ///< the state of a value is part of the program
    bool isWhole = false;            ///< its numbers have no fraction
    bool isAngle = false;            ///< a value is in degrees, and in radians in the shader
    bool isColor = false;            ///< a value is linear light
    bool isChoice = false;           ///< a value is the id of one of Parameter::values
    bool isFile = false;             ///< a value names a file, and is kept with the images
    bool isTable = false;            ///< a value names a file whose table is a texture
    bool hasAxes = false;            ///< its numbers have names, which a descriptor may change
    bool takesImage = false;         ///< an image may drive it
    double step = 0.01;              ///< is used where the descriptor gives none
    int decimals = 3;
    std::string_view unit{};

    ValueReading (*fromJson)(const Parameter&, const nlohmann::json&) = nullptr;
    /// Parses typed or pasted text. The value is not brought into its range; it is empty where the
    /// text is no value of the type.
    std::optional<Value> (*fromText)(const Parameter&, std::string_view) = nullptr;
    std::string (*expected)(const Parameter&) = nullptr; ///< says what may be typed
    std::string (*range)(const Parameter&) = nullptr;    ///< says what a value can be, for lists
    /// Writes a value that is a NumberList; null for the other types.
    nlohmann::json (*toJson)(const NumberList&) = nullptr;
    std::string (*toText)(const NumberList&) = nullptr;
    std::string (*summary)(const NumberList&) = nullptr; ///< describes the list in a word or two
    /// Returns the part of a list that its number at an index belongs to.
    ValuePart (*part)(std::size_t index) = nullptr;

    /// Does what conformed() and writeNumbers() do; the value has the same alternative as the
    /// default.
    Value (*conformed)(const Parameter&, const Value&) = nullptr;
    void (*pack)(const Parameter&, const Value&, double* out) = nullptr;

    /// Returns edge-case values of the type, made of edge-case numbers of the parameter's range.
    std::vector<Value> (*edgeCases)(const Parameter&, std::span<const double>) = nullptr;
    /// Returns a value made of numbers of the slider's range, which `next` gives.
    Value (*ordinary)(const Parameter&, const std::function<double()>& next) = nullptr;

    /// Returns one value for each state, which is what of a value is part of a program; `state`
    /// gives the state of a value. All three are null when no value of the type can be compiled in.
    std::vector<Value> (*states)(const Parameter&) = nullptr;
    std::size_t (*state)(const Parameter&, const Value&) = nullptr;
    /// Returns the word of a state. It points into the parameter, or to static data.
    std::string_view (*stateWord)(const Parameter&, std::size_t state) = nullptr;

    const ShaderFunction* function = nullptr; ///< is null when a field holds the value itself
};

#define PATINA_DECLARATION(name) const ParameterTypeInfo& infoOf##name();
PATINA_PARAMETER_TYPES(PATINA_DECLARATION)
#undef PATINA_DECLARATION

const ParameterTypeInfo& infoOf(ParameterType type);

/// Returns all types, in their order.
std::span<const ParameterType> parameterTypes();

/// Returns the type that a descriptor's word names; nothing where none has it.
std::optional<ParameterType> parameterTypeOf(std::string_view word);

/// Returns the row of a list's type; null where no type has this word.
const ParameterTypeInfo* infoOf(const NumberList& list);

/// Writes the numbers of a value as the shader has them: forced into the type and the hard range,
/// angles in radians, a choice as its index. A value of another type, or one that is not finite,
/// gives the default. `out` has room for the type's components. Allocates nothing.
void writeNumbers(const Parameter& parameter, const Value& value, double* out);

/// Returns the numbers in "[1, 2, 3]", "1, 2, 3" or "1 2 3"; nothing where anything else stands.
std::optional<std::vector<double>> numbersIn(std::string_view text);

} // namespace patina
