// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

constexpr int entriesOfLine = 256;
constexpr int entriesOfPlane = 128; ///< along each axis

/// Says how the entries of a table are spread over a range of a number.
enum class TableSpread {
    Even,
    Low,   ///< they lie closer where the number is small, as its squares do
    High,  ///< they lie closer where it is large
    Faster ///< they lie closer and closer where it is small
};

/// Is an axis of a table: a number of the shader, 0 .. 1 between the ends of the range that occurs.
struct TableAxis {
    std::string variable; ///< is its text
    double low = 0.0;
    double high = 1.0;
    TableSpread spread = TableSpread::Even;

    /// Returns the axis of a number, widened where its range nearly is one that has a name: what is
    /// missing was not drawn.
    static TableAxis of(std::string variable, double low, double high);

    bool isUsable() const;
    double span() const { return high - low; }
    /// Is where half of the entries of TableSpread::Faster lie below.
    double knee() const { return span() / 16.0; }

    /// Returns the place on the axis, as an expression.
    std::string place() const;

    /// Returns the number at a place `u`, as an expression.
    std::string number(const std::string& u) const;

    /// Says how entries lie, as "closer where it is small"; empty for those that lie evenly.
    std::string_view words() const;

  private:
    std::string scaled(const std::string& part) const;
};

} // namespace patina
