// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/adaptive_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/common.hpp>

namespace patina {
namespace {

/// Is a node of the rule of 15 at +-x, and where `gauss` is not 0 of the rule of 7 among them.
struct KronrodNode {
    double x = 0.0;
    double kronrod = 0.0;
    double gauss = 0.0;
};

/// Holds the nodes of QUADPACK's qk15 from the outside in.
constexpr std::array<KronrodNode, 8> kronrodNodes{
    {{0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0},
     {0.949107912342758524526189684047851, 0.063092092629978553290700663189204,
      0.129484966168869693270611432679082},
     {0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0},
     {0.741531185599394439863864773280788, 0.140653259715525918745189590510238,
      0.279705391489276667901467771423780},
     {0.586087235467691130294144691693013, 0.169004726639267902826583426598550, 0.0},
     {0.405845151377397166906606412076961, 0.190350578064785409913256402421014,
      0.381830050505118944950369775488975},
     {0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0},
     {0.0, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327}}};

struct KronrodPanel {
    double begin = 0.0;
    double end = 0.0;
    Integral integral;

    double uncertainty() const { return integral.uncertainty; }
};

/// Returns QUADPACK's errorEstimate of an error from the difference of both rules and the integral
/// of how far the function is from its mean.
double errorEstimate(double difference, double spread) {
    if (!(spread > 0.0) || !(difference > 0.0)) {
        return 0.0;
    }
    return spread * std::min(1.0, std::pow(200.0 * difference / spread, 1.5));
}

KronrodPanel kronrodPanel(const std::function<glm::dvec3(double)>& integrand, double begin,
                          double end) {
    const double half = 0.5 * (end - begin);
    const double middle = 0.5 * (begin + end);
    std::array<glm::dvec3, 15> values;
    glm::dvec3 kronrod(0.0);
    glm::dvec3 gauss(0.0);
    for (std::size_t i = 0; i < kronrodNodes.size(); ++i) {
        const KronrodNode& node = kronrodNodes[i];
        values[2 * i] = integrand(middle + half * node.x);
        glm::dvec3 sum = values[2 * i];
        if (node.x > 0.0) {
            values[2 * i + 1] = integrand(middle - half * node.x);
            sum += values[2 * i + 1];
        }
        kronrod += node.kronrod * sum;
        gauss += node.gauss * sum;
    }
    const glm::dvec3 mean = 0.5 * kronrod;
    glm::dvec3 spread(0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        spread += kronrodNodes[i / 2].kronrod * glm::abs(values[i] - mean);
    }
    KronrodPanel panel{begin, end, {half * kronrod, 0.0}};
    const glm::dvec3 difference = half * glm::abs(kronrod - gauss);
    for (int channel = 0; channel < 3; ++channel) {
        panel.integral.uncertainty = std::max(
            panel.integral.uncertainty, errorEstimate(difference[channel], half * spread[channel]));
    }
    return panel;
}

/// Integrates over each panel by the Gauss rule of 5 nodes (Abramowitz and Stegun 25.4.29).
Integral sketchedIntegral(const std::function<glm::dvec3(double)>& integrand,
                          std::span<const double> ends) {
    constexpr std::array<std::pair<double, double>, 5> gauss{
        {{-0.906179845938664, 0.236926885056189},
         {-0.538469310105683, 0.478628670499366},
         {0.0, 0.568888888888889},
         {0.538469310105683, 0.478628670499366},
         {0.906179845938664, 0.236926885056189}}};
    Integral whole;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double half = 0.5 * (ends[i] - ends[i - 1]);
        if (half > 0.0) {
            for (const auto& [x, weight] : gauss) {
                whole.value += half * weight * integrand(ends[i - 1] + half * (1.0 + x));
            }
        }
    }
    return whole;
}

} // namespace

Integral adaptiveIntegral(const std::function<glm::dvec3(double)>& integrand,
                          std::span<const double> ends, const IntegralAim& aim) {
    if (aim.isSketch) {
        return sketchedIntegral(integrand, ends);
    }
    std::vector<KronrodPanel> panels;
    double uncertainty = 0.0;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        if (ends[i] > ends[i - 1]) {
            panels.push_back(kronrodPanel(integrand, ends[i - 1], ends[i]));
            uncertainty += panels.back().integral.uncertainty;
        }
    }
    std::ranges::make_heap(panels, {}, &KronrodPanel::uncertainty);
    while (uncertainty > aim.tolerance && panels.size() < aim.panels) {
        std::ranges::pop_heap(panels, {}, &KronrodPanel::uncertainty);
        const KronrodPanel worst = panels.back();
        panels.pop_back();
        const double middle = 0.5 * (worst.begin + worst.end);
        uncertainty -= worst.integral.uncertainty;
        for (const KronrodPanel& part : {kronrodPanel(integrand, worst.begin, middle),
                                         kronrodPanel(integrand, middle, worst.end)}) {
            uncertainty += part.integral.uncertainty;
            panels.push_back(part);
            std::ranges::push_heap(panels, {}, &KronrodPanel::uncertainty);
        }
    }
    Integral whole;
    for (const KronrodPanel& panel : panels) {
        whole.value += panel.integral.value;
        whole.uncertainty += panel.integral.uncertainty;
    }
    return whole;
}

} // namespace patina
