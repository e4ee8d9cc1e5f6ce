// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the reflectance decides of a model's values is found again, for every model.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "core/progress.h"
#include "measure/eval/model_values.h"
#include "measure/match/free_numbers.h"
#include "measure/match/model_matches.h"
#include "measure/stability/sweep_cases.h"
#include "support/measured_files.h"
#include "support/program.h"

namespace patina::match_recovery_test {
namespace {

using std::numbers::pi;
using tests::TemporaryFolder;

constexpr std::size_t directions = 112;

/// Is how near a number has to be found, in lengths of its slider.
constexpr double nearness = 1e-3;

/// A number is identifiable where a change by `nearness` changes the reflectance by more than this,
/// as the root mean square of ln(1 + pi f cos) over all directions and channels, whatever all other
/// numbers do at the same time: where its column of the Jacobian is far enough from the space that
/// the others span. It is a tenth of the error at which a search may end (1e-5).
constexpr double seenChange = 1e-6;

/// Is how far two sets of values may be apart in the same measure, and still be the same
/// everywhere.
constexpr double sameEverywhere = 1e-8;

/// Is the largest count of numbers of models that are cheap enough to be found in files, too.
constexpr std::size_t fewNumbers = 8;

const Catalog& catalog() {
    static const Catalog shipped = loadCatalog(standardBlockRoots());
    return shipped;
}

EvalCase start(const Block& model) {
    return *sweepVariant(catalog(), defaultMaterial(model));
}

/// Returns the model with other values than those that a fit begins with: random places in the
/// middle of their sliders.
EvalCase hidden(const EvalCase& start) {
    std::minstd_rand random(7);
    std::uniform_real_distribution<double> place(0.15, 0.85);
    EvalCase other = start;
    const FreeNumbers numbers(start);
    std::vector<double> places(numbers.size());
    std::ranges::generate(places, [&] { return place(random); });
    numbers.set(other, places.data());
    return other;
}

std::vector<double> logsAt(const EvalCase& model, const MatchTarget& target) {
    const ModelValues values = *ModelValues::of(model, catalog());
    std::vector<double> logs;
    for (const DirectionPair& pair : target.pairs) {
        const glm::dvec3 value = values.at(pair);
        logs.insert(logs.end(), {std::log1p(value.x), std::log1p(value.y), std::log1p(value.z)});
    }
    return logs;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

/// Returns the columns of the Jacobian at a model's values, per length of a slider, each divided by
/// the root of its length, so that its norm is a root mean square.
std::vector<std::vector<double>> jacobian(const EvalCase& model, const MatchTarget& target) {
    constexpr double step = 1e-5;
    const FreeNumbers numbers(model);
    const std::vector<double> places = numbers.of(model);
    std::vector<std::vector<double>> columns;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto logsBeside = [&](double offset) {
            std::vector<double> moved = places;
            moved[k] += offset;
            EvalCase beside = model;
            numbers.set(beside, moved.data());
            return logsAt(beside, target);
        };
        std::vector<double> column = logsBeside(step);
        const std::vector<double> below = logsBeside(-step);
        const double scale = 2.0 * step * std::sqrt(double(column.size()));
        for (std::size_t i = 0; i < column.size(); ++i) {
            column[i] = (column[i] - below[i]) / scale;
        }
        columns.push_back(std::move(column));
    }
    return columns;
}

/// Returns what is left of each column when the others have been subtracted as well as they can
/// be: its distance from the space that they span.
std::vector<double> distancesFromOthers(const std::vector<std::vector<double>>& columns) {
    std::vector<double> distances;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        std::vector<std::vector<double>> basis;
        const auto subtract = [&basis](std::vector<double> column) {
            for (int pass = 0; pass < 2; ++pass) { // the second removes what was rounded
                for (const std::vector<double>& unit : basis) {
                    const double share = product(unit, column);
                    for (std::size_t i = 0; i < column.size(); ++i) {
                        column[i] -= share * unit[i];
                    }
                }
            }
            return column;
        };
        for (std::size_t other = 0; other < columns.size(); ++other) {
            const double length = std::sqrt(product(columns[other], columns[other]));
            if (other == k || length == 0.0) {
                continue;
            }
            std::vector<double> rest = subtract(columns[other]);
            const double left = std::sqrt(product(rest, rest));
            if (left > 1e-7 * length) { // else differences of rounded values
                for (double& number : rest) {
                    number /= left;
                }
                basis.push_back(std::move(rest));
            }
        }
        const std::vector<double> rest = subtract(columns[k]);
        distances.push_back(std::sqrt(product(rest, rest)));
    }
    return distances;
}

/// Returns the root mean square of how far two models are apart in the measure of a fit.
double distance(const EvalCase& a, const EvalCase& b, const MatchTarget& target) {
    std::vector<double> all = logsAt(a, target);
    const std::vector<double> other = logsAt(b, target);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] -= other[i];
    }
    return std::sqrt(product(all, all) / double(all.size()));
}

