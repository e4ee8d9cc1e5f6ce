// SPDX-License-Identifier: GPL-3.0-or-later
// The table of docs/energy.md: how much of the light each part of each model gives back. Written
// anew with PATINA_WRITE_DOCS=1 in the environment.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "measure/hard_values.h"
#include "measure/reference_case.h"
#include "measure/sweep_cases.h"
#include "stability_cases.h"

namespace patina::stability {
namespace {

constexpr double lightDegrees[] = {0.0, 30.0, 60.0, 80.0, 89.0};
constexpr int rings = 96;
constexpr int sectors = 96;

/// What two compilers may differ by, and half a unit of the last digit that is written.
constexpr double tolerance = 0.002;

/// The integral of f (n.v) over the hemisphere of v by the midpoint rule in cos^2 and azimuth, in
/// which equal steps are equal shares of a diffuse surface; f = value / (pi n.l).
double albedo(const ReferenceCase& model, double degrees) {
    const double theta = degrees * std::numbers::pi / 180.0;
    EvalPlace place;
    place.l = {std::sin(theta), 0.0, std::cos(theta)};
    double sum = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double nv = std::sqrt((ring + 0.5) / rings);
        const double s = std::sqrt(1.0 - nv * nv);
        for (int sector = 0; sector < sectors; ++sector) {
            const double phi = 2.0 * std::numbers::pi * (sector + 0.5) / sectors;
            place.v = {s * std::cos(phi), s * std::sin(phi), nv};
            sum += std::max(model.evaluate(place)[0], 0.0);
        }
    }
    return sum / (rings * sectors) / place.l.z;
}

struct Row {
    std::string name;
    std::vector<double> albedos;
};

Row rowOf(const std::string& name, const EvalCase& request) {
    const ReferenceCase model(ReferenceCode::find(request).value(), request.block.packedValues(),
                              request.slot.block == nullptr ? std::vector<double>()
                                                            : request.slot.packedValues());
    Row row{name, {}};
    for (const double degrees : lightDegrees) {
        row.albedos.push_back(albedo(model, degrees));
    }
    return row;
}

/// The model's colours in turn at their largest, all others black.
void addParts(std::vector<Row>& rows, const std::string& name, const EvalCase& variant) {
    const auto& parameters = variant.block.block->parameters;
    for (const Parameter& lit : parameters) {
        if (lit.type != ParameterType::Color || lit.emission) {
            continue; // what glows is not given back
        }
        EvalCase part = variant;
        for (const Parameter& other : parameters) {
            if (other.type == ParameterType::Color) {
                part.block.values[other.id] = glm::dvec3(other.id == lit.id ? other.max : 0.0);
            }
        }
        Row row = rowOf(name + lit.id, part);
        const bool known = std::any_of(rows.begin(), rows.end(), [&row](const Row& old) {
            return old.albedos == row.albedos;
        });
        if (!known) {
            rows.push_back(row);
        }
    }
}

/// The defaults, then each other choice that changes what comes back.
std::vector<Row> rowsOf(const Block& model) {
    std::vector<Row> rows;
    const EvalCase base = sweepVariant(catalog(), defaultMaterial(model)).value();
    addParts(rows, "", base);
    for (const Parameter& parameter : model.parameters) {
        if (parameter.type != ParameterType::Enum) {
            continue;
        }
        for (const EnumValue& choice : parameter.values) {
            EvalCase variant = base;
            variant.block.values[parameter.id] = choice.id;
            addParts(rows, fmt::format("{}={}, ", parameter.id, choice.id), variant);
        }
    }
    return rows;
}

std::string lineOf(const Block& model, const Row& row) {
    std::string line = fmt::format("| {} | {} |", model.id, row.name);
    for (const double x : row.albedos) {
        line += fmt::format(" {:.3f} |", x);
    }
    return line;
}

std::string head() {
    std::string text =
        "# Energy\n\nThe directional albedo of every model in double precision: the share of the "
        "light from one\ndirection that comes back, in all directions together, by its angle from "
        "the normal. One colour\nparameter at a time is at its largest and the others are black; "
        "everything else has its\ndefault, or the one choice that the row names. Choices that "
        "change nothing are left out. More\nthan 1 is more than arrived; the descriptor's "
        "exemption from `energy_conserving` says why.\n\nWritten by `PATINA_WRITE_DOCS=1 "
        "patina-stability-tests --gtest_filter='Energy*'`.\n\n| model | part |";
    std::string rule = "| --- | --- |";
    for (const double degrees : lightDegrees) {
        text += fmt::format(" {} deg |", degrees);
        rule += " ---: |";
    }
    return text + '\n' + rule + '\n';
}

std::filesystem::path document() {
    return std::filesystem::path(PATINA_SOURCE_DIR) / "docs/energy.md";
}

/// "| model | part |" -> the numbers after it.
std::map<std::string, std::vector<double>> writtenRows() {
    std::map<std::string, std::vector<double>> rows;
    std::ifstream stream(document());
    for (std::string line; std::getline(stream, line);) {
        const auto second = line.find('|', line.find('|', 1) + 1);
        std::vector<double>& numbers = rows[line.substr(0, second + 1)];
        std::istringstream rest(second == std::string::npos ? "" : line.substr(second + 1));
        std::string bar;
        for (double x = 0.0; rest >> x; rest >> bar) {
            numbers.push_back(x);
        }
    }
    return rows;
}

TEST(Energy, Document_IsCurrent) {
    const auto written = writtenRows();
    std::string table = head();
    for (const Block* model : catalog().ofKind("models")) {
        for (const Row& row : rowsOf(*model)) {
            table += lineOf(*model, row) + '\n';
            const auto old = written.find(fmt::format("| {} | {} |", model->id, row.name));
            const bool same =
                old != written.end() && old->second.size() == row.albedos.size() &&
                std::equal(row.albedos.begin(), row.albedos.end(), old->second.begin(),
                           [](double x, double y) {
                               return std::abs(x - y) <= tolerance * std::max(1.0, std::abs(x));
                           });
            EXPECT_TRUE(same || std::getenv("PATINA_WRITE_DOCS") != nullptr) << lineOf(*model, row);
        }
    }
    if (std::getenv("PATINA_WRITE_DOCS") != nullptr) {
        std::ofstream(document()) << table;
    }
    std::cout << table;
}

TEST(Energy, WhiteLambert_GivesEverythingBack) {
    const auto rows = rowsOf(*catalog().find("models", "lambert"));
    for (const double x : rows.front().albedos) {
        EXPECT_NEAR(x, 1.0, 1e-12);
    }
}

} // namespace
} // namespace patina::stability
