// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/interpreter/shader_lexemes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "shading/glsl/text_places.h"
#include "shading/glsl/tokens.h"

namespace patina {
namespace {

using Lexemes = std::vector<ShaderLexeme>;

/// Limits what macros may make of a text.
constexpr std::size_t maxLexemes = 2000000;
constexpr int maxMacroDepth = 32;

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Returns the end of the number that begins at `first`, with its suffix.
std::size_t numberEnd(std::string_view text, std::size_t first) {
    double ignored = 0.0;
    const char* const end =
        std::from_chars(text.data() + first, text.data() + text.size(), ignored).ptr;
    auto last = std::max(first + 1, static_cast<std::size_t>(end - text.data()));
    while (last < text.size() && std::string_view("fFuU").find(text[last]) != text.npos) {
        ++last;
    }
    return last;
}

constexpr std::array<std::string_view, 16> pairs{
    "==", "!=", "<=", ">=", "&&", "||", "^^", "+=", "-=", "*=", "/=", "%=", "++", "--", "<<", ">>"};

/// Joins the tokens of one stretch of text, which the scanner gives sign by sign, to lexemes.
Lexemes joined(std::string_view text, const GlslTokens& tokens, int file) {
    Lexemes lexemes;
    std::size_t taken = 0;
    for (const GlslToken& token : tokens) {
        const auto first = static_cast<std::size_t>(token.text.data() - text.data());
        if (first < taken) {
            continue;
        }
        std::size_t last = first + token.text.size();
        const bool startsFraction =
            text[first] == '.' && first + 1 < text.size() && isDigit(text[first + 1]);
        const bool isNumber = isDigit(text[first]) || startsFraction;
        if (isNumber) {
            last = numberEnd(text, first);
        } else if (std::ranges::find(pairs, text.substr(first, 2)) != pairs.end()) {
            last = first + 2;
        }
        taken = last;
        lexemes.push_back({text.substr(first, last - first), first, last, isNumber, false, file});
    }
    return lexemes;
}

struct Macro {
    bool takesArguments = false;
    std::vector<std::string_view> arguments;
    Lexemes body;
};

class Preprocessor {
  public:
    explicit Preprocessor(const ShaderSource& source) : source_(source), text_(source.text) {}

    Result<Lexemes> run() {
        GlslTokens pending;
        for (const GlslToken& token : glslTokens(text_)) {
            if (!token.isDirective()) {
                if (isKept()) {
                    pending.push_back(token);
                }
                continue;
            }
            // A macro's arguments never span a directive in our texts, except #line.
            if (directiveName(token) == "line") {
                flush(pending);
                readLine(token);
                continue;
            }
            flush(pending);
            expandAll();
            read(token);
        }
        flush(pending);
        expandAll();
        if (problem_) {
            return tl::unexpected(*problem_);
        }
        return std::move(out_);
    }

  private:
    bool isKept() const { return std::ranges::find(kept_, false) == kept_.end(); }

    void flush(GlslTokens& pending) {
        const Lexemes more = joined(text_, pending, file_);
        waiting_.insert(waiting_.end(), more.begin(), more.end());
        pending.clear();
    }

    void expandAll() {
        append(out_, waiting_, 0);
        waiting_.clear();
    }

    void readLine(const GlslToken& directive) {
        const GlslTokens words = directiveTokens(directive);
        if (words.size() >= 3) {
            std::from_chars(words[2].text.data(), words[2].text.data() + words[2].text.size(),
                            file_);
        }
    }

    void read(const GlslToken& directive) {
        const GlslTokens words = directiveTokens(directive);
        const std::string_view name = directiveName(directive);
        const std::string_view word = words.size() > 1 ? words[1].text : std::string_view();
        if (name == "ifdef" || name == "ifndef") {
            kept_.push_back(macros_.contains(word) == (name == "ifdef"));
        } else if (name == "else" && !kept_.empty()) {
            kept_.back() = !kept_.back();
        } else if (name == "endif" && !kept_.empty()) {
            kept_.pop_back();
        } else if (!isKept() || name == "version" || name == "extension" || name == "pragma") {
            return;
        } else if (name == "define" && words.size() > 1) {
            define(words);
        } else if (name == "undef") {
            macros_.erase(word);
        } else {
            complain(static_cast<std::size_t>(directive.text.data() - text_.data()),
                     fmt::format("#{} is not understood here", name));
        }
    }

