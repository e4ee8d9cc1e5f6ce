// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

namespace patina {

/// Describes one mistake in something a user, a driver or a disk can cause. It is returned, never
/// thrown.
struct Error {
    std::string file;     ///< is the path as the user knows it; empty when no file is involved
    int line = 0;         ///< is 1-based; 0 when the place inside the file is unknown
    int column = 0;       ///< is 1-based, in bytes; 0 when unknown
    std::string problem;  ///< says what is wrong: a sentence without a final stop
    std::string expected; ///< says what would have been right; may be empty

    /// Returns "file:line:column: problem; expected ..." with the unknown parts left out.
    std::string text() const;

    friend bool operator==(const Error&, const Error&) = default;
};

using Errors = std::vector<Error>;

inline Errors oneError(Error error) {
    return {std::move(error)};
}

/// Sorts errors of one file by their place; the order of those at one place stays.
void sortByPlace(Errors& errors);

/// Appends those of `more` that are not in `errors` yet.
void addNew(Errors& errors, const Errors& more);

/// Returns the texts of all errors, one per line.
std::string text(const Errors& errors);

/// Holds a value, or the one reason why there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// Holds a value, or every reason why there is none.
template <class T>
using Checked = tl::expected<T, Errors>;

/// Is short for `tl::unexpected(Error{...})` without a place in a file.
tl::unexpected<Error> failure(std::string problem, std::string expected = {});

} // namespace patina
