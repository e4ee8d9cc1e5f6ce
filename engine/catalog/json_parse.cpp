// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_text.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "catalog/json_reader.h"
#include "core/ordinary_file.h"

namespace patina {
namespace {

using Json = nlohmann::json;
using Place = LocatedJson::Place;

/// Limits the elements of an array that have a place of their own. Those past this index share the
/// place of the array, so that a file full of numbers does not cost a hundred times its size in
/// memory.
constexpr std::size_t placedElements = 4096;

/// Iterates over text and counts the bytes that the parser has read.
class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}

    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        ++*count_;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
        return a.at_ == b.at_;
    }

  private:
    const char* at_;
    std::size_t* count_;
};

/// Returns the line and column of a byte, from 1.
Place placeOf(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
            1 + static_cast<int>(before.size() - lineStart)};
}

/// Returns the part of `text` between two marks; the end of the text replaces a missing second
/// mark.
std::string between(const std::string& text, std::string_view first, std::string_view second) {
    const std::size_t start = text.find(first);
    if (start == std::string::npos) {
        return {};
    }
    const std::size_t from = start + first.size();
    return text.substr(from, text.find(second, from) - from);
}

/// Builds the document from the parser's events and notes where each value starts.
class Builder : public nlohmann::json_sax<Json> {
  public:
    Builder(std::string_view text, LocatedJson& document, int depthLimit)
        : text_(text), document_(document), depthLimit_(depthLimit) {}

    std::size_t* count() { return &count_; }
    const Error& failure() const { return failure_; }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(std::int64_t value) override { return add(value); }
    bool number_unsigned(std::uint64_t value) override { return add(value); }
    bool number_float(double value, const std::string&) override { return add(value); }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(Json::binary_t&) override { return false; }

    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        const std::size_t start = tokenStart();
        Level& level = levels_.back();
        if (level.container->contains(name)) {
            return fail(start, fmt::format("the key \"{}\" occurs twice", name),
                        "each key once in an object");
        }
        level.key = name;
        return true;
    }

    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& error) override {
        const std::string what = error.what();
        if (what.find("number overflow") != std::string::npos) {
            return fail(wordStart(position),
                        fmt::format("the number {} is not finite", wordAt(position)),
                        "a finite number");
        }
        std::string problem = between(what, " - ", ";");
        if (problem.find("invalid literal") != std::string::npos) {
            return fail(wordStart(position),
                        fmt::format("'{}' is not a JSON value", wordAt(position)),
                        "an object, an array, a number, text, true, false or null");
        }
        const bool inText = problem.find("invalid string") != std::string::npos;
        return fail(wordStart(position), problem.empty() ? "not valid JSON" : problem,
                    inText ? "text in UTF-8" : between(what, "; expected ", ";"));
    }

  private:
    struct Level {
        Json* container;
        std::string pointer;
        std::string key;
    };

    static bool isWord(char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
    }

    /// Returns where the word at the end of the bytes read starts. `position` counts those bytes,
    /// the offending one included.
    std::size_t wordStart(std::size_t position) const {
        std::size_t start = std::min(position == 0 ? 0 : position - 1, text_.size());
        while (start > 0 && start < text_.size() && isWord(text_[start]) &&
               isWord(text_[start - 1])) {
            --start;
        }
        return start;
    }

    std::string wordAt(std::size_t position) const {
        std::size_t end = wordStart(position);
        const std::size_t start = end;
        while (end < text_.size() && end < start + 24 && isWord(text_[end])) {
            ++end;
        }
        return std::string(text_.substr(start, std::max<std::size_t>(end - start, 1)));
    }

    bool fail(std::size_t offset, std::string problem, std::string expected) {
        const Place place = placeOf(text_, offset);
        failure_ = {document_.file, place.line, place.column, std::move(problem),
                    std::move(expected)};
        return false;
    }

    /// Returns where the token of an event starts: at the first byte after the event before it that
    /// is neither blank nor a separator. The parser may have read one byte past a number, and that
    /// byte is blank, a separator or a bracket that has no place of its own.
    std::size_t tokenStart() {
        const std::size_t start = text_.find_first_not_of(" \t\r\n,:", eventEnd_);
        eventEnd_ = count_;
        return start == std::string_view::npos ? text_.size() : start;
    }

    /// Returns the line and column of a byte. Lines are counted forwards, each byte once.
    Place placeAt(std::size_t offset) {
        for (; counted_ < offset; ++counted_) {
            if (text_[counted_] == '\n') {
                ++line_;
                lineStart_ = counted_ + 1;
            }
        }
        return {line_, 1 + static_cast<int>(offset - lineStart_)};
    }

    std::string nextPointer() const {
        if (levels_.empty()) {
            return {};
        }
        const Level& level = levels_.back();
        if (level.container->is_object()) {
            return level.pointer + '/' + escapedToken(level.key);
        }
        return fmt::format("{}/{}", level.pointer, level.container->size());
    }

    bool isPlaced() const {
        return levels_.empty() || levels_.back().container->is_object() ||
               levels_.back().container->size() < placedElements;
    }

    Json* place(Json value) {
        const Place at = placeAt(tokenStart());
        if (isPlaced()) {
            document_.places.emplace(nextPointer(), at);
        }
        if (levels_.empty()) {
            document_.value = std::move(value);
            return &document_.value;
        }
        Json& container = *levels_.back().container;
        if (container.is_object()) {
            return &(container[levels_.back().key] = std::move(value));
        }
        container.push_back(std::move(value));
        return &container.back();
    }

    bool add(Json value) {
        place(std::move(value));
        return true;
    }

    bool open(Json container) {
        if (static_cast<int>(levels_.size()) >= depthLimit_) {
            return fail(tokenStart(), "nested too deeply",
                        fmt::format("at most {} levels", depthLimit_));
        }
        std::string pointer = nextPointer();
        Json* placed = place(std::move(container));
        levels_.push_back({placed, std::move(pointer), {}});
        return true;
    }

    bool close() {
        tokenStart();
        levels_.pop_back();
        return true;
    }

    std::string_view text_;
    LocatedJson& document_;
    int depthLimit_;
    std::size_t count_ = 0;
    std::size_t eventEnd_ = 0;
    std::size_t counted_ = 0;
    std::size_t lineStart_ = 0;
    int line_ = 1;
    std::vector<Level> levels_;
    Error failure_;
};

