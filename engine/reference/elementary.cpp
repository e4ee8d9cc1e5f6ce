// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

namespace patina::reference {
namespace {

/// Returns w / 3 + w^2 / 5 + ..., which is atanh(z) / z - 1 from w = z^2 <= 1/9: the first term
/// that is left out is below 2e-19. The C++ library's atanh takes four times as long.
double atanhSeries(double w) {
    constexpr std::array<double, 17> coefficients = [] {
        std::array<double, 17> each{};
        for (std::size_t k = 0; k < each.size(); ++k) {
            each[k] = 1.0 / double(2 * k + 3);
        }
        return each;
    }();
    double sum = 0.0;
    for (std::size_t k = coefficients.size(); k > 0; --k) {
        sum = w * (coefficients[k - 1] + sum);
    }
    return sum;
}

constexpr double largestOfSeries = 1.0 / 9.0;

constexpr double rightAngles = 2.0 / std::numbers::pi; ///< right angles per radian

} // namespace

double atanhOverZ(double w) {
    if (w <= largestOfSeries) {
        return 1.0 + atanhSeries(w);
    }
    const double z = std::sqrt(w);
    return z > 0.0 ? std::atanh(z) / z : 1.0;
}

// ln cos = -ln(1 + tan^2) / 2; the bound keeps e = 0 from meeting an infinite logarithm.
double powSC(double s2, double c2, double e) {
    constexpr double largest = std::numeric_limits<double>::max();
    return c2 > 0.0 ? std::exp(-0.5 * e * std::log1p(std::min(s2 / c2, largest))) : 0.0;
}

// The small one of d and c has the exact digits.
double pow1m(double d, double c, double e) {
    if (!(c > 0.0)) {
        return 0.0;
    }
    return std::exp(e * (c > 0.5 ? std::log1p(-d) : std::log(c)));
}

double minusLnCosBySin2(double s2, double c2) {
    const double tan2 = std::min(s2 / c2, std::numeric_limits<double>::max());
    return tan2 > 0.0 ? 0.5 * std::log1p(tan2) / s2 : 0.5 / c2;
}

double powNear1(double d, double c, double e) {
    if (!(c > 0.0)) {
        return 0.0;
    }
    const double ln = std::abs(d) < 0.5 ? std::log1p(-d) : std::log(c);
    return std::exp2(std::min(e * ln / std::numbers::ln2, 100.0));
}

// 1 - cos(a) = x / 2, so sin(a / 2)^2 = x / 4.
double acos2(double x) {
    const double angle = 2.0 * std::asin(0.5 * std::sqrt(x));
    return angle * angle;
}

double asinS(double z) {
    return std::asin(z);
}

double versineOf(double a) {
    const double half = std::sin(0.5 * a);
    return 2.0 * half * half;
}

double ierfc(double a) {
    return std::exp(-a * a) * std::numbers::inv_sqrtpi - a * std::erfc(a);
}

// The integral is over u = theta / sqrt(w) and ends at 7, where e^(-u^2) is below a double's
// rounding.
double gaussianShare(double w) {
    const double m = std::sqrt(w);
    const auto integrand = [m](double u) { return std::exp(-u * u) * std::sin(2.0 * m * u) / m; };
    const double end = std::min(0.5 * std::numbers::pi / m, 7.0);
    return boost::math::quadrature::gauss<double, 30>::integrate(integrand, 0.0, end);
}

double angleOf(double s, double c) {
    return std::atan2(s, c);
}

// Four panels of a rule that is exact to rounding for each. The integral ends at 9 standard
// deviations, where the lobe has fallen by e^(-40).
double ridgeLobe(const glm::dvec2& arc, const glm::dvec3& h, double e, const glm::dvec2& view,
                 const glm::dvec2& light) {
    const double largest = std::max(arc.x, std::min(h.x, arc.y));
    const double off = std::abs(largest - h.x);
    const double reach2 = 81.0 / (e + 1.0);
    const double reach = reach2 / (std::sqrt(off * off + reach2) + off);
    const double from = std::max(arc.x, largest - reach);
    const double to = std::min(arc.y, largest + reach);
    const auto integrand = [&](double psi) {
        const double s = std::sin(psi - h.x);
        const double c = std::cos(psi - h.x);
        const double lobe = c > 0.0 ? powSC(h.y + h.z * s * s, h.z * c * c, e) : 0.0;
        return lobe * std::sin(view.x + view.y * psi) * std::sin(light.x + light.y * psi);
    };
    constexpr int panels = 4;
    double sum = 0.0;
    for (int i = 0; to > from && i < panels; ++i) {
        const double a = from + (to - from) * i / panels;
        const double b = from + (to - from) * (i + 1) / panels;
        sum += boost::math::quadrature::gauss<double, 30>::integrate(integrand, a, b);
    }
    return std::max(sum, 0.0);
}

void angXY(double c, double s2, double& x, double& y) {
    const double s = std::sqrt(s2);
    x = rightAngles * std::atan2(s, c);
    y = rightAngles * std::atan2(c, s);
}

double atanhExcess(double w) {
    return w <= largestOfSeries ? atanhSeries(w) : atanhOverZ(w) - 1.0;
}

double erfcOf(double a) {
    return std::erfc(a);
}

double meanOfExp(double u) {
    return u > 0.0 ? -std::expm1(-u) / u : 1.0;
}

// Newton's iteration starts as in the shader, and after 8 steps nothing changes.
double lambertW(double x) {
    const double L = std::log(std::max(x, 2.72));
    double w = x < 2.72 ? x / (1.0 + x) : L - std::log(L);
    for (int i = 0; i < 8; ++i) {
        w -= (w - x * std::exp(-w)) / (w + 1.0);
    }
    return w;
}

// The gamma function is exact enough below 16, where the series begins to be.
double stirlingError(double m) {
    if (m < 16.0) {
        constexpr double halfLog2Pi = 0.91893853320467274178;
        return std::lgamma(m + 1.0) - ((m + 0.5) * std::log(m) - m + halfLog2Pi);
    }
    const double w = 1.0 / (m * m);
    return (1.0 / 12.0 +
            w * (-1.0 / 360.0 + w * (1.0 / 1260.0 + w * (-1.0 / 1680.0 + w / 1188.0)))) /
           m;
}

} // namespace patina::reference
