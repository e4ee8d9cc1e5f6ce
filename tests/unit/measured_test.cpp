// SPDX-License-Identifier: GPL-3.0-or-later
// Files of measured reflectances, written here by formula in both formats, are read back within
// what the format keeps; damaged ones end in a message with the place.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/table_number.h"
#include "measured/half_difference.h"
#include "measured/kept_tables.h"
#include "measured/measured_reflectance.h"
#include "measured/sampled_table.h"
#include "measured/spectrum_color.h"
#include "support/measured_files.h"
#include "support/program.h"

namespace patina::measured_test {
namespace {

using std::numbers::pi;
using tests::merlBytes;
using tests::RglFile;
using tests::TemporaryFolder;
using tests::writeFile;

/// A matte part and a broad lobe that changes with the azimuth around the mirror direction.
glm::dvec3 smooth(const DirectionPair& pair) {
    const glm::dvec3 h = glm::normalize(pair.l + pair.v);
    const double lobe = std::exp(-8.0 * (1.0 - h.z));
    return glm::dvec3(0.3, 0.2, 0.1) / pi + glm::dvec3(0.2, 0.4, 0.8) * lobe;
}

class Measured : public testing::Test {
  protected:
    Result<std::shared_ptr<const MeasuredReflectance>> read(const std::string& bytes) const {
        writeFile(folder_ / "a.binary", bytes);
        return readMeasured(folder_ / "a.binary");
    }
    std::string problemOf(const std::string& bytes) const {
        const auto reading = read(bytes);
        return reading ? "" : reading.error().text();
    }

    /// The largest difference from a function at what the file holds exactly, relative to it.
    static double largestError(const MeasuredReflectance& measured,
                               const std::function<glm::dvec3(const DirectionPair&)>& expected) {
        double largest = 0.0;
        for (const DirectionPair& pair : measured.samples(500)) {
            const glm::dvec3 wanted = expected(pair);
            for (int c = 0; c < 3; ++c) {
                largest =
                    std::max(largest, std::abs(measured.evaluate(pair)[c] - wanted[c]) / wanted[c]);
            }
        }
        return largest;
    }

