// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/private_names.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/text.h"
#include "shading/glsl/tokens.h"

namespace patina {
namespace {

using Names = std::set<std::string_view>;

/// Maps a name to the argument types of its functions, "(float,vec3)"; empty for anything that is
/// no function.
using Declared = std::map<std::string_view, std::set<std::string>>;

/// Says what a part of a program declares and uses.
struct Stretch {
    Declared declared;
    Names macros;
    Names fields; ///< are the names that follow a dot
    Names words;
};

/// Adds the words of all tokens, those of directives too.
void addWords(Stretch& stretch, const GlslTokens& tokens) {
    std::string_view before;
    for (const GlslToken& token : opened(tokens)) {
        if (token.isName()) {
            stretch.words.insert(token.text);
        }
        if (token.isName() && before == ".") {
            stretch.fields.insert(token.text);
        }
        before = token.text;
    }
}

/// Returns the macro that "#  define NAME..." defines; empty for any other directive.
std::string_view definedMacro(const GlslToken& directive) {
    const GlslTokens tokens = directiveTokens(directive);
    return tokens.size() > 1 && tokens[0].text == "define" ? tokens[1].text : std::string_view();
}

/// Tells whether token `i` is a declared name: one after a type (or comma) and before a sign that
/// ends a name. The caller looks only outside of braces and parentheses.
bool declares(const GlslTokens& tokens, std::size_t i) {
    if (i == 0 || i + 1 >= tokens.size() || !tokens[i].isName()) {
        return false;
    }
    constexpr std::string_view ends = "(={;[,";
    const GlslToken& before = tokens[i - 1];
    const std::string_view next = tokens[i + 1].text;
    const bool followsType = before.isName() && !isPrecision(before.text);
    return (followsType || before.text == "]" || before.text == ",") && next.size() == 1 &&
           ends.find(next) != std::string_view::npos;
}

/// Returns the argument types of what is declared at `i`, "(float,vec3)"; empty when it is no
/// function.
std::string argumentsOf(const GlslTokens& tokens, std::size_t i) {
    std::string arguments;
    int depth = 0;
    for (++i; i < tokens.size() && tokens[i].text.find_first_of("=;{") != 0; ++i) {
        const std::string_view token = tokens[i].text;
        depth += token == "(" ? 1 : token == ")" ? -1 : 0;
        const bool isLast =
            i + 1 < tokens.size() && (tokens[i + 1].text == "," || tokens[i + 1].text == ")");
        const bool isName = isLast && tokens[i].isName() && token != "void" &&
                            (tokens[i - 1].isName() || tokens[i - 1].text == ")") &&
                            !isQualifier(tokens[i - 1].text);
        if (!isName && !isQualifier(token) && token != "void") {
            arguments += token;
        }
        if (depth == 0) {
            return arguments;
        }
    }
    return {};
}

Stretch stretchOf(std::string_view text) {
    Stretch stretch;
    const GlslTokens tokens = glslTokens(text);
    addWords(stretch, tokens);
    int depth = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view token = tokens[i].text;
        if (tokens[i].isDirective()) {
            stretch.macros.insert(definedMacro(tokens[i]));
        }
        if (depth == 0 && declares(tokens, i)) {
            stretch.declared[token].insert(argumentsOf(tokens, i));
        }
        depth += token == "{" || token == "(" ? 1 : token == "}" || token == ")" ? -1 : 0;
    }
    stretch.macros.erase(std::string_view());
    return stretch;
}

/// Holds lines to put before and after a block.
struct Frame {
    std::vector<std::string> before;
    std::vector<std::string> after;
};

class Framer {
  public:
    Framer(std::string_view text, std::span<const BlockPart> parts) : parts_(parts) {
        std::size_t done = 0;
        for (const BlockPart& part : parts) {
            around_.push_back(stretchOf(text.substr(done, part.first - done)));
            own_.push_back(stretchOf(text.substr(part.first, part.last - part.first)));
            done = part.last;
        }
        around_.push_back(stretchOf(text.substr(done)));
    }

