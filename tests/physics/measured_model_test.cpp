// SPDX-License-Identifier: GPL-3.0-or-later
// The model that shows a measured file returns what the file holds, in double precision and on the
// device.
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "material/preset_file.h"
#include "measure/eval/eval_gpu.h"
#include "measure/eval/model_values.h"
#include "measure/lobe/lobe_lines.h"
#include "measure/match/match_target.h"
#include "measure/stability/sweep_cases.h"
#include "measured/measured_reflectance.h"
#include "support/measured_files.h"
#include "support/program.h"

namespace patina::measured_model_test {
namespace {

using std::numbers::pi;
using tests::merlBytes;
using tests::RglFile;
using tests::TemporaryFolder;
using tests::writeFile;

const Catalog& catalog() {
    static const Catalog shipped = loadCatalog(standardBlockRoots());
    return shipped;
}

/// A matte part, a lobe and a part that the azimuth changes; nothing was measured at grazing
/// angles.
glm::dvec3 measuredSurface(const DirectionPair& pair) {
    if (std::min(pair.l.z, pair.v.z) < 0.05) {
        return glm::dvec3(-1.0);
    }
    const glm::dvec3 h = glm::normalize(pair.l + pair.v);
    const double along = pair.l.x * pair.v.x + pair.l.y * pair.v.y;
    return glm::dvec3(0.3, 0.2, 0.1) / pi + (0.5 + 0.2 * along) * std::exp(-9.0 * (1.0 - h.z));
}

/// Directions above the surface; every third is within a degree of the horizon.
std::vector<DirectionPair> manyPairs() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const auto direction = [&](bool isGrazing) {
        const double z = isGrazing ? 1e-4 + 0.02 * share(random) : 0.02 + 0.98 * share(random);
        const double azimuth = 2.0 * pi * share(random);
        const double s = std::sqrt(1.0 - z * z);
        return glm::dvec3(s * std::cos(azimuth), s * std::sin(azimuth), z);
    };
    std::vector<DirectionPair> pairs;
    for (int i = 0; i < 3000; ++i) {
        pairs.push_back({direction(i % 3 == 0), direction(i % 3 == 1)});
    }
    return pairs;
}

/// Returns the albedo by many directions that are even in projected solid angle.
glm::dvec3 albedoByDirections(const LobeModel& model, double angle) {
    constexpr int elevations = 500;
    constexpr int azimuths = 120;
    const glm::dvec3 l(std::sin(angle), 0.0, std::cos(angle));
    glm::dvec3 sum(0.0);
    for (int i = 0; i < elevations; ++i) {
        const double z = std::sqrt(1.0 - (i + 0.5) / elevations);
        const double s = std::sqrt((i + 0.5) / elevations);
        for (int j = 0; j < azimuths; ++j) {
            const double phi = pi * (j + 0.5) / azimuths; // the other half is the same
            sum += model.reflectance(l, {s * std::cos(phi), s * std::sin(phi), z});
        }
    }
    return pi * sum / double(elevations * azimuths);
}

class MeasuredModel : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& bytes) {
        writeFile(folder_ / name, bytes);
        const auto reading = readPreset(folder_ / name, catalog());
        ASSERT_TRUE(reading) << reading.error().front().text();
        EXPECT_TRUE(reading->readOnly);
        material_ = reading->material;
        measured_ = *readMeasured(folder_ / name);
    }

    TemporaryFolder folder_;
    Material material_;
    std::shared_ptr<const MeasuredReflectance> measured_;
};

TEST_F(MeasuredModel, Albedo_IsKnownAsWellAsATableIs) {
    write("a.binary", merlBytes({30, 20, 36}, measuredSurface));
    const LobeModel model = *LobeModel::create(catalog(), material_);
    LobeRequest request;
    request.plot = LobePlot::Albedo;
    const auto lines = lobeLines(catalog(), material_, request);
    ASSERT_TRUE(lines) << lines.error().text();
    for (const double degrees : {0.0, 35.0, 75.0}) {
        const glm::dvec3 counted = albedoByDirections(model, degrees * pi / 180.0);
        const glm::dvec3 found = valueAt(lines->lines.front(), degrees);
        EXPECT_NEAR(found.x, counted.x, 2e-3) << degrees;
        EXPECT_NEAR(found.z, counted.z, 2e-3) << degrees;
    }
}