    TemporaryFolder folder_;
};

TEST_F(Measured, MerlFile_IsReadBackAsItWasWritten) {
    const auto reading = read(merlBytes({30, 30, 60}, smooth));
    ASSERT_TRUE(reading) << reading.error().text();
    EXPECT_TRUE((*reading)->isIsotropic());
    EXPECT_EQ((*reading)->samples(500).size(), 500u);
    EXPECT_LT(largestError(**reading, smooth), 1e-6);
}

TEST_F(Measured, Table_HasTheFilesBinsAndWhatWasNotMeasured) {
    const auto reading = read(merlBytes({6, 5, 8}, [](const DirectionPair& pair) {
        return pair.l.z < 0.4 ? glm::dvec3(-1.0) : smooth(pair);
    }));
    ASSERT_TRUE(reading);
    const HalfDifferenceTable table = (*reading)->table(TableForm::WithoutGrain);
    EXPECT_EQ(table.bins, glm::ivec3(8, 5, 6));
    ASSERT_EQ(table.texels.size(), 240u);
    for (const DirectionPair& pair : (*reading)->samples(500)) {
        const HalfDifference angles = halfDifference(pair);
        const double root = std::sqrt(angles.half / (0.5 * pi));
        const glm::ivec3 bin(angles.azimuth / pi * 8.0, angles.difference / (0.5 * pi) * 5.0,
                             root * 6.0);
        const glm::vec3 texel = table.texels[std::size_t((bin.z * 5 + bin.y) * 8 + bin.x)];
        EXPECT_LT(glm::length(glm::dvec3(texel) - (*reading)->evaluate(pair)), 1e-6);
    }
    const auto isMissing = [](const glm::vec3& texel) { return texel.x < 0.0f; };
    EXPECT_GT(std::ranges::count_if(table.texels, isMissing), 10);
}

/// A surface that is brighter where the half vector lies over one side of the tangent.
class Brushed : public MeasuredReflectance {
  public:
    glm::dvec3 evaluate(const DirectionPair& pair) const override {
        const glm::dvec3 h = glm::normalize(pair.l + pair.v);
        return glm::dvec3(0.5 + 0.3 * h.x + 0.1 * h.y, 0.2, 0.1);
    }
    std::optional<DirectionPair> nearestSample(const DirectionPair&) const override { return {}; }
    HalfDifferenceTable table(TableForm form) const override { return sampledTable(*this, form); }
    bool isIsotropic() const override { return false; }
    std::string description() const override { return {}; }
};

TEST(MeasuredTable, WithGrain_HasASliceForEachAzimuthOfTheHalfVector) {
    const HalfDifferenceTable table = Brushed().table(TableForm::WithGrain);
    ASSERT_EQ(table.bins, glm::ivec3(22 * 5, 33 * 4, 65 * 3));
    const double root = 40.5 / 64.0;
    const double sine = std::sin(root * root * 0.5 * pi);
    const auto at = [&table](int turn, int difference) {
        const int column = turn % 5 * 22 + 11;
        const int row = turn / 5 % 4 * 33 + difference;
        const int layer = turn / 20 * 65 + 40;
        return double(
            table.texels[std::size_t((layer * table.bins.y + row) * table.bins.x + column)].x);
    };
    for (const int turn : {0, 7, 15, 30, 59}) {
        const double azimuth = 2.0 * pi * turn / grainTurns;
        EXPECT_NEAR(at(turn, 4), 0.5 + sine * (0.3 * std::cos(azimuth) + 0.1 * std::sin(azimuth)),
                    1e-6);
        EXPECT_LT(at(turn, 32), 0.0); // parts it from the next one
    }
}

TEST_F(Measured, TableOfEitherForm_IsKeptBesideTheOther) {
    const std::filesystem::path file = folder_ / "paint.binary";
    writeFile(file, merlBytes({2, 2, 2}, smooth));
    const SharedTable own = *readTable(file);
    EXPECT_EQ(own->form, TableForm::WithoutGrain);
    const int other = tableNumber(file.string(), TableForm::WithGrain);
    EXPECT_EQ(tableAtHand(other), nullptr);
    EXPECT_EQ((*readTable(other))->form, TableForm::WithGrain);
    EXPECT_EQ(*readTable(file), own);
    EXPECT_NE(tableAtHand(other), nullptr);
    writeFile(file, merlBytes({2, 2, 4}, smooth));
    ASSERT_TRUE(readTable(file));
    EXPECT_EQ(tableAtHand(other), nullptr); // it was of the file before
}

TEST_F(Measured, UnreadableFile_HasATableOfItsOwnColour) {
    writeFile(folder_ / "text.binary", "this is no measured surface at all");
    const auto text = readTable(folder_ / "text.binary");
    ASSERT_FALSE(text);
    EXPECT_NE(text.error().text().find("byte 0: the file begins with text"), std::string::npos);
    const SharedTable table =
        keptTable(tableNumber((folder_ / "text.binary").string(), TableForm::WithoutGrain));
    EXPECT_GT(table->texels.front().x, table->texels.front().y);
}

TEST_F(Measured, Table_IsAtHandOnceItWasReadAndIsReadAgainWhenItsFileChanged) {
    const std::filesystem::path file = folder_ / "paint.binary";
    const int number = tableNumber(file.string(), TableForm::WithoutGrain);
    writeFile(file, merlBytes({2, 2, 2}, smooth));
    EXPECT_EQ(tableAtHand(number), nullptr);
    const SharedTable first = keptTable(number);
    EXPECT_EQ(tableAtHand(number), first);
    const unsigned version = keptTablesVersion();
    EXPECT_EQ(*readTable(file), first);
    EXPECT_EQ(keptTablesVersion(), version);
    writeFile(file, merlBytes({2, 2, 4}, smooth));
    ASSERT_TRUE(readTable(file));
    EXPECT_EQ(tableAtHand(number)->bins.x, 4);
    EXPECT_NE(keptTablesVersion(), version);
}

TEST_F(Measured, TableTooLongForAGraphicsCard_IsRefused) {
    writeFile(folder_ / "long.binary", merlBytes({1, 1, 2049}, smooth));
    const auto table = readTable(folder_ / "long.binary");
    ASSERT_FALSE(table);
    EXPECT_NE(table.error().text().find("1 x 1 x 2049"), std::string::npos);
}

TEST_F(Measured, MerlFile_IsNearBetweenTheBins) {
    const auto reading = read(merlBytes({90, 90, 180}, smooth));
    ASSERT_TRUE(reading);
    for (const double theta : {0.1, 0.4, 0.9, 1.2}) {
        const DirectionPair pair{{std::sin(theta), 0.0, std::cos(theta)},
                                 glm::normalize(glm::dvec3(-0.3, 0.5, 0.8))};
        EXPECT_LT(glm::length((*reading)->evaluate(pair) - smooth(pair)),
                  0.01 * glm::length(smooth(pair)));
        EXPECT_LT(glm::length((*reading)->evaluate({pair.v, pair.l}) - smooth(pair)),
                  0.01 * glm::length(smooth(pair)));
    }
}

TEST_F(Measured, MerlValuesBelowZero_WereNotMeasured) {
    const auto reading = read(merlBytes({8, 8, 16}, [](const DirectionPair& pair) {
        return pair.l.z > 0.6 ? smooth(pair) : glm::dvec3(-1.0);
    }));
    ASSERT_TRUE(reading);
    for (const DirectionPair& pair : (*reading)->samples(1000)) {
        EXPECT_GT(pair.l.z, 0.6);
    }
}

/// Returns the share of a file's samples whose half vector is within 20 degrees of the normal.
double nearNormal(const MeasuredReflectance& measured) {
    const std::vector<DirectionPair> samples = measured.samples(2000);
    const auto isNear = [](const DirectionPair& pair) {
        return halfDifference(pair).half < pi / 9.0;
    };
    return double(std::ranges::count_if(samples, isNear)) / double(samples.size());
}

TEST_F(Measured, SamplesOfANarrowHighlight_AreNoDenserThereInAFileWhoseGridIs) {
    const auto narrow = [](const DirectionPair& pair) {
        const glm::dvec3 h = glm::normalize(pair.l + pair.v);
        return glm::dvec3(0.1 + std::exp(-200.0 * (1.0 - h.z)));
    };
    const auto merl = read(merlBytes({30, 30, 60}, narrow));
    ASSERT_TRUE(merl);
    const double share = nearNormal(**merl);
    const auto rgl = read(RglFile{}.bytes(narrow));
    ASSERT_TRUE(rgl);
    EXPECT_NEAR(nearNormal(**rgl), share, 0.1);
}

TEST_F(Measured, RglFile_IsReadBackAsItWasWritten) {
    const auto reading = read(RglFile{}.bytes(smooth));
    ASSERT_TRUE(reading) << reading.error().text();
    EXPECT_TRUE((*reading)->isIsotropic());
    EXPECT_GT((*reading)->samples(500).size(), 200u);
    EXPECT_LT(largestError(**reading, smooth), 1e-4);
}

TEST_F(Measured, AnisotropicRglFile_IsReadBackAsItWasWritten) {
    const auto brushed = [](const DirectionPair& pair) {
        const glm::dvec3 h = glm::normalize(pair.l + pair.v);
        return glm::dvec3(0.1 + std::exp(-3.0 * h.x * h.x - 20.0 * h.y * h.y));
    };
    const auto reading = read(RglFile{.azimuths = 9}.bytes(brushed));
    ASSERT_TRUE(reading) << reading.error().text();
    EXPECT_FALSE((*reading)->isIsotropic());
    EXPECT_LT(largestError(**reading, brushed), 1e-4);
}

TEST_F(Measured, SpectralRglFile_HasTheColourThatTheSpectrumIs) {
    const auto reading = read(RglFile{.isSpectral = true}.bytes(
        [](const DirectionPair& pair) { return glm::dvec3(smooth(pair).x); }));
    ASSERT_TRUE(reading) << reading.error().text();
    EXPECT_LT(largestError(**reading,
                           [](const DirectionPair& pair) { return glm::dvec3(smooth(pair).x); }),
              1e-4);
}

TEST(SpectrumColor, SpectrumOfOnes_IsWhite) {
    std::vector<float> wavelengths;
    for (float nm = 360.0f; nm <= 1000.0f; nm += 5.0f) {
        wavelengths.push_back(nm);
    }
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& weight : spectrumWeights(wavelengths)) {
        sum += weight;
    }
    EXPECT_NEAR(sum.r, 1.0, 1e-3);
    EXPECT_NEAR(sum.g, 1.0, 1e-3);
    EXPECT_NEAR(sum.b, 1.0, 1e-3);
}

TEST_F(Measured, GrazingAndHiddenDirections_AreFiniteAndNotNegative) {
    const auto merl = read(merlBytes({8, 8, 16}, smooth));
    const auto rgl = read(RglFile{}.bytes(smooth));
    for (const double z : {0.0, -0.5, 1e-300, 1e-9, 1.0}) {
        const DirectionPair pair{{std::sqrt(1.0 - z * z), 0.0, z}, {0.0, 0.0, 1.0}};
        for (const auto& measured : {*merl, *rgl}) {
            const glm::dvec3 value = measured->evaluate(pair);
            for (int c = 0; c < 3; ++c) {
                EXPECT_TRUE(std::isfinite(value[c]) && value[c] >= 0.0) << z;
            }
        }
    }
}

TEST_F(Measured, DamagedFiles_EndInAMessageWithThePlace) {
    const std::string merl = merlBytes({8, 8, 16}, smooth);
    EXPECT_NE(problemOf("").find("byte 0"), std::string::npos);
    EXPECT_NE(problemOf(merl.substr(0, 6)).find("byte 6"), std::string::npos);
    EXPECT_NE(problemOf("plain text that is no file of numbers").find("byte 0"), std::string::npos);
    EXPECT_NE(problemOf(merl.substr(0, 1000)).find("byte 1000: "), std::string::npos);
    std::string broken = merl;
    const double none = std::numeric_limits<double>::quiet_NaN();
    std::memcpy(broken.data() + 12 + 8 * 5, &none, sizeof none);
    EXPECT_NE(problemOf(broken).find("byte 52"), std::string::npos) << problemOf(broken);
    const std::string rgl = RglFile{}.bytes(smooth);
    for (std::size_t length = 13; length < rgl.size(); length += rgl.size() / 37) {
        EXPECT_NE(problemOf(rgl.substr(0, length)), "") << length;
    }
    for (std::size_t place = 12; place < 400; ++place) { // every byte of the descriptions
        std::string changed = rgl;
        changed[place] = static_cast<char>(changed[place] ^ 0x5a);
        (void)read(changed); // an error or another reading, but no crash
    }
}

TEST_F(Measured, WrongNumberInAnRglFile_IsToldWithItsByte) {
    const std::string rgl = RglFile{}.bytes(smooth);
    const auto placeOf = [&rgl](const std::string& name) { // of the array's offset in the header
        std::uint64_t offset = 0;
        std::memcpy(&offset, rgl.data() + rgl.find(name) + name.size() + 3, sizeof offset);
        return static_cast<std::size_t>(offset);
    };
    for (const auto& [name, value] :
         {std::pair{"vndf", -1.0f}, std::pair{"ndf", -0.5f}, std::pair{"theta_i", 9.0f},
          std::pair{"rgb", -500.0f}, std::pair{"rgb", std::numeric_limits<float>::quiet_NaN()}}) {
        std::string broken = rgl;
        const std::size_t place = placeOf(name);
        std::memcpy(broken.data() + place, &value, sizeof value);
        EXPECT_NE(problemOf(broken).find(fmt::format("byte {}: \"{}\"", place, name)),
                  std::string::npos)
            << name << ": " << problemOf(broken);
    }
}

TEST_F(Measured, RglArrayOfNothingOrOfAnotherType_IsToldWithItsByte) {
    const std::string rgl = RglFile{}.bytes(smooth);
    const std::size_t type = rgl.find("ndf") + 3 + sizeof(std::uint16_t);
    std::string doubles = rgl;
    doubles[type] = 11;
    EXPECT_NE(problemOf(doubles).find(fmt::format("byte {}: \"ndf\" is of float64", type)),
              std::string::npos)
        << problemOf(doubles);
    std::uint64_t offset = 0;
    std::memcpy(&offset, rgl.data() + type + 1, sizeof offset);
    std::uint64_t rows = 0;
    std::uint64_t columns = 0;
    std::memcpy(&rows, rgl.data() + type + 9, sizeof rows);
    std::memcpy(&columns, rgl.data() + type + 17, sizeof columns);
    std::string empty = rgl;
    std::memset(empty.data() + offset, 0, rows * columns * sizeof(float));
    EXPECT_NE(problemOf(empty).find(fmt::format("byte {}: \"ndf\" is 0 everywhere", offset)),
              std::string::npos)
        << problemOf(empty);
    std::string far = rgl;
    std::memset(far.data() + type + 1, 0xff, sizeof offset);
    EXPECT_NE(problemOf(far).find(fmt::format("byte {}: \"ndf\" begins behind the end", type + 1)),
              std::string::npos)
        << problemOf(far);
}

TEST_F(Measured, FileOfTenGigabytesOfNothing_IsRefused) {
    const auto file = folder_ / "huge.binary";
    writeFile(file, "x");
    std::filesystem::resize_file(file, std::uintmax_t(10) << 30);
    const auto reading = readMeasured(file);
    ASSERT_FALSE(reading);
    EXPECT_NE(reading.error().text().find("1 GiB"), std::string::npos) << reading.error().text();
}

glm::dvec3 sumOf(const std::vector<WavelengthShare>& all, double (*light)(double)) {
    glm::dvec3 sum(0.0);
    for (const WavelengthShare& each : all) {
        sum += light(each.wavelength) * each.shares;
    }
    return sum;
}

TEST(WavelengthShares, OfEachChannel_AddUpToOneAndAreNotNegative) {
    for (int count = 1; count <= 100; ++count) {
        const std::vector<WavelengthShare> all = wavelengthShares(count);
        ASSERT_EQ(all.size(), static_cast<std::size_t>(count));
        const glm::dvec3 sum = sumOf(all, [](double) { return 1.0; });
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(sum[channel], 1.0, 1e-12) << count;
        }
        double last = 380.0;
        for (const WavelengthShare& each : all) {
            EXPECT_GT(each.wavelength, last) << count;
            EXPECT_LT(each.wavelength, 730.0) << count;
            EXPECT_TRUE(each.shares.x >= 0.0 && each.shares.y >= 0.0 && each.shares.z >= 0.0);
            last = each.wavelength;
        }
    }
}

