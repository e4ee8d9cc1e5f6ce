// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/unused_code.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "shading/glsl/tokens.h"

namespace patina {
namespace {

constexpr std::string_view lineWord = "#line ";
constexpr std::string_view entryPoint = "main";

/// Is a line of the text, with the file and line number that `#line` gives it.
struct Line {
    std::string_view text;
    int number = 0; ///< is the number as a compiler counts it
    std::size_t file = 0;
    std::span<const GlslToken> tokens{}; ///< are the tokens that begin in the line
};

/// Is an independent part at the top level of a shader: a function, a declaration, a macro.
struct Item {
    std::size_t first = 0; ///< is the index of its first line
    std::size_t last = 0;
    std::string_view name; ///< is the name that it declares; empty: it is always needed
    std::vector<std::string_view> words;
    bool isNeeded = false;
};

/// Returns the lines, without those of `#line`.
std::vector<Line> linesOf(std::string_view text, std::span<const GlslToken> tokens) {
    std::vector<Line> lines;
    Line next{{}, 1, 0};
    for (int row = 1; !text.empty(); ++row) {
        const std::size_t end = text.find('\n');
        next.text = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        std::size_t count = 0;
        while (count < tokens.size() && tokens[count].line == row) {
            ++count;
        }
        next.tokens = tokens.first(count);
        tokens = tokens.subspan(count);
        if (next.text.starts_with(lineWord)) {
            const char* const stop = next.text.data() + next.text.size();
            const auto [after, read] =
                std::from_chars(next.text.data() + lineWord.size(), stop, next.number);
            std::from_chars(std::min(after + 1, stop), stop, next.file);
            continue;
        }
        lines.push_back(next);
        ++next.number;
    }
    return lines;
}

bool isOneOf(std::string_view token, std::string_view signs) {
    return token.size() == 1 && signs.find(token.front()) != std::string_view::npos;
}

/// Returns the first token that is one of some signs.
GlslTokens::const_iterator firstOf(const GlslTokens& tokens, std::string_view signs) {
    return std::ranges::find_if(
        tokens, [signs](const GlslToken& token) { return isOneOf(token.text, signs); });
}

/// Returns the last name before a place; empty where there is none.
std::string_view nameBefore(const GlslTokens& tokens, GlslTokens::const_iterator place) {
    const auto found = std::find_if(std::make_reverse_iterator(place), tokens.rend(),
                                    [](const GlslToken& token) { return token.isName(); });
    return found == tokens.rend() ? std::string_view() : found->text;
}

/// Returns the macro that a directive defines or undefines; empty for any other directive.
std::string_view definedOrDroppedMacro(const GlslToken& directive) {
    const GlslTokens tokens = directiveTokens(directive);
    const bool isMacro =
        tokens.size() > 1 && (tokens[0].text == "define" || tokens[0].text == "undef");
    return isMacro ? tokens[1].text : std::string_view();
}

/// Returns the name that a declaration or definition declares; empty where it must be kept anyway.
std::string_view nameOf(const GlslTokens& head) {
    const auto end = firstOf(head, "(={;[");
    const auto names = std::count_if(head.begin(), firstOf(head, "({=;"),
                                     [](const GlslToken& token) { return token.isName(); });
    if (names < 2) {
        return {};
    }
    const std::string_view first = head.front().text;
    if (first == "struct") {
        return head[1].text;
    }
    if (first == "const") {
        return end != head.end() ? nameBefore(head, end) : std::string_view();
    }
    const bool isFunction = end != head.end() && end->text == "(";
    const bool isInterface = first == "layout" || first == "uniform" || first == "in" ||
                             first == "out" || first == "flat" || first == "precision";
    return isFunction && !isInterface ? nameBefore(head, end) : std::string_view();
}

/// Splits the text into items; gives nothing where its brackets do not match.
class ItemReader {
  public:
    explicit ItemReader(const std::vector<Line>& lines) : lines_(lines) {}

    std::optional<std::vector<Item>> read() {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::span<const GlslToken> tokens = lines_[i].tokens;
            const bool begins = depth_ == 0 && parentheses_ == 0 && item_.first == i;
            const GlslToken* directive =
                !tokens.empty() && tokens.back().isDirective() ? &tokens.back() : nullptr;
            if (directive != nullptr) { // with the lines that it is continued on
                i += static_cast<std::size_t>(std::ranges::count(directive->text, '\n'));
            }
            item_.last = i;
            take(tokens);
            if (begins && directive != nullptr) {
                finish(definedOrDroppedMacro(*directive));
            } else if (depth_ < 0 || parentheses_ < 0) {
                return std::nullopt;
            } else if (isEnded_) {
                finish(nameOf(head_));
            }
        }
        return depth_ == 0 && item_.first == lines_.size() ? std::optional(std::move(items_))
                                                           : std::nullopt;
    }