TEST_F(MeasuredModel, MerlFile_GivesTheFilesValues) {
    write("a.binary", merlBytes({30, 20, 36}, measuredSurface));
    const LobeModel model = *LobeModel::create(catalog(), material_);
    double brightest = 0.0;
    for (const DirectionPair& pair : manyPairs()) {
        const glm::dvec3 wanted = pi * pair.l.z * measured_->evaluate(pair);
        const glm::dvec3 found = model.value(pair.l, pair.v);
        brightest = std::max(brightest, wanted.x);
        EXPECT_LT(glm::length(found - wanted), 1e-9) << pair.l.z << ' ' << pair.v.z;
    }
    EXPECT_GT(brightest, 1.0);
    const DirectionPair facing{};
    EXPECT_LT(glm::length(model.value(facing.l, facing.v) - pi * measured_->evaluate(facing)),
              1e-9);
    EXPECT_TRUE(model.isIsotropic());
}

glm::dvec3 paint(const DirectionPair& pair) {
    return glm::dvec3(0.3, 0.2, 0.1) / pi +
           glm::dvec3(0.1 * std::exp(-2.0 * (1.0 - glm::normalize(pair.l + pair.v).z)));
}

/// Adds up squares of how far a function is from another.
class RelativeError {
  public:
    void add(const glm::dvec3& found, const glm::dvec3& wanted) {
        sum_ += glm::dot(wanted, wanted);
        error_ += glm::dot(found - wanted, found - wanted);
    }
    double value() const { return std::sqrt(error_ / sum_); }

  private:
    double sum_ = 0.0;
    double error_ = 0.0;
};

/// A file's own interpolation tells the light from the eye where the surface does not: a table,
/// which cannot, lies in the middle, so it is off from the file by half of that and nearer the
/// surface than the file.
TEST_F(MeasuredModel, RglFile_IsAsNearTheSurfaceAsTheFileAllows) {
    write("a.bsdf", RglFile{.polars = 8, .grid = 32}.bytes(paint));
    const LobeModel model = *LobeModel::create(catalog(), material_);
    RelativeError fromFile;
    RelativeError fromSurface;
    RelativeError ofFile;
    RelativeError ofItsMean;
    for (const DirectionPair& pair : manyPairs()) {
        if (std::min(pair.l.z, pair.v.z) > 0.2) {
            const double factor = pi * pair.l.z;
            const glm::dvec3 file = measured_->evaluate(pair);
            const glm::dvec3 swapped = measured_->evaluate({pair.v, pair.l});
            const glm::dvec3 found = model.value(pair.l, pair.v);
            fromFile.add(found, factor * file);
            fromSurface.add(found, factor * paint(pair));
            ofFile.add(factor * file, factor * paint(pair));
            ofItsMean.add(0.5 * factor * (file + swapped), factor * paint(pair));
        }
    }
    EXPECT_LT(fromFile.value(), 0.02);
    EXPECT_LT(fromSurface.value(), ofFile.value());
    EXPECT_LT(fromSurface.value(), 1.01 * ofItsMean.value()); // the bins lose nothing
}

/// Expects of the device what double precision gives, where light and viewer are floats.
void expectTheSameOnTheDevice(const std::vector<EvalCase>& cases, const ModelValues& values) {
    EvalGpu gpu;
    const auto answers = gpu.evaluate(cases, catalog());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ASSERT_TRUE(answers[i]) << answers[i].error().text();
        const glm::dvec3 wanted = values.at({cases[i].l, cases[i].v});
        for (int c = 0; c < 3; ++c) {
            const double found = (*answers[i])[std::size_t(c)];
            EXPECT_TRUE(std::isfinite(found) && found >= 0.0);
            EXPECT_NEAR(found, wanted[c], 2e-4 * std::max(wanted[c], 0.1)) << i;
        }
    }
}

