// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/unused_code.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace patina {
namespace {

constexpr std::string_view lineWord = "#line ";
constexpr std::string_view entryPoint = "main";

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// A line and where it says it comes from.
struct Line {
    std::string_view text;
    int number = 0; ///< as a compiler counts it
    std::size_t file = 0;
};

/// What stands for itself at the top of a shader: a function, a declaration, a macro.
struct Item {
    std::size_t first = 0; ///< of its lines
    std::size_t last = 0;
    std::string_view name; ///< empty: it is always needed
    std::vector<std::string_view> words;
    bool isNeeded = false;
};

std::vector<Line> linesOf(const ShaderSource& source) {
    std::vector<Line> lines;
    std::string_view rest = source.text;
    Line next{{}, 1, 0};
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        next.text = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
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

void addWords(std::string_view line, std::vector<std::string_view>& words) {
    for (std::size_t i = 0; i < line.size();) {
        std::size_t end = i;
        while (end < line.size() && (isLetter(line[end]) || isDigit(line[end]))) {
            ++end;
        }
        if (end > i && isLetter(line[i])) {
            words.push_back(line.substr(i, end - i));
        }
        i = std::max(end, i + 1);
    }
}

/// The word before a place.
std::string_view wordBefore(std::string_view text, std::size_t place) {
    std::size_t end = place;
    while (end > 0 && !isLetter(text[end - 1]) && !isDigit(text[end - 1])) {
        --end;
    }
    std::size_t begin = end;
    while (begin > 0 && (isLetter(text[begin - 1]) || isDigit(text[begin - 1]))) {
        --begin;
    }
    return text.substr(begin, end - begin);
}

/// What a declaration or definition declares; empty where it is more than a name for what follows.
std::string_view nameOf(std::string_view text) {
    std::vector<std::string_view> words;
    addWords(text.substr(0, text.find_first_of("({=;")), words);
    if (words.size() < 2) {
        return {};
    }
    if (text.starts_with('#')) {
        return words[0] == "define" || words[0] == "undef" ? words[1] : std::string_view();
    }
    if (words[0] == "struct") {
        return words[1];
    }
    const std::size_t end = text.find_first_of("(={;[");
    if (words[0] == "const") {
        return end != std::string_view::npos ? wordBefore(text, end) : std::string_view();
    }
    const bool isFunction = end != std::string_view::npos && text[end] == '(';
    const bool isInterface = words[0] == "layout" || words[0] == "uniform" || words[0] == "in" ||
                             words[0] == "out" || words[0] == "flat" || words[0] == "precision";
    return isFunction && !isInterface ? wordBefore(text, end) : std::string_view();
}

/// Cuts the text into items; nothing where its brackets do not match.
class ItemReader {
  public:
    explicit ItemReader(const std::vector<Line>& lines) : lines_(lines) {}

    std::optional<std::vector<Item>> read() {
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::string_view line = lines_[i].text;
            item_.last = i;
            addWords(line, item_.words);
            head_ += line;
            head_ += ' ';
            if (depth_ == 0 && parentheses_ == 0 && item_.first == i && line.starts_with('#')) {
                finish(i);
            } else if (!follow(line)) {
                return std::nullopt;
            } else if (isEnded_) {
                finish(i);
            }
        }
        return depth_ == 0 && item_.first == lines_.size() ? std::optional(std::move(items_))
                                                           : std::nullopt;
    }

  private:
    bool follow(std::string_view line) {
        for (const char c : line) {
            hasParenthesis_ = hasParenthesis_ || c == '(';
            if (c == '{' && !hasBrace_) {
                hasBrace_ = true;
                bracesFollowParenthesis_ = hasParenthesis_;
            }
            depth_ += c == '{' ? 1 : c == '}' ? -1 : 0;
            parentheses_ += c == '(' ? 1 : c == ')' ? -1 : 0;
            if (c != ' ') {
                // A function ends with its brace; what else has braces goes on to a semicolon.
                const bool isBody = c == '}' && depth_ == 0 && isFunction();
                isEnded_ = depth_ == 0 && parentheses_ == 0 && (c == ';' || isBody);
            }
        }
        return depth_ >= 0 && parentheses_ >= 0;
    }

    bool isFunction() const {
        return bracesFollowParenthesis_ && !head_.starts_with("layout") &&
               !head_.starts_with("uniform") && !head_.starts_with("const");
    }

    void finish(std::size_t line) {
        const std::string_view name = nameOf(head_);
        // The name as it stands in the source, which outlives the head.
        const auto kept = std::find(item_.words.begin(), item_.words.end(), name);
        item_.name = name.empty() || kept == item_.words.end() ? std::string_view() : *kept;
        items_.push_back(std::move(item_));
        item_ = Item();
        item_.first = line + 1;
        head_.clear();
        hasParenthesis_ = false;
        hasBrace_ = false;
        bracesFollowParenthesis_ = false;
        isEnded_ = false;
    }

    const std::vector<Line>& lines_;
    std::vector<Item> items_;
    Item item_;
    std::string head_; ///< its text so far
    int depth_ = 0;
    int parentheses_ = 0;
    bool hasParenthesis_ = false;
    bool hasBrace_ = false;
    bool bracesFollowParenthesis_ = false; ///< the head's first ones
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

/// Lines of text, each with its own number.
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
    int number_ = 1; ///< of the next line of a file
};

} // namespace

ShaderSource withoutUnused(ShaderSource source) {
    const std::vector<Line> lines = linesOf(source);
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
