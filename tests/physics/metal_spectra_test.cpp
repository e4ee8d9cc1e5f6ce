// SPDX-License-Identifier: GPL-3.0-or-later
// Metals by name against the measurements that they are taken from, and against mirrors of them.
#include <gtest/gtest.h>

#include <complex>

#include "catalog/fills.h"
#include "catalog/spectrum.h"
#include "physics_cases.h"

namespace patina::physics::metal_spectra_test {
namespace {

/// Is the index and the absorption at a wavelength in nm.
struct Measured {
    double nm;
    double n;
    double k;
};

Measured constantsAt(const std::string& metal, double nm) {
    const Parameter& metals = *catalog().find("fresnel", "metal")->parameter("metal");
    const EnumValue* choice = spectralChoice(metals, {{"metal", metal}});
    if (choice == nullptr) {
        throw std::runtime_error("no metal " + metal);
    }
    const auto at = [&](const char* id) {
        return atWavelengths(*spectrumIn(choice->fills.at(id)), glm::dvec3(nm)).x;
    };
    return {nm, at("eta"), at("k")};
}

void expectMeasured(const std::string& metal, const std::vector<Measured>& published) {
    for (const Measured& at : published) {
        const Measured found = constantsAt(metal, at.nm);
        EXPECT_NEAR(found.n, at.n, 1e-5) << metal << ' ' << at.nm;
        EXPECT_NEAR(found.k, at.k, 1e-5) << metal << ' ' << at.nm;
    }
}

/// P. B. Johnson and R. W. Christy, Phys. Rev. B 6, 1972, at 3.00, 2.50, 2.26, 2.01 and 1.76 eV.
TEST(MetalSpectra, OfNobleMetals_AreTheMeasuredNumbers) {
    expectMeasured("gold", {{413.3, 1.46, 1.958},
                            {495.9, 1.04, 1.833},
                            {548.6, 0.43, 2.455},
                            {616.8, 0.21, 3.272},
                            {704.5, 0.13, 4.103}});
    expectMeasured("silver", {{413.3, 0.05, 2.275},
                              {495.9, 0.05, 3.093},
                              {548.6, 0.06, 3.586},
                              {616.8, 0.06, 4.152},
                              {704.5, 0.04, 4.838}});
    expectMeasured("copper", {{413.3, 1.28, 2.207},
                              {495.9, 1.22, 2.564},
                              {548.6, 1.02, 2.577},
                              {616.8, 0.30, 3.205},
                              {704.5, 0.21, 4.205}});
}

/// P. B. Johnson and R. W. Christy, Phys. Rev. B 9, 1974, at 2.50 and 2.01 eV.
TEST(MetalSpectra, OfTransitionMetals_AreTheMeasuredNumbers) {
    expectMeasured("iron", {{496.0, 2.74, 2.88}, {617.0, 2.88, 3.05}});
    expectMeasured("chromium", {{496.0, 2.75, 3.30}, {617.0, 3.17, 3.30}});
    expectMeasured("nickel", {{496.0, 1.82, 3.25}, {617.0, 1.99, 4.02}});
    expectMeasured("titanium", {{496.0, 2.36, 3.19}, {617.0, 2.67, 3.72}});
    expectMeasured("cobalt", {{496.0, 1.88, 3.55}, {617.0, 2.19, 4.11}});
    expectMeasured("palladium", {{496.0, 1.52, 3.54}, {617.0, 1.75, 4.21}});
}

/// A. D. Rakić, Appl. Opt. 34, 1995; M. R. Querry, CRDC-CR-85034, 1985.
TEST(MetalSpectra, OfAluminiumAndBrass_AreTheMeasuredNumbers) {
    expectMeasured("aluminium", {{476.87, 0.7278, 5.7781}, {619.93, 1.366, 7.4052}});
    expectMeasured("brass", {{460.0, 0.994, 1.883}, {540.0, 0.549, 2.668}, {620.0, 0.449, 3.434}});
}

/// Is an oscillator of the Lorentz-Drude model: its strength, its damping and its energy in eV.
struct Oscillator {
    double strength;
    double damping;
    double energy;
};

/// epsilon = 1 + sum of f wp^2 / (w0^2 - w^2 - i w g); the first is that of free electrons
/// (A. D. Rakić, A. B. Djurišić, J. M. Elazar and M. L. Majewski, Appl. Opt. 37, 1998).
Measured lorentzDrude(double plasma, const std::vector<Oscillator>& oscillators, double nm) {
    const double w = 1239.8419843 / nm;
    std::complex<double> permittivity = 1.0;
    for (const Oscillator& o : oscillators) {
        permittivity += o.strength * plasma * plasma /
                        std::complex(o.energy * o.energy - w * w, -w * o.damping);
    }
    const std::complex<double> index = std::sqrt(permittivity);
    return {nm, index.real(), index.imag()};
}

TEST(MetalSpectra, OfPlatinumAndTungsten_AreThePublishedFit) {
    for (const double nm : {300.0, 450.0, 550.0, 600.0, 1100.0}) {
        expectMeasured("platinum", {lorentzDrude(9.59,
                                                 {{0.333, 0.080, 0.0},
                                                  {0.191, 0.517, 0.780},
                                                  {0.659, 1.838, 1.314},
                                                  {0.547, 3.668, 3.141},
                                                  {3.576, 8.517, 9.249}},
                                                 nm)});
        expectMeasured("tungsten", {lorentzDrude(13.22,
                                                 {{0.206, 0.064, 0.0},
                                                  {0.054, 0.530, 1.004},
                                                  {0.166, 1.281, 1.917},
                                                  {0.706, 3.332, 3.580},
                                                  {2.590, 5.836, 7.498}},
                                                 nm)});
    }
}

double mirrored(const std::string& metal, double nm) {
    const Measured at = constantsAt(metal, nm);
    const Subject subject(
        "fresnel", "metal",
        {{"metal", std::string("custom")}, {"eta", glm::dvec3(at.n)}, {"k", glm::dvec3(at.k)}});
    return subject.reflectance(1.0);
}

/// What freshly evaporated films mirror facing them at 400, 450 .. 700 nm (G. Hass and L. Hadley,
/// American Institute of Physics Handbook, 3rd edition, 1972, section 6g). Copper's edge, at 600
/// nm, is the one place where Johnson and Christy's films mirror much less than these.
TEST(MetalSpectra, OfMirrors_ReflectWhatWasPublished) {
    constexpr double aluminium[] = {0.924, 0.922, 0.918, 0.915, 0.911, 0.905, 0.897};
    constexpr double silver[] = {0.956, 0.971, 0.979, 0.983, 0.986, 0.988, 0.989};
    constexpr double gold[] = {0.387, 0.387, 0.477, 0.817, 0.919, 0.955, 0.970};
    constexpr double copper[] = {0.475, 0.552, 0.600, 0.669, 0.933, 0.966, 0.975};
    for (int i = 0; i < 7; ++i) {
        const double nm = 400.0 + 50.0 * i;
        EXPECT_NEAR(mirrored("aluminium", nm), aluminium[i], 0.002) << nm;
        EXPECT_NEAR(mirrored("silver", nm), silver[i], 0.01) << nm;
        EXPECT_NEAR(mirrored("gold", nm), gold[i], 0.03) << nm;
        EXPECT_NEAR(mirrored("copper", nm), copper[i], nm == 600.0 ? 0.12 : 0.05) << nm;
    }
}

/// Returns how much brighter a level is than the exact one at most, and how much darker.
std::pair<double, double> errorsOf(const Values& metal, const char* level, double outside) {
    Values values = metal;
    values["index.outside"] = outside;
    const Subject exact("fresnel", "metal", values);
    const Subject cheaper("fresnel", "metal", values, {{"reflectance", level}});
    double brighter = 0.0;
    double darker = 0.0;
    for (int i = 0; i <= 500; ++i) {
        const double c = i / 500.0;
        const glm::dvec3 off = cheaper.code->fresnel(c, 1.0 - c, cheaper.parameters) -
                               exact.code->fresnel(c, 1.0 - c, exact.parameters);
        brighter = std::max({brighter, off.x, off.y, off.z});
        darker = std::max({darker, -off.x, -off.y, -off.z});
    }
    return {brighter, darker};
}

TEST(MetalSpectra, CheaperLevels_AreAsFarOffAsTheirLabelsSay) {
    const Block& block = *catalog().find("fresnel", "metal");
    const Parameter& metals = *block.parameter("metal");
    double highIndex = 0.0;
    double underLacquer = 0.0;
    for (const EnumValue& metal : metals.values) {
        const Values values = afterEdit(block, defaultValues(block), metals, metal.id);
        const auto [above, below] = errorsOf(values, "table", 1.0);
        EXPECT_LT(std::max(above, below), 2.1e-4) << metal.id;
        highIndex = std::max(highIndex, errorsOf(values, "high-index", 1.0).first);
        underLacquer = std::max(underLacquer, errorsOf(values, "high-index", 1.5).second);
        const double schlick = errorsOf(values, "schlick", 1.0).second;
        const double said = metal.id == "silver" ? 0.007 : metal.id == "gold" ? 0.02 : 0.215;
        EXPECT_LT(schlick, said) << metal.id;
    }
    EXPECT_NEAR(highIndex, 0.0071, 1e-4);
    EXPECT_NEAR(underLacquer, 0.026, 1e-3);
}

/// At every angle it is the exact term of the same index and absorption.
TEST(MetalSpectra, ByName_AreTheConductorOfTheirNumbers) {
    const Subject named("fresnel", "metal");
    const Values numbers = defaultValues(*named.block);
    const Subject typed("fresnel", "conductor",
                        {{"eta", numbers.at("eta")}, {"k", numbers.at("k")}});
    for (const double c : {0.0, 1e-6, 0.1, 0.5, 1.0}) {
        EXPECT_EQ(named.code->fresnel(c, 1.0 - c, named.parameters),
                  typed.code->fresnel(c, 1.0 - c, typed.parameters))
            << c;
    }
}

} // namespace
} // namespace patina::physics::metal_spectra_test
