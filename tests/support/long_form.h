// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace patina::tests {

/// Tells whether tests run in their long form, which tries more cases of the same kind and takes
/// several times as long: `ninja -C build/dev long-tests`.
inline bool isLongForm() {
    return std::getenv("PATINA_LONG_TESTS") != nullptr;
}

/// Returns how many cases a test tries: the second number in the long form.
template <class Count>
Count casesOf(Count usual, Count inLongForm) {
    return isLongForm() ? inLongForm : usual;
}

/// Returns every n-th element of a list, beginning with the first; all of it in the long form.
template <class Element>
std::vector<Element> everyNth(std::vector<Element> all, std::size_t n) {
    std::vector<Element> some;
    for (std::size_t i = 0; i < all.size(); i += isLongForm() ? 1 : n) {
        some.push_back(all[i]);
    }
    return some;
}

} // namespace patina::tests
