// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/eval_line.h"
#include "measure/eval/eval_gpu.h"
#include "measure/eval/eval_reference.h"
#include "physics_cases.h"

namespace patina::physics::fresnel_tables_test {
namespace {

/// The tables have 15 digits; a float has 7.
constexpr double inDouble = 1e-12;
constexpr double inTheShader = 1e-6;

struct Row {
    EvalCase request;
    std::vector<double> value;
    std::string text;
};

std::vector<Row> rowsOf(const std::string& name) {
    std::vector<Row> rows;
    const auto data = table("fresnel_tables.json");
    for (const auto& known : data["tables"]) {
        if (known["name"] != name) {
            continue;
        }
        for (nlohmann::json json : known["rows"]) {
            const auto value = json["value"].get<std::vector<double>>();
            json.erase("value");
            const EvalLine line = readEvalLine(json.dump(), catalog());
            if (!line.request) {
                throw std::runtime_error(json.dump() + ": " + line.request.error().text());
            }
            rows.push_back({*line.request, value, json.dump()});
        }
    }
    return rows;
}

/// What half a unit in the last place of a float changes in the angle, in an argument or in a
/// number of the block: near a critical angle, or of the phase in a film of many wavelengths, that
/// is more than 1e-6 of a reflectance.
std::vector<double> noiseOf(const EvalCase& request, const std::vector<double>& results) {
    std::vector<double> noise(results.size(), 0.0);
    const auto add = [&](const EvalCase& moved) {
        const auto changed = evaluatedInDouble(moved).value();
        for (std::size_t i = 0; i < results.size(); ++i) {
            noise[i] += std::abs(changed[i] - results[i]);
        }
    };
    EvalCase moved = request;
    moved.number *= 1.0 - 0x1p-24;
    add(moved);
    for (const auto& [id, value] : request.block.values) {
        if (const auto* number = std::get_if<double>(&value)) {
            moved = request;
            moved.block.values[id] = *number * (1.0 - 0x1p-24);
            add(moved);
        }
    }
    for (std::size_t i = 0; i < request.arguments.size(); ++i) {
        moved = request;
        moved.arguments[i] *= 1.0 - 0x1p-24;
        add(moved);
    }
    return noise;
}

class FresnelTables : public testing::TestWithParam<std::string> {};

TEST_P(FresnelTables, InDoublePrecision_AgreeTo12Digits) {
    for (const Row& row : rowsOf(GetParam())) {
        const auto values = evaluatedInDouble(row.request).value();
        ASSERT_EQ(values.size(), row.value.size()) << row.text;
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_NEAR(values[i], row.value[i], inDouble * std::max(1.0, row.value[i]))
                << row.text;
        }
    }
}

TEST_P(FresnelTables, InTheShader_AgreeTo6Digits) {
    EvalGpu gpu;
    const std::vector<Row> rows = rowsOf(GetParam());
    std::vector<EvalCase> cases;
    for (const Row& row : rows) {
        cases.push_back(row.request);
    }
    const auto answers = gpu.evaluate(cases, catalog());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        ASSERT_TRUE(answers[row]) << answers[row].error().text();
        const auto noise = noiseOf(rows[row].request, rows[row].value);
        for (std::size_t i = 0; i < noise.size(); ++i) {
            const double wanted = rows[row].value[i];
            EXPECT_NEAR((*answers[row])[i], wanted, inTheShader * std::max(1.0, wanted) + noise[i])
                << rows[row].text;
        }
    }
}

std::vector<std::string> tableNames() {
    std::vector<std::string> names;
    const auto data = table("fresnel_tables.json");
    for (const auto& known : data["tables"]) {
        names.push_back(known["name"]);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Published, FresnelTables, testing::ValuesIn(tableNames()),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             for (char& c : name) {
                                 c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                             }
                             return name;
                         });

} // namespace
} // namespace patina::physics::fresnel_tables_test