TEST(WavelengthShares, OutsideTheirRange_AreThoseAtItsEnds) {
    EXPECT_EQ(wavelengthShares(-3), wavelengthShares(1));
    EXPECT_EQ(wavelengthShares(1000), wavelengthShares(100));
}

/// What is nearest to a wavelength has its mean there, so that light which changes evenly over the
/// spectrum is right in the sum of the channels, whatever the number.
TEST(WavelengthShares, OfLightThatChangesEvenly_AreExactInAll) {
    const auto evenly = [](double wavelength) { return wavelength; };
    const glm::dvec3 right = sumOf(wavelengthShares(100), evenly);
    for (const int count : {1, 3, 5, 9, 15, 63}) {
        const glm::dvec3 sum = sumOf(wavelengthShares(count), evenly);
        EXPECT_NEAR(sum.x + sum.y + sum.z, right.x + right.y + right.z, 1e-6) << count;
    }
}

/// A rainbow's edge, which is sharp, and light that comes and goes every 120 nm.
TEST(WavelengthShares, OfMoreWavelengths_AreNearerToAllLight) {
    double last = 1.0;
    for (const int count : {3, 5, 9, 15, 63}) {
        double worst = 0.0;
        const std::vector<WavelengthShare> few = wavelengthShares(count);
        const std::vector<WavelengthShare> many = wavelengthShares(100);
        for (int i = 0; i < 24; ++i) {
            glm::dvec3 error(0.0);
            for (const auto& [all, side] : {std::pair{&few, 1.0}, std::pair{&many, -1.0}}) {
                for (const WavelengthShare& each : *all) {
                    const double turn = each.wavelength / 120.0 + i / 24.0;
                    error += side * std::sin(2.0 * std::numbers::pi * turn) * each.shares;
                }
            }
            worst = std::max({worst, std::abs(error.x), std::abs(error.y), std::abs(error.z)});
        }
        EXPECT_LT(worst, last) << count;
        last = worst;
    }
    EXPECT_LT(last, 1e-3);
}

