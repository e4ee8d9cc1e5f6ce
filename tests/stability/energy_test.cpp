// SPDX-License-Identifier: GPL-3.0-or-later
// The table of docs/energy.md: how much of the light each part of each model gives back. Written
// anew with PATINA_WRITE_DOCS=1 in the environment.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "albedo.h"
#include "measure/stability/sweep_cases.h"
#include "stability_cases.h"

namespace patina::stability::energy_test {
namespace {

constexpr double lightDegrees[] = {0.0, 30.0, 60.0, 80.0, 89.0};
/// What two compilers may differ by, and half a unit of the last digit that is written.
constexpr double tolerance = 0.002;

struct Row {
    std::string name;
    std::vector<double> albedos;
};

Row rowOf(const std::string& name, const EvalCase& request) {
    Row row{name, {}};
    for (const double degrees : lightDegrees) {
        row.albedos.push_back(albedo(request, degrees));
    }
    return row;
}

/// But for what sums in double precision are rounded by.
bool areEqual(const std::vector<double>& a, const std::vector<double>& b) {
    constexpr double rounding = 1e-9;
    return std::ranges::equal(a, b, [](double x, double y) {
        return std::abs(x - y) <= rounding * std::max(1.0, std::abs(x));
    });
}

/// The model's colours in turn at their largest, all others black; not those that are switched off.
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
        const bool dark =
            std::all_of(row.albedos.begin(), row.albedos.end(), [](double x) { return x == 0.0; });
        const bool known = dark || std::any_of(rows.begin(), rows.end(), [&row](const Row& old) {
                               return areEqual(old.albedos, row.albedos);
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
            if (variant.block.values == base.block.values) {
                continue; // the default, whose rows are there
            }
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
        "change nothing and colours that\nare switched off are left out. More than 1 is more than "
        "arrived; the descriptor's exemption from\n`energy_conserving` says why. A "
        "model that draws marks is looked at in one place of its\npattern, pixel (0, 0), where ink "
        "and paper stand for themselves: no mean over the pattern.\n\nWritten by "
        "`PATINA_WRITE_DOCS=1 patina-stability-tests --gtest_filter='Energy.*'`.\n\n"
        "| model | part |";
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
} // namespace patina::stability::energy_test
