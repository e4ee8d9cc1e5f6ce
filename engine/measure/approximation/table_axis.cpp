// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/table_axis.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "measure/approximation/shader_edit.h"

namespace patina {

TableAxis TableAxis::of(std::string variable, double low, double high) {
    constexpr double slack = 1e-3;
    TableAxis axis{std::move(variable), low, high};
    if (low >= -slack && high <= 1.0 + slack && high > 0.5 && low < 0.5) {
        axis.low = 0.0;
        axis.high = 1.0;
    } else if (low >= -1.0 - slack && high <= 1.0 + slack && axis.span() > 1.0) {
        axis.low = -1.0;
        axis.high = 1.0;
    } else if (low > 0.0 && low < 0.2 * high) {
        axis.low = 0.0;
    }
    return axis;
}

bool TableAxis::isUsable() const {
    return std::isfinite(low) && std::isfinite(high) && span() > 1e-6 && span() < 1e12;
}

std::string TableAxis::place() const {
    const std::string from =
        low == 0.0 ? variable : fmt::format("({} - {})", variable, floatText(low));
    switch (spread) {
    case TableSpread::Low:
        return fmt::format("sqrt(clamp({}, 0.0, 1.0))", scaled(from));
    case TableSpread::High:
        return fmt::format("1.0 - sqrt(clamp({}, 0.0, 1.0))",
                           scaled(fmt::format("({} - {})", floatText(high), variable)));
    case TableSpread::Faster:
        return fmt::format("{} * {} / max({} + {}, {})", floatText(1.0 + knee() / span()), from,
                           from, floatText(knee()), floatText(knee()));
    default:
        return scaled(from);
    }
}

std::string TableAxis::number(const std::string& u) const {
    const std::string begin = low == 0.0 ? std::string() : floatText(low) + " + ";
    switch (spread) {
    case TableSpread::Low:
        return fmt::format("{}{} * {} * {}", begin, floatText(span()), u, u);
    case TableSpread::High:
        return fmt::format("{} - {} * (1.0 - {}) * (1.0 - {})", floatText(high), floatText(span()),
                           u, u);
    case TableSpread::Faster:
        return fmt::format("{}{} * {} / ({} - {})", begin, floatText(knee()), u,
                           floatText(1.0 + knee() / span()), u);
    default:
        return fmt::format("{}{} * {}", begin, floatText(span()), u);
    }
}

std::string_view TableAxis::words() const {
    switch (spread) {
    case TableSpread::Low:
        return ", closer where it is small";
    case TableSpread::High:
        return ", closer where it is large";
    case TableSpread::Faster:
        return ", much closer where it is small";
    default:
        return "";
    }
}

std::string TableAxis::scaled(const std::string& part) const {
    return span() == 1.0 ? part : fmt::format("{} * {}", floatText(1.0 / span()), part);
}

} // namespace patina