/// Returns how far two sets of shares are apart along the spectrum, in nm: the mean over the
/// channels of what would have to be moved how far.
double apart(const std::vector<WavelengthShare>& a, const std::vector<WavelengthShare>& b) {
    const auto until = [](const std::vector<WavelengthShare>& all, double wavelength) {
        glm::dvec3 sum(0.0);
        for (const WavelengthShare& each : all) {
            sum += each.wavelength <= wavelength ? each.shares : glm::dvec3(0.0);
        }
        return sum;
    };
    constexpr double step = 0.25;
    double sum = 0.0;
    for (double wavelength = 380.0; wavelength < 730.0; wavelength += step) {
        const glm::dvec3 off = glm::abs(until(a, wavelength) - until(b, wavelength));
        sum += (off.x + off.y + off.z) / 3.0 * step;
    }
    return sum;
}

/// What the levels of blocks say.
TEST(WavelengthShares, OfEachLevel_AreAsFarOffAsItSays) {
    const std::vector<WavelengthShare> many = wavelengthShares(100);
    for (const auto& [count, said] :
         {std::pair(15, 4.0), std::pair(9, 7.0), std::pair(5, 12.0), std::pair(3, 19.0)}) {
        EXPECT_NEAR(apart(wavelengthShares(count), many), said, 0.6) << count;
    }
}

/// Red, green and blue are seen where their names say (CIE 1931 by Wyman, Sloan and Shirley 2013).
TEST(WavelengthShares, OfThree_AreRedGreenAndBlue) {
    const std::vector<WavelengthShare> three = wavelengthShares(3);
    EXPECT_NEAR(three[0].wavelength, 452.0, 5.0);
    EXPECT_NEAR(three[1].wavelength, 540.0, 5.0);
    EXPECT_NEAR(three[2].wavelength, 610.0, 5.0);
    EXPECT_GT(three[0].shares.z, 0.95);
    EXPECT_GT(three[1].shares.y, 0.8);
    EXPECT_GT(three[2].shares.x, 0.8);
}

} // namespace
} // namespace patina::measured_test