/// Counts the numbers of models that can be told from their reflectance.
struct Found {
    int identifiable = 0;
    int ofTwins = 0; ///< counts those that another set of values has, whose reflectance is the same
};

/// Fits a model to a target that its values `truth` made, and compares all identifiable numbers.
Found expectFound(const Block& model, const EvalCase& truth, const MatchTarget& target) {
    Progress progress;
    const auto fit = fittedModel(start(model), target, {}, catalog(), progress);
    EXPECT_TRUE(fit && fit->relative < 1e-3);
    const FreeNumbers numbers(truth);
    const std::vector<double> distances = distancesFromOthers(jacobian(truth, target));
    const std::vector<double> wanted = numbers.of(truth);
    const std::vector<double> found = numbers.of(fit->model);
    // Another set of values may be the same reflectance everywhere, such as a grain that is turned
    // by 90 degrees with its widths exchanged.
    const bool isTheSame =
        distance(truth, fit->model, *matchTarget(truth, 4 * directions, catalog())) <
        sameEverywhere;
    Found counts;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        if (nearness * distances[k] < seenChange) {
            continue;
        }
        ++counts.identifiable;
        if (isTheSame && std::abs(found[k] - wanted[k]) > nearness) {
            ++counts.ofTwins;
            continue;
        }
        EXPECT_NEAR(found[k], wanted[k], nearness) << model.id << ": " << numbers.parameter(k);
    }
    EXPECT_GT(counts.identifiable, 0) << model.id;
    return counts;
}

TEST(Recovery, EveryModel_FindsItsIdentifiableNumbersInAPreset) {
    Found all;
    for (const Block* model : matchedModels(catalog())) {
        const EvalCase truth = hidden(start(*model));
        const Found counts = expectFound(*model, truth, *matchTarget(truth, directions, catalog()));
        all.identifiable += counts.identifiable;
        all.ofTwins += counts.ofTwins;
    }
    EXPECT_GT(all.identifiable, 60);
    EXPECT_LE(all.ofTwins, 3);
}

/// Both kinds of files hold a model whose light does not depend on the grain; a MERL file only a
/// reciprocal one.
TEST(Recovery, CheapModels_FindTheirIdentifiableNumbersInFiles) {
    const TemporaryFolder folder;
    int read = 0;
    for (const Block* model : matchedModels(catalog())) {
        const EvalCase truth = hidden(start(*model));
        if (!model->hasClaim("isotropic") || FreeNumbers(truth).size() > fewNumbers) {
            continue;
        }
        const ModelValues values = *ModelValues::of(truth, catalog());
        const auto reflectance = [&values](const DirectionPair& pair) {
            return values.at(pair) / (pi * pair.l.z);
        };
        std::vector<std::filesystem::path> files{folder / (model->id + ".bsdf")};
        tests::writeFile(files[0], tests::RglFile{}.bytes(reflectance));
        if (model->hasClaim("reciprocal")) {
            files.push_back(folder / (model->id + ".binary"));
            tests::writeFile(files[1], tests::merlBytes({20, 20, 40}, reflectance));
        }
        for (const std::filesystem::path& file : files) {
            const auto measured = readMeasured(file);
            ASSERT_TRUE(measured) << measured.error().text();
            EXPECT_EQ(expectFound(*model, truth, *matchTarget(**measured, directions)).ofTwins, 0);
            ++read;
        }
    }
    EXPECT_GE(read, 8);
}

} // namespace
} // namespace patina::match_recovery_test