    Frame frameOf(std::size_t block) const {
        const Stretch& own = own_[block];
        Frame frame;
        for (const auto& [name, kinds] : own.declared) {
            if (!isPublic(name, parts_[block]) && !own.fields.contains(name) && !isAround(name) &&
                (isInOtherBlock(name, block) || isDoubled(name, kinds))) {
                frame.before.push_back(
                    fmt::format("#define {} {}Of{}", name, name, parts_[block].structName));
                frame.after.push_back(fmt::format("#undef {}", name));
            }
        }
        for (const std::string_view name : own.macros) {
            if (isUsedElsewhere(name, block) && !isAround(name)) {
                frame.after.push_back(fmt::format("#undef {}", name));
            }
        }
        return frame;
    }

  private:
    static bool isPublic(std::string_view name, const BlockPart& part) {
        return name.starts_with(part.structName) || name.starts_with(part.functionName) ||
               name.starts_with(constantCase(part.structName) + '_');
    }

    bool isInOtherBlock(std::string_view name, std::size_t block) const {
        for (std::size_t i = 0; i < own_.size(); ++i) {
            if (i != block && (own_[i].declared.contains(name) || own_[i].macros.contains(name))) {
                return true;
            }
        }
        return false;
    }

    /// Tells whether Patina's own text declares the name, too. A function with other argument types
    /// may have the same name, and the block may call either.
    bool isDoubled(std::string_view name, const std::set<std::string>& kinds) const {
        return std::ranges::any_of(around_, [&](const Stretch& stretch) {
            const auto found = stretch.declared.find(name);
            return found != stretch.declared.end() &&
                   (kinds.contains("") || found->second.contains("") ||
                    std::ranges::any_of(kinds, [&](const std::string& kind) {
                        return found->second.contains(kind);
                    }));
        });
    }

    bool isUsedElsewhere(std::string_view name, std::size_t block) const {
        const auto uses = [&](const Stretch& stretch) { return stretch.words.contains(name); };
        for (std::size_t i = 0; i < own_.size(); ++i) {
            if (i != block && uses(own_[i])) {
                return true;
            }
        }
        return std::ranges::any_of(around_, uses);
    }

    /// Tells whether Patina's own text has a macro of this name: to define it again is a mistake,
    /// and is left for the driver to report.
    bool isAround(std::string_view name) const {
        return std::ranges::any_of(
            around_, [&](const Stretch& stretch) { return stretch.macros.contains(name); });
    }

    std::span<const BlockPart> parts_;
    std::vector<Stretch> own_;
    std::vector<Stretch> around_; ///< is the text before, between and after the parts
};

/// Copies lines, and renumbers those that are in no file.
class Writer {
  public:
    void lines(const std::vector<std::string>& more) {
        for (const std::string& line : more) {
            write(line);
        }
    }

    void text(std::string_view rest) {
        while (!rest.empty()) {
            const std::size_t end = rest.find('\n');
            const std::string_view line = rest.substr(0, end);
            if (line.starts_with("#line ") && line.ends_with(" 0")) {
                write(fmt::format("#line {} 0", lines_ + 2));
            } else {
                write(line);
            }
            rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        }
    }

    std::string take() { return std::move(text_); }

  private:
    void write(std::string_view line) {
        text_.append(line);
        text_ += '\n';
        ++lines_;
    }

    std::string text_;
    int lines_ = 0;
};

} // namespace

ShaderSource withPrivateNames(ShaderSource source, std::span<const BlockPart> parts) {
    if (parts.empty()) {
        return source;
    }
    const Framer framer(source.text, parts);
    const std::string_view text = source.text;
    Writer writer;
    std::size_t done = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Frame frame = framer.frameOf(i);
        writer.text(text.substr(done, parts[i].first - done));
        writer.lines(frame.before);
        writer.text(text.substr(parts[i].first, parts[i].last - parts[i].first));
        writer.lines(frame.after);
        done = parts[i].last;
    }
    writer.text(text.substr(done));
    source.text = writer.take();
    return source;
}

} // namespace patina
