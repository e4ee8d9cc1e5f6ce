// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace patina {

/// Names a field of a struct or an argument of a function.
struct Variable {
    std::string type;
    std::string name;
    bool out = false; ///< says that it is declared OUT(type)
};

struct StructDeclaration {
    std::string name;
    std::vector<Variable> fields;
};

struct FunctionDeclaration {
    std::string result; ///< is its type; "void" for none
    std::string name;
    std::vector<Variable> arguments;

    /// Returns "float f(float x, OUT(float) y)".
    std::string signature() const;
};

/// Holds what a shader text without comments declares at its top level.
struct Declarations {
    std::vector<StructDeclaration> structs;
    std::vector<FunctionDeclaration> functions;

    const StructDeclaration* findStruct(const std::string& name) const;

    /// Returns how many numbers a value of the type is made of; 0 for void and for types that are
    /// not numbers.
    std::size_t numbers(const std::string& type) const;
};

Declarations declarationsOf(const std::string& text);

} // namespace patina
