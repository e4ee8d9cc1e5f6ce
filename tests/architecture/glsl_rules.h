// SPDX-License-Identifier: GPL-3.0-or-later
// This file has the rules that let one shader text be GLSL and C++ (docs/design/blocks.md, "One
// source, two compilers"). They find what would break one of the two compilers, or mean different
// things to them.
#pragma once

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "shading/glsl/glsl_declarations.h"

namespace patina::tests {

struct GlslFinding {
    int line = 0;
    std::string rule;
};

/// Returns the names of the functions that a text without comments defines.
inline std::vector<std::string> glslFunctions(const std::string& text) {
    std::vector<std::string> names;
    for (const GlslFunction& function : functionsIn(glslTokens(text))) {
        names.emplace_back(function.name.text);
    }
    return names;
}

/// Checks one file of shaders/lib or one block against the rules. `library` holds the names of
/// the library's functions.
class GlslRules {
  public:
    GlslRules(const std::string& text, const std::set<std::string>& library)
        : text_(withoutComments(text)), functions_(library) {
        for (const std::string& name : glslFunctions(text_)) {
            functions_.insert(name);
        }
        static const char* const builtIn[] = {
            "abs",       "acos",        "all",   "any",        "asin",     "atan",    "ceil",
            "clamp",     "cos",         "cross", "degrees",    "distance", "dot",     "exp",
            "exp2",      "floor",       "fract", "length",     "log",      "log2",    "max",
            "min",       "mix",         "mod",   "normalize",  "pow",      "radians", "reflect",
            "refract",   "sign",        "sin",   "smoothstep", "sqrt",     "step",    "tan",
            "transpose", "inversesqrt", "round", "trunc"};
        functions_.insert(std::begin(builtIn), std::end(builtIn));
    }

    std::vector<GlslFinding> findings() {
        each(R"(\.([xyzw]{2,4}|[rgba]{2,4}|[stpq]{2,4})\b(?!\s*\())",
             "a swizzle of several components; name them one by one");
        each(R"(\b(?:float|int|bool|[biu]?vec[234]|mat[234])\s*\[\s*\w*\s*\]\s*\()",
             "an array constructor; assign the elements");
        each(R"(\^\^)", "^^; compare with !=");
        each(R"(\b(?!OUT\b)[A-Z]\w*[a-z]\w*\s*\()", "a struct constructor; assign the fields");
        each(R"(\b(?:out|inout|in)\s+\w+\s+\w+)", "an out parameter; write OUT(type)");
        each(R"(\b(?:uniform|varying|sampler\w+|samplerCube|texture\w*\s*\(|texelFetch|dFdx|dFdy|)"
             R"(fwidth|gl_\w+|discard)\b)",
             "a global of the pass; only passes/ has them");
        each(R"(\b(?:double|dvec[234]|unsigned|uint|uvec[234])\b)",
             "a type that the two compilers read differently; use float or int");
        each(R"(#\s*include\s+(?!"lib/\w+\.glsl"))", "an include of something outside lib/");
        each(R"(#\s*(?!include\b)\w+)", "a preprocessor line; write a constant or a function");
        integerLiterals();
        localNames();
        functionNames();
        std::sort(found_.begin(), found_.end(),
                  [](const GlslFinding& a, const GlslFinding& b) { return a.line < b.line; });
        return found_;
    }

  private:
    int lineAt(std::size_t position) const {
        return 1 + int(std::count(text_.begin(), text_.begin() + std::ptrdiff_t(position), '\n'));
    }

    void each(const char* form, const char* rule) {
        const std::regex pattern(form);
        for (std::sregex_iterator it(text_.begin(), text_.end(), pattern), end; it != end; ++it) {
            found_.push_back({lineAt(std::size_t(it->position())), rule});
        }
    }

    /// Returns the text between the last ; { or } and the position.
    std::string statementBefore(std::size_t position) const {
        const std::size_t start = text_.find_last_of(";{}", position);
        return start == std::string::npos ? text_.substr(0, position)
                                          : text_.substr(start + 1, position - start - 1);
    }

    /// Tells whether an integer is allowed at a position: in an index, an int's declaration or the
    /// head of a loop.
    bool mayCount(std::size_t position) const {
        const std::string line = text_.substr(text_.rfind('\n', position) + 1);
        const std::string statement = statementBefore(position);
        const auto open = std::count(statement.begin(), statement.end(), '[');
        const auto closed = std::count(statement.begin(), statement.end(), ']');
        static const std::regex counting(R"((?:^|\n)\s*(?:const\s+)?int\s)");
        static const std::regex loop(R"(^[^\n]*\bfor\s*\(\s*int\b)");
        return open > closed || std::regex_search(statement, counting) ||
               std::regex_search(line.substr(0, line.find('\n')), loop);
    }

    void integerLiterals() {
        static const std::regex number(R"((?:^|[^\w.])(\d+)(?![\w.]))");
        for (std::sregex_iterator it(text_.begin(), text_.end(), number), end; it != end; ++it) {
            const auto position = std::size_t(it->position(1));
            // 1e-30 is a float: its exponent's sign is not part of \w.
            const bool exponent =
                position >= 2 && (text_[position - 1] == '-' || text_[position - 1] == '+') &&
                (text_[position - 2] == 'e' || text_[position - 2] == 'E') && position >= 3 &&
                (std::isdigit(text_[position - 3]) != 0 || text_[position - 3] == '.');
            if (!exponent && !mayCount(position)) {
                found_.push_back({lineAt(position), "a whole number among floats; write a point"});
            }
        }
    }

    void localNames() {
        static const std::regex declaration(
            R"(\b(?:float|int|bool|[bi]?vec[234]|mat[234]|[A-Z]\w*[a-z]\w*|OUT\(\w+\))\s+)"
            R"(([A-Za-z]\w*)\s*([=;,)]))");
        for (std::sregex_iterator it(text_.begin(), text_.end(), declaration), end; it != end;
             ++it) {
            if (functions_.contains((*it)[1])) {
                found_.push_back({lineAt(std::size_t(it->position())),
                                  "a variable named like the function " + (*it)[1].str()});
            }
        }
    }

    void functionNames() {
        std::set<std::string> seen;
        for (const std::string& name : glslFunctions(text_)) {
            const std::regex whole("\\b" + name + "\\s*\\(");
            std::smatch match;
            std::regex_search(text_, match, whole);
            const int line = lineAt(std::size_t(match.position()));
            if (name.find('_') != std::string::npos ||
                std::isupper(static_cast<unsigned char>(name.front())) != 0) {
                found_.push_back({line, "a function name that is not camelCase"});
            }
            if (!seen.insert(name).second) {
                found_.push_back({line, "two functions of one name"});
            }
        }
    }

    std::string text_;
    std::set<std::string> functions_;
    std::vector<GlslFinding> found_;
};

} // namespace patina::tests
