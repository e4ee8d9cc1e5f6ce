// SPDX-License-Identifier: GPL-3.0-or-later
// What the sweep finds wrong with a model that was not there when this program was built.
#include <gtest/gtest.h>

#include "gl/headless_context.h"
#include "measure/stability/stability_sweep.h"
#include "measure/stability/sweep_cases.h"
#include "stability_cases.h"
#include "support/program.h"

namespace patina::stability::user_block_test {
namespace {

using Found = std::vector<std::string>;

/// A user's folder with a model of two files.
class UserModel : public testing::Test {
  protected:
    /// What is wrong with a model that returns `body` and claims this.
    Found foundIn(const std::string& body, const std::string& claims = {}) {
        write(body, claims);
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        const Catalog catalog = loadCatalog(roots);
        EXPECT_TRUE(catalog.errors.empty()) << text(catalog.errors);
        const SweepReport report = swept(catalog);
        EXPECT_TRUE(report.errors.empty()) << text(report.errors);
        EXPECT_TRUE(report.withoutDouble);
        Found found;
        for (const auto& [key, tally] : report.defects) {
            found.emplace_back(wordsFor(key.defect));
        }
        return found;
    }

  private:
    void write(const std::string& body, const std::string& claims) {
        tests::writeFile(folder_ / "models/tried.json", R"({
            "id": "tried", "version": 1, "label": "Tried", "summary": "A test.",
            "applications": "None.", "source": "None.",
            "parameters": [{"id": "width", "label": "Width", "doc": "A width.", "type": "float",
                            "default": 0.5, "min": 0.0, "max": 1.0, "step": 0.01}],
            "claims": ["finite", "non_negative", "zero_below_horizon")" +
                                                            claims + "]}");
        tests::writeFile(folder_ / "models/tried.glsl",
                         "// SPDX-License-"
                         "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                         "vec3 tried(Directions d, Tried p) {\n    return " +
                             body + ";\n}\n");
    }

    static SweepReport swept(const Catalog& catalog) {
        const auto context = gl::HeadlessContext::create();
        EXPECT_TRUE(context) << (context ? "" : context.error().text());
        SweepOptions options;
        options.cases = 20000;
        options.shaders = catalog.roots.front().folder;
        StabilitySweep sweep(sweepVariants(catalog, *catalog.find("models", "tried")), options);
        while (!sweep.finished()) {
            sweep.step();
        }
        return sweep.report();
    }

    tests::TemporaryFolder folder_;
};

TEST_F(UserModel, ThatIsInfiniteAtOrdinaryDirections_IsFound) {
    EXPECT_EQ(foundIn("vec3(d.nv > 0.6 && d.nv < 0.65 ? d.nl / max(d.nv - 2.0, 0.0) : d.nl)"),
              Found{"infinite"});
}

TEST_F(UserModel, ThatBreaksThereAtTheEndOfARangeOnly_IsFound) {
    EXPECT_EQ(foundIn("vec3(p.width == 1.0 && d.nl > 0.55 && d.nl < 0.65 ? -1.0 : d.nl)"),
              Found{"negative"});
}

TEST_F(UserModel, FalseClaimOfReciprocity_IsFound) {
    EXPECT_EQ(foundIn("vec3(d.nl * d.nl)", R"(, "reciprocal")"), Found{"claim broken: reciprocal"});
}

TEST_F(UserModel, FalseClaimOfIsotropy_IsFound) {
    EXPECT_EQ(foundIn("vec3(d.nl * d.lt * d.lt)", R"(, "isotropic")"),
              Found{"claim broken: isotropic"});
}

TEST_F(UserModel, FalseClaimOfEnergy_IsFound) {
    EXPECT_EQ(foundIn("vec3(1.02 * d.nl)", R"(, "energy_conserving")"),
              Found{"claim broken: energy_conserving"});
}

TEST_F(UserModel, FalseClaimOfEnergyOfASharpLobe_IsFound) {
    // Twice what gives all light back along the normal.
    EXPECT_EQ(
        foundIn("vec3(502.0 * d.nl * pow(max(d.rv, 1e-6), 500.0))", R"(, "energy_conserving")"),
        Found{"claim broken: energy_conserving"});
}

TEST_F(UserModel, TrueClaimOfEnergyOfASharpLobe_IsNotDoubted) {
    EXPECT_EQ(
        foundIn("vec3(251.0 * d.nl * pow(max(d.rv, 1e-6), 500.0))", R"(, "energy_conserving")"),
        Found{});
}

TEST_F(UserModel, FalseClaimOfContinuity_IsFound) {
    EXPECT_EQ(foundIn("vec3(0.5)", R"(, "continuous_at_horizon")"),
              Found{"claim broken: continuous_at_horizon"});
}

TEST_F(UserModel, TrueClaims_AreNotDoubted) {
    EXPECT_EQ(foundIn("vec3(d.nl)", R"(, "reciprocal", "isotropic", "energy_conserving",
                                       "continuous_at_horizon")"),
              Found{});
}

} // namespace
} // namespace patina::stability::user_block_test
