// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

namespace patina {

std::string Error::text() const {
    std::string out = file;
    if (line > 0) {
        out += fmt::format("{}{}:{}", out.empty() ? "" : ":", line, column);
    }
    if (!out.empty()) {
        out += ": ";
    }
    out += problem;
    if (!expected.empty()) {
        out += "; expected " + expected;
    }
    return out;
}

void sortByPlace(Errors& errors) {
    std::stable_sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
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
