// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "reference/reference.h"

namespace patina {

/// Calls a function of the shader library in double precision; it must be there, with so many
/// numbers as arguments and as results.
template <std::size_t Results, std::size_t Arguments>
std::array<double, Results> libraryCall(std::string_view name,
                                        const std::array<double, Arguments>& arguments) {
    std::array<double, Results> results{};
    reference::findFunction(name)->call(arguments.data(), results.data());
    return results;
}

} // namespace patina