    void define(const GlslTokens& words) {
        Macro macro;
        const std::string_view name = words[1].text;
        std::size_t next = 2;
        if (words.size() > 2 && words[2].text == "(" &&
            words[2].text.data() == name.data() + name.size()) {
            macro.takesArguments = true;
            for (next = 3; next < words.size() && words[next].text != ")"; ++next) {
                if (words[next].text != ",") {
                    macro.arguments.push_back(words[next].text);
                }
            }
            ++next;
        }
        GlslTokens body;
        for (; next < words.size(); ++next) {
            if (words[next].text != "\\") {
                body.push_back(words[next]);
            }
        }
        macro.body = joined(text_, body, file_);
        macros_[name] = std::move(macro);
    }

    /// Appends lexemes with their macros replaced.
    void append(Lexemes& out, const Lexemes& in, int depth) {
        for (std::size_t i = 0; i < in.size() && !problem_; ++i) {
            const auto found = macros_.find(in[i].text);
            const bool isCalled = i + 1 < in.size() && in[i + 1].text == "(";
            if (found == macros_.end() || (found->second.takesArguments && !isCalled)) {
                out.push_back(in[i]);
            } else if (depth >= maxMacroDepth || out.size() > maxLexemes) {
                complain(in[i].first, "macros replace each other without an end");
            } else if (!found->second.takesArguments) {
                appendMade(out, found->second.body, in[i], depth);
            } else {
                const std::size_t use = i;
                const std::vector<Lexemes> given = argumentsAt(in, i);
                appendMade(out, filled(found->second, given), in[use], depth);
            }
        }
    }

    /// Appends what a macro makes. What was written as its argument keeps its place in the text.
    void appendMade(Lexemes& out, Lexemes body, const ShaderLexeme& use, int depth) {
        for (ShaderLexeme& lexeme : body) {
            lexeme.isMade = true;
            lexeme.first = use.first;
            lexeme.last = use.last;
            lexeme.file = use.file;
        }
        append(out, body, depth + 1);
    }

    /// Reads the arguments of a macro's use at in[i], and moves i to the closing parenthesis.
    static std::vector<Lexemes> argumentsAt(const Lexemes& in, std::size_t& i) {
        std::vector<Lexemes> given(1);
        int open = 0;
        for (++i; i < in.size(); ++i) {
            const std::string_view text = in[i].text;
            open += text == "(" ? 1 : text == ")" ? -1 : 0;
            if (open == 0) {
                break;
            }
            if (open == 1 && text == ",") {
                given.emplace_back();
            } else if (open > 1 || text != "(") {
                given.back().push_back(in[i]);
            }
        }
        return given;
    }

    static Lexemes filled(const Macro& macro, const std::vector<Lexemes>& given) {
        Lexemes body;
        for (const ShaderLexeme& lexeme : macro.body) {
            const auto found = std::ranges::find(macro.arguments, lexeme.text);
            const auto index = static_cast<std::size_t>(found - macro.arguments.begin());
            if (index < given.size() && found != macro.arguments.end()) {
                body.insert(body.end(), given[index].begin(), given[index].end());
            } else {
                body.push_back(lexeme);
            }
        }
        return body;
    }

    void complain(std::size_t place, std::string text) {
        if (!problem_) {
            problem_ = errorAt(source_, place, std::move(text));
        }
    }

    const ShaderSource& source_;
    std::string_view text_;
    std::map<std::string_view, Macro> macros_;
    std::vector<bool> kept_;
    Lexemes waiting_;
    Lexemes out_;
    int file_ = 0;
    std::optional<Error> problem_;
};

} // namespace

Result<std::vector<ShaderLexeme>> shaderLexemes(const ShaderSource& source) {
    return Preprocessor(source).run();
}

} // namespace patina
