// SPDX-License-Identifier: GPL-3.0-or-later
// What the shader loses against double precision where nothing is an edge case.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

#include <gtest/gtest.h>

#include "measure/eval/eval_gpu.h"
#include "measure/eval/reference_case.h"
#include "measure/stability/edge_case_directions.h"
#include "measure/stability/sweep_cases.h"
#include "stability_cases.h"
#include "support/long_form.h"

namespace patina::stability::ordinary_error_test {
namespace {

using Json = nlohmann::json;

constexpr std::size_t placesPerRow = 250;
constexpr double smallestJudged = 1e-6;

const Json& bounds() {
    static const Json read = [] {
        std::ifstream stream(std::filesystem::path(PATINA_SOURCE_DIR) /
                             "tests/stability/data/ordinary_error.json");
        return Json::parse(stream);
    }();
    return read;
}

bool lists(const char* list, const std::string& id) {
    const Json& ids = bounds().at(list);
    return std::find(ids.begin(), ids.end(), Json(id)) != ids.end();
}

bool hasLevel(const EvalBlock& block, const Json& level) {
    const auto chosen = block.accuracy.find(level[0].get<std::string>());
    return chosen != block.accuracy.end() && chosen->second == level[1].get<std::string>();
}

/// Whether the block computes its lobe at a level that takes cosines as they are rounded.
bool isRounded(const EvalBlock& block) {
    return std::ranges::any_of(bounds().at("rounded"),
                               [&block](const Json& level) { return hasLevel(block, level); });
}

/// What the place adds to the bound at which a table with steep entries is read.
double growthOfEntries(const EvalBlock& block) {
    double growth = 0.0;
    for (const Json& level : bounds().at("entries")) {
        growth = std::max(growth,
                          hasLevel(block, level) ? std::ldexp(level[2].get<double>(), -25) : 0.0);
    }
    return growth;
}

/// What the place in a pattern adds to the bound.
double growthOfPatterns(const EvalBlock& block) {
    double growth = 0.0;
    for (const Json& pattern : bounds().at("patterns")) {
        const auto width = block.values.find(pattern[0].get<std::string>());
        const auto place = block.values.find(pattern[1].get<std::string>());
        if (width != block.values.end() && place != block.values.end()) {
            const auto& coordinates = std::get<glm::dvec2>(place->second);
            const double across = std::max(std::abs(coordinates.x), std::abs(coordinates.y)) /
                                  std::max(std::get<double>(width->second), 1e-30);
            growth = std::max(growth, 3.0 * std::ldexp(std::min(across, 1e6), -23));
        }
    }
    return growth;
}

/// What a power of this exponent adds to the bound.
double growthOfPower(double exponent, bool rounded) {
    return std::max(3e-7 * std::sqrt(exponent), rounded ? 1e-7 * exponent : 0.0);
}

/// What the sharpest lobe of a set of values adds to the bound.
double growthOf(const EvalBlock& block, bool diffuse) {
    const bool rounded = isRounded(block);
    double growth = std::max(growthOfEntries(block), growthOfPatterns(block));
    for (const auto& [id, value] : block.values) {
        if (const auto* each = std::get_if<glm::dvec3>(&value); each && lists("exponents", id)) {
            const double largest = std::max({each->x, each->y, each->z});
            growth = std::max(growth, rounded ? growthOfPower(largest, true) : 0.0);
        }
        const auto* x = std::get_if<double>(&value);
        if (x == nullptr) {
            continue;
        }
        if (lists("exponents", id)) {
            growth = std::max(growth, growthOfPower(*x, rounded));
        }
        if (lists("smoothnesses", id)) {
            const double exponent = 3.0 / std::max(1.0 - *x, 1e-30);
            growth = std::max(growth, growthOfPower(exponent, rounded));
        }
        if (lists("widths", id) && !diffuse) {
            growth = std::max(growth, 5e-7 / std::max(*x, 1e-4));
        }
    }
    for (const Json& pair : bounds().at("slopes")) {
        const auto height = block.values.find(pair[0].get<std::string>());
        const auto length = block.values.find(pair[1].get<std::string>());
        if (height != block.values.end() && length != block.values.end()) {
            const double width =
                2.0 * std::get<double>(height->second) / std::get<double>(length->second);
            growth = std::max(growth, 5e-7 / std::max(width, 1e-4));
        }
    }
    return growth;
}

/// Whether the block makes a choice whose formula is a difference; a third word names the number
/// that makes it one where it is below 0.
bool isDifference(const EvalBlock& block, const Json& choice) {
    const auto form = block.values.find(choice[0].get<std::string>());
    if (form == block.values.end() || form->second != Value(choice[1].get<std::string>())) {
        return false;
    }
    return choice.size() < 3 ||
           std::get<double>(block.values.at(choice[2].get<std::string>())) < 0.0;
}

/// What an error is judged against where the value is smaller.
double smallestOf(const EvalBlock& block) {
    double smallest = smallestJudged;
    for (const Json& choice : bounds().at("differences")) {
        if (isDifference(block, choice)) {
            const auto& color = std::get<glm::dvec3>(block.values.at("diffuse.color"));
            smallest = std::max(smallest, 0.1 * std::max({color.x, color.y, color.z}));
        }
    }
    return smallest;
}

/// The bound of the relative error. A matte model with a highlight in its slot has a lobe.
double boundOf(const EvalCase& request) {
    const bool diffuse = lists("diffuse", request.block.block->id);
    const bool highlight = request.slot.block != nullptr && request.slot.block->kind == "specular";
    const double growth =
        std::max(growthOf(request.block, diffuse), highlight ? growthOf(request.slot, false) : 0.0);
    return diffuse && !highlight && growth == 0.0 ? 1.5e-6 : 3e-6 + growth;
}

std::vector<EvalCase> ordinaryCases(const EvalCase& variant, std::size_t rows) {
    const auto places = ordinaryPlaces(variant.subject, rows * placesPerRow);
    std::vector<EvalCase> cases;
    for (const EvalCase& row : ordinaryRows(variant, rows)) {
        for (std::size_t i = 0; i < placesPerRow; ++i) {
            EvalCase& next = cases.emplace_back(row);
            static_cast<EvalPlace&>(next) = places[cases.size() - 1];
        }
    }
    return cases;
}

std::vector<double> inFloat(const EvalBlock& block) {
    std::vector<double> values =
        block.block == nullptr ? std::vector<double>() : block.packedValues();
    std::transform(values.begin(), values.end(), values.begin(),
                   [](double x) { return static_cast<double>(static_cast<float>(x)); });
    return values;
}

/// The errors of all channels over their bounds; the cases are whole rows.
std::vector<double> shares(const std::vector<EvalCase>& cases, EvalGpu& gpu) {
    const auto answers = gpu.evaluate(cases, catalog());
    const auto code = ReferenceCode::find(cases.front());
    std::vector<double> result;
    if (!code) {
        ADD_FAILURE() << code.error().text();
        return result;
    }
    for (std::size_t row = 0; row < cases.size(); row += placesPerRow) {
        const ReferenceCase bound(*code, inFloat(cases[row].block), inFloat(cases[row].slot));
        const double smallest = smallestOf(cases[row].block);
        const double allowed = boundOf(cases[row]);
        for (std::size_t i = row; i < row + placesPerRow; ++i) {
            if (!answers[i]) {
                ADD_FAILURE() << answers[i].error().text();
                return result;
            }
            const ReferenceNumbers exact = bound.evaluate(cases[i]);
            for (std::size_t k = 0; k < 3; ++k) {
                const double size = std::max(exact[k], smallest);
                result.push_back(std::abs((*answers[i])[k] - exact[k]) / size / allowed);
            }
        }
    }
    return result;
}

double percentile99(std::vector<double> numbers) {
    const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() * 99 / 100);
    std::nth_element(numbers.begin(), place, numbers.end());
    return *place;
}

class OrdinaryError : public testing::TestWithParam<const Block*> {};

TEST_P(OrdinaryError, NinetyNineOfAHundred_KeepTheirBound) {
    const std::vector<EvalCase> variants = sweepVariants(catalog(), *GetParam());
    const auto casesPerBlock = tests::casesOf<std::size_t>(20000, 100000);
    const std::size_t rows =
        std::clamp<std::size_t>(casesPerBlock / placesPerRow / variants.size(), 8, 100);
    EvalGpu gpu;
    double worst = 0.0;
    for (const EvalCase& variant : variants) {
        const double share = percentile99(shares(ordinaryCases(variant, rows), gpu));
        worst = std::max(worst, share);
        EXPECT_LE(share, 1.0) << "of the bound, with " << variantText(variant);
    }
    std::cout << "99 of 100 are within " << worst << " of the bound\n";
}

INSTANTIATE_TEST_SUITE_P(EveryModel, OrdinaryError, testing::ValuesIn(catalog().ofKind("models")),
                         nameOf);

} // namespace
} // namespace patina::stability::ordinary_error_test