  private:
    void take(std::span<const GlslToken> tokens) {
        for (const GlslToken& token : tokens) {
            if (token.isDirective()) {
                take(directiveTokens(token));
                continue;
            }
            head_.push_back(token);
            if (token.isName()) {
                item_.words.push_back(token.text);
            }
            follow(token.text);
        }
    }

    void follow(std::string_view token) {
        hasParenthesis_ = hasParenthesis_ || token == "(";
        if (token == "{" && !hasBrace_) {
            hasBrace_ = true;
            bracesFollowParenthesis_ = hasParenthesis_;
        }
        depth_ += token == "{" ? 1 : token == "}" ? -1 : 0;
        parentheses_ += token == "(" ? 1 : token == ")" ? -1 : 0;
        // A function ends with its brace; what else has braces goes on to a semicolon.
        const bool isBody = token == "}" && isFunction();
        isEnded_ = depth_ == 0 && parentheses_ == 0 && (token == ";" || isBody);
    }

    bool isFunction() const {
        const std::string_view first = head_.front().text;
        return bracesFollowParenthesis_ && first != "layout" && first != "uniform" &&
               first != "const";
    }

    void finish(std::string_view name) {
        item_.name = name;
        const std::size_t next = item_.last + 1;
        items_.push_back(std::move(item_));
        item_ = Item();
        item_.first = next;
        head_.clear();
        depth_ = 0;
        parentheses_ = 0;
        hasParenthesis_ = false;
        hasBrace_ = false;
        bracesFollowParenthesis_ = false;
        isEnded_ = false;
    }

    const std::vector<Line>& lines_;
    std::vector<Item> items_;
    Item item_;
    GlslTokens head_; ///< are the tokens of the item so far
    int depth_ = 0;
    int parentheses_ = 0;
    bool hasParenthesis_ = false;
    bool hasBrace_ = false;
    bool bracesFollowParenthesis_ = false; ///< the first braces of the item follow a parenthesis
    bool isEnded_ = false;
};

void markNeeded(std::vector<Item>& items) {
    std::multimap<std::string_view, Item*> byName;
    std::vector<Item*> open;
    for (Item& item : items) {
        if (item.name.empty() || item.name == entryPoint) {
            item.isNeeded = true;
            open.push_back(&item);
        } else {
            byName.emplace(item.name, &item);
        }
    }
    while (!open.empty()) {
        const Item* item = open.back();
        open.pop_back();
        for (const std::string_view word : item->words) {
            const auto [first, last] = byName.equal_range(word);
            for (auto named = first; named != last; ++named) {
                named->second->isNeeded = true;
                open.push_back(named->second);
            }
            byName.erase(first, last); // each item is met once, however often its name is
        }
    }
}

/// Writes lines of text, with `#line` where a number does not follow from the line before.
class LineWriter {
  public:
    void write(const Line& line) {
        const bool isGenerated = line.file == 0; // its lines are those of the text itself
        if (line.file != file_ || (!isGenerated && line.number != number_)) {
            ++written_;
            text_ += fmt::format("{}{} {}\n", lineWord, isGenerated ? written_ + 1 : line.number,
                                 line.file);
        }
        ++written_;
        text_ += line.text;
        text_ += '\n';
        file_ = line.file;
        number_ = line.number + 1;
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
    int written_ = 0;
    std::size_t file_ = 0;
    int number_ = 1; ///< is the number of the file's next line
};

} // namespace

ShaderSource withoutUnused(ShaderSource source) {
    const GlslTokens tokens = glslTokens(source.text);
    const std::vector<Line> lines = linesOf(source.text, tokens);
    std::optional<std::vector<Item>> items = ItemReader(lines).read();
    const auto isMain = [](const Item& item) { return item.name == entryPoint; };
    if (!items || std::ranges::none_of(*items, isMain)) {
        return source;
    }
    markNeeded(*items);
    LineWriter writer;
    for (const Item& item : *items) {
        for (std::size_t i = item.first; item.isNeeded && i <= item.last; ++i) {
            writer.write(lines[i]);
        }
    }
    source.text = writer.take();
    return source;
}

} // namespace patina