TEST_F(MeasuredModel, Device_GivesTheSameValues) {
    write("a.binary", merlBytes({30, 20, 36}, measuredSurface));
    const EvalCase request = *sweepVariant(catalog(), material_);
    const ModelValues values = *ModelValues::of(request, catalog());
    std::vector<EvalCase> cases;
    for (const DirectionPair& pair : manyPairs()) {
        cases.push_back(request);
        cases.back().l = glm::dvec3(glm::vec3(pair.l));
        cases.back().v = glm::dvec3(glm::vec3(pair.v));
    }
    expectTheSameOnTheDevice(cases, values);
}

/// A brushed metal by Ward's exponential, which is long across the tangent.
glm::dvec3 brushed(const DirectionPair& pair) {
    const glm::dvec3 H = pair.l + pair.v;
    const double exponent = (H.x * H.x / 0.04 + H.y * H.y / 0.25) / (H.z * H.z);
    return glm::dvec3(0.9, 0.6, 0.3) * (0.05 + std::exp(-exponent));
}

/// A surface with a grain, whose file is read once.
class MeasuredGrain : public MeasuredModel {
  protected:
    void SetUp() override {
        write("brushed.bsdf", RglFile{.azimuths = 9, .polars = 8, .grid = 16}.bytes(brushed));
        ASSERT_EQ(material_.model.id, "measured-grain");
    }
};

TEST_F(MeasuredGrain, Model_IsAsNearTheFileAsItsBinsAreFineAndTheSameOnTheDevice) {
    const EvalCase request = *sweepVariant(catalog(), material_);
    const ModelValues values = *ModelValues::of(request, catalog());
    std::vector<EvalCase> cases;
    RelativeError fromFile;
    for (const DirectionPair& pair : manyPairs()) {
        cases.push_back(request);
        cases.back().l = glm::dvec3(glm::vec3(pair.l));
        cases.back().v = glm::dvec3(glm::vec3(pair.v));
        if (std::min(pair.l.z, pair.v.z) > 0.2) {
            fromFile.add(values.at(pair),
                         0.5 * pi * pair.l.z *
                             (measured_->evaluate(pair) + measured_->evaluate({pair.v, pair.l})));
        }
    }
    EXPECT_LT(fromFile.value(), 0.02);
    const double s = std::sqrt(0.5);
    EXPECT_GT(values.at({{0.0, s, s}, {0.0, 0.0, 1.0}}).x,
              2.0 * values.at({{s, 0.0, s}, {0.0, 0.0, 1.0}}).x); // so it is not isotropic
    expectTheSameOnTheDevice(cases, values);
}

TEST_F(MeasuredModel, FileThatChanged_IsReadAgain) {
    const auto matte = [](double albedo) {
        return merlBytes({4, 4, 4},
                         [albedo](const DirectionPair&) { return glm::dvec3(albedo / pi); });
    };
    for (const double albedo : {0.25, 0.75}) {
        write("a.binary", matte(albedo));
        const LobeModel model = *LobeModel::create(catalog(), material_);
        EXPECT_NEAR(model.value({0, 0, 1}, {0, 0, 1}).x, albedo, 1e-6);
    }
}

TEST_F(MeasuredModel, FileThatCannotBeRead_IsAnErrorInPlotsAndMatches) {
    write("a.binary", merlBytes({4, 4, 4}, [](const DirectionPair&) { return glm::dvec3(0.1); }));
    for (const std::string& bytes : {std::string("no table"), std::string()}) {
        if (bytes.empty()) {
            std::filesystem::remove(folder_ / "a.binary");
        } else {
            writeFile(folder_ / "a.binary", bytes);
        }
        const auto model = LobeModel::create(catalog(), material_);
        ASSERT_FALSE(model);
        EXPECT_NE(model.error().text().find("a.binary"), std::string::npos);
        EXPECT_FALSE(matchAim(material_, catalog(), 64));
    }
}

TEST_F(MeasuredModel, WithoutAFile_IsMatteGrey) {
    const Material none = defaultMaterial(*catalog().find(kinds::models, "measured"));
    const LobeModel model = *LobeModel::create(catalog(), none);
    EXPECT_NEAR(model.value({0, 0, 1}, {0.6, 0, 0.8}).y, 0.5, 1e-6);
}

} // namespace
} // namespace patina::measured_model_test
