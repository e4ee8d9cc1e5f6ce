// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj_commas.h"

#include <algorithm>
#include <cstddef>

namespace patina {
namespace {

constexpr std::string_view lineBlanks = " \t\r";

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Finds a comma inside a number: "1," separates a number from the next, but "1,5" may or may not.
std::size_t innerComma(std::string_view word) {
    std::size_t at = word.find(',');
    while (at != std::string_view::npos && (at + 1 == word.size() || !isDigit(word[at + 1]))) {
        at = word.find(',', at + 1);
    }
    return at;
}

/// Goes through the coordinates of a file and remembers the commas and points in their numbers.
class Commas {
  public:
    std::optional<Error> find(std::string_view text) {
        for (int line = 1; !text.empty() && !unclear_; ++line) {
            const std::size_t length = std::min(text.find('\n'), text.size());
            lookAt(text.substr(0, length), line);
            text.remove_prefix(std::min(length + 1, text.size()));
        }
        return unclear_ ? unclear_ : hasPoint_ ? firstComma_ : std::nullopt;
    }

  private:
    void lookAt(std::string_view line, int number) {
        std::size_t at = std::min(line.find_first_not_of(lineBlanks), line.size());
        const std::string_view keyword =
            line.substr(at, std::min(line.find_first_of(lineBlanks, at), line.size()) - at);
        if (keyword != "v" && keyword != "vn" && keyword != "vt") {
            return;
        }
        at += keyword.size();
        while ((at = line.find_first_not_of(lineBlanks, at)) != std::string_view::npos &&
               line[at] != '#') {
            const std::size_t end = std::min(line.find_first_of(lineBlanks, at), line.size());
            take(line.substr(at, end - at), number, static_cast<int>(at) + 1);
            at = end;
        }
    }

    void take(std::string_view word, int line, int column) {
        const bool hasPoint = word.find('.') != std::string_view::npos;
        hasPoint_ = hasPoint_ || hasPoint;
        const std::size_t comma = innerComma(word);
        if (comma == std::string_view::npos) {
            return;
        }
        const Error here{{}, line, column + static_cast<int>(comma),
                         "a comma stands inside a number", "a decimal point"};
        const bool isLast = innerComma(word.substr(comma + 1)) == std::string_view::npos;
        if (!unclear_ && (hasPoint || !isLast)) {
            unclear_ = here;
        }
        firstComma_ = firstComma_ ? firstComma_ : here;
    }

    bool hasPoint_ = false;
    std::optional<Error> firstComma_; ///< is an error only beside decimal points
    std::optional<Error> unclear_;
};

} // namespace

std::optional<Error> unclearComma(std::string_view text) {
    return text.find(',') == std::string_view::npos ? std::nullopt : Commas().find(text);
}

} // namespace patina
