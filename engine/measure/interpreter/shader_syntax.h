// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace patina {

struct ShaderBuiltin;

/// Is a type of GLSL: a scalar, a vector, a matrix, a struct, or an array of one of these.
struct ShaderType {
    enum class Base { Void, Bool, Int, Float, Struct };
    Base base = Base::Void;
    int rows = 1;
    int columns = 1;
    int structure = -1; ///< is an index of ShaderSyntax::structs
    int length = 0;     ///< of an array; 0: it is none

    bool isFloat() const { return base == Base::Float && length == 0; }
    bool isScalar() const { return rows == 1 && columns == 1 && base != Base::Struct && !length; }
    bool isNumber() const { return isFloat() && isScalar(); }

    friend bool operator==(const ShaderType&, const ShaderType&) = default;
};

/// Is one expression of a shader, whose operands are indices of ShaderSyntax::expressions.
struct ShaderExpression {
    enum class Kind {
        Literal,
        Local,  ///< reads a variable or an argument of the function at `place` of its numbers
        Global, ///< reads a constant of the text
        Field,
        Swizzle,
        Index,
        Unary,
        Binary,
        Choice,
        Call, ///< calls a function of the text
        Builtin,
        Construct,
        Assign,
        Step ///< is ++ or --
    };
    Kind kind = Kind::Literal;
    ShaderType type{};
    std::size_t size = 1;    ///< counts the numbers of its value
    std::string_view sign{}; ///< is the operator, "" or the name of what is read or called
    std::vector<int> operands{};
    double number = 0.0;
    std::size_t place = 0; ///< of a variable in its frame, of a field in its struct
    std::array<int, 4> components{};
    int function = -1; ///< is an index of ShaderSyntax::functions
    const ShaderBuiltin* builtin = nullptr;
    bool isPrefix = false;
    int owner = -1; ///< is the function that it stands in; -1: a constant of the text
    /// Are the offsets of its first byte and behind its last one; equal where a macro made it.
    std::size_t first = 0;
    std::size_t last = 0;
};

struct ShaderStatement {
    enum class Kind { Group, Expression, If, Loop, Return, Break, Continue };
    Kind kind = Kind::Group;
    int expression = -1; ///< is what is computed, the condition, or what is returned
    int step = -1;       ///< is what a loop does between two rounds
    bool testsLast = false;
    std::vector<int> statements{}; ///< of a group; the branches of an if; the body of a loop
    bool isBlock = false;          ///< is a group in braces
    std::vector<std::size_t> declares{}; ///< are the places of the variables that it declares
    std::size_t first = 0;               ///< are the offsets of its text
    std::size_t last = 0;
};

struct ShaderVariable {
    ShaderType type;
    std::string_view name;
    std::size_t place = 0; ///< in the numbers of its function, or of its struct
    std::size_t size = 0;
    bool isOut = false;
};

struct ShaderStruct {
    std::string_view name;
    std::vector<ShaderVariable> fields;
    std::size_t size = 0;
};

struct ParsedFunction {
    std::string_view name;
    ShaderType result;
    std::size_t resultSize = 0;
    std::vector<ShaderVariable> arguments;
    std::size_t frame = 0; ///< counts the numbers of its arguments and variables
    int body = -1;         ///< is a statement; -1 where nothing that was asked for calls it
    int file = 0;          ///< is an index of ShaderSource::files
    std::size_t first = 0; ///< are the offsets of its whole definition in the text
    std::size_t last = 0;
    std::vector<int> calls{}; ///< are the functions that it calls, each once
};

struct ShaderConstant {
    std::string_view name;
    ShaderType type;
    std::size_t place = 0;
    std::size_t size = 0;
    int value = -1; ///< is an expression
};

/// Holds the parsed functions of a shader that one function needs. It points into the text, which
/// must outlive it.
struct ShaderSyntax {
    std::string_view text;
    std::vector<ShaderStruct> structs;
    std::vector<ParsedFunction> functions;
    std::vector<ShaderExpression> expressions;
    std::vector<ShaderStatement> statements;
    std::vector<ShaderConstant> constants;
    std::size_t constantNumbers = 0;

    /// Returns the index of the first function of that name; -1 where there is none.
    int functionNamed(std::string_view name) const;

    std::string_view textOf(const ShaderExpression& expression) const {
        return text.substr(expression.first, expression.last - expression.first);
    }
};

} // namespace patina
