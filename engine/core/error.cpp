// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "core/text.h"

namespace patina {
namespace {

/// Replaces control characters by question marks. Messages quote files that nobody vouches for: a
/// line break would look like another message, and a terminal obeys other control characters.
std::string printable(std::string text) {
    std::ranges::replace_if(text, isControl, '?');
    return text;
}

} // namespace

std::string Error::text() const {
    std::string out = file;
    if (line > 0) {
        out += fmt::format("{}{}", out.empty() ? "" : ":", line);
        out += column > 0 ? fmt::format(":{}", column) : "";
    }
    if (!out.empty()) {
        out += ": ";
    }
    out += problem;
    if (!expected.empty()) {
        out += "; expected " + expected;
    }
    return printable(std::move(out));
}

void sortByPlace(Errors& errors) {
    std::stable_sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
}

void addNew(Errors& errors, const Errors& more) {
    for (const Error& error : more) {
        if (std::find(errors.begin(), errors.end(), error) == errors.end()) {
            errors.push_back(error);
        }
    }
}

std::string text(const Errors& errors) {
    std::string out;
    for (const Error& error : errors) {
        out += error.text() + '\n';
    }
    return out;
}

tl::unexpected<Error> failure(std::string problem, std::string expected) {
    return tl::unexpected(Error{{}, 0, 0, std::move(problem), std::move(expected)});
}

} // namespace patina