Error tooLarge(std::string file, std::size_t limit) {
    return {std::move(file), 0, 0, "the file is too large", fmt::format("at most {} bytes", limit)};
}

} // namespace

Error LocatedJson::error(const std::string& pointer, std::string problem,
                         std::string expected) const {
    std::string nearest = pointer;
    auto place = places.find(nearest);
    while (place == places.end() && !nearest.empty()) {
        nearest.resize(nearest.rfind('/'));
        place = places.find(nearest);
    }
    const Place at = place == places.end() ? Place{} : place->second;
    return {file, at.line, at.column, std::move(problem), std::move(expected)};
}

Result<LocatedJson> parseJson(std::string_view text, std::string file, const JsonLimits& limits) {
    if (text.size() > limits.bytes) {
        return tl::unexpected(tooLarge(std::move(file), limits.bytes));
    }
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.substr(0, 3) == byteOrderMark) {
        text.remove_prefix(3);
    }
    // The parser would take a zero byte for the end of the text.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        const Place place = placeOf(text, zero);
        return tl::unexpected(Error{std::move(file), place.line, place.column,
                                    "a zero byte stands here", "a text file"});
    }
    LocatedJson document;
    document.file = std::move(file);
    Builder builder(text, document, limits.depth);
    const CountingIterator first(text.data(), builder.count());
    const CountingIterator last(text.data() + text.size(), builder.count());
    if (!Json::sax_parse(first, last, &builder)) {
        return tl::unexpected(builder.failure());
    }
    return document;
}

Result<LocatedJson> readJson(const std::filesystem::path& path, const JsonLimits& limits) {
    constexpr auto anySize = std::numeric_limits<std::uintmax_t>::max(); // the parser has the limit
    return OrdinaryFile::open(path, anySize)
        .and_then([&](const OrdinaryFile& file) { return file.start(limits.bytes + 1); })
        .map_error([](Error error) {
            error.problem.insert(0, error.problem.starts_with("is ") ? "this " : "");
            return error;
        })
        .and_then([&](const std::string& text) { return parseJson(text, path.string(), limits); });
}

} // namespace patina
