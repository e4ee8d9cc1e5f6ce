// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "declarations.h"

namespace patina {

enum class Language { Cpp, Glsl };

/// Returns the name of a GLSL type in the generated C++.
std::string cppType(const std::string& type);

/// Writes statements that move values between variables and an array of numbers, in order. In C++
/// the arrays are `in` and `out`, in GLSL ARGUMENT and RESULT.
class NumberMover {
  public:
    NumberMover(const Declarations& declarations, Language language)
        : declarations_(declarations), language_(language) {}

    std::string read(const std::string& type, const std::string& place) {
        return move(type, place, true);
    }
    std::string write(const std::string& type, const std::string& place) {
        return move(type, place, false);
    }

  private:
    std::string move(const std::string& type, const std::string& place, bool reading);
    std::string scalar(const std::string& type, const std::string& place, bool reading);

    const Declarations& declarations_;
    Language language_;
    std::size_t cursor_ = 0;
};

} // namespace patina
