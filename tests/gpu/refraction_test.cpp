// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of clear bodies against rays that are followed in double precision.
#include <algorithm>
#include <map>

#include "catalog/parameter_layout.h"
#include "measured/spectrum_color.h"
#include "reference/reference.h"
#include "refraction_fixture.h"
#include "shading/effects/surface_program.h"

namespace patina::refraction_test {
namespace {

/// A ray at a surface, as in a textbook: n on the side it comes from, eta the index beyond.
struct Split {
    glm::dvec3 onwards{0.0};
    glm::dvec3 mirrored{0.0};
    double share = 1.0; ///< that is mirrored
};

Split split(const glm::dvec3& d, const glm::dvec3& n, double eta) {
    Split out;
    const double in = std::acos(std::clamp(-glm::dot(d, n), 0.0, 1.0));
    out.mirrored = glm::reflect(d, n);
    const double sine = std::sin(in) / eta;
    if (sine < 1.0) {
        const double beyond = std::asin(sine);
        const double across =
            (std::cos(in) - eta * std::cos(beyond)) / (std::cos(in) + eta * std::cos(beyond));
        const double along =
            (eta * std::cos(in) - std::cos(beyond)) / (eta * std::cos(in) + std::cos(beyond));
        out.share = 0.5 * (across * across + along * along);
        out.onwards = (d + (std::cos(in) - eta * std::cos(beyond)) * n) / eta;
    }
    return out;
}

/// What a ray sees of the surroundings through the unit sphere; `miss` where it is not met, or so
/// near its rim that a pixel is not all on it.
constexpr double miss = -1.0;

glm::dvec3 throughBall(const glm::dvec3& origin, const glm::dvec3& d, double index,
                       const glm::dvec3& left) {
    const double b = glm::dot(origin, d);
    const double beside = glm::dot(origin, origin) - b * b;
    if (beside > 0.97 * 0.97) {
        return glm::dvec3(miss);
    }
    const glm::dvec3 n = origin + (-b - std::sqrt(1.0 - beside)) * d;
    const Split in = split(d, n, index);
    const double way = -2.0 * glm::dot(n, in.onwards);
    const Split out = split(in.onwards, -(n + way * in.onwards), 1.0 / index);
    const auto light = [](const glm::dvec3& towards) { return 0.5 + 0.4 * towards; };
    const glm::dvec3 inside =
        out.share * light(out.mirrored) + (1.0 - out.share) * light(out.onwards);
    return in.share * light(in.mirrored) +
           (1.0 - in.share) * inside * glm::pow(left, glm::dvec3(way));
}

class RefractionOfABall : public RefractionTest {
  protected:
    struct Errors {
        double largest = 0.0;
        double meanSquare = 0.0;
        int pixels = 0;
    };

    /// Pixel by pixel against the exact rays.
    Errors errors(double index, int size, const glm::dvec3& left = glm::dvec3(1.0)) {
        scene_.objects = {clear("ball", "solid-body", index)};
        set(scene_.objects[0], "absorption.color", left);
        surround(false);
        const Image image = drawn(size);
        Errors found;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 exact =
                    throughBall(eye(scene_.camera), rayThrough(x, y, size), index, left);
                if (exact.x != miss) {
                    add(found, glm::dvec3(pixel(image, x, y)) - exact);
                }
            }
        }
        found.meanSquare /= std::max(found.pixels, 1);
        return found;
    }

  private:
    static void add(Errors& errors, const glm::dvec3& error) {
        ++errors.pixels;
        errors.largest =
            std::max({errors.largest, std::abs(error.x), std::abs(error.y), std::abs(error.z)});
        errors.meanSquare += glm::dot(error, error) / 3.0;
    }
};

// The figures that the documentation states.

TEST_F(RefractionOfABall, OfGlass_IsWhatRaysSee) {
    const Errors found = errors(1.5, 129);
    EXPECT_GT(found.pixels, 5000);
    EXPECT_LT(std::sqrt(found.meanSquare), 5e-4);
    EXPECT_LT(found.largest, 1e-3);
}

TEST_F(RefractionOfABall, OfDiamond_IsWhatRaysSee) {
    const Errors found = errors(2.417, 129);
    EXPECT_LT(std::sqrt(found.meanSquare), 5e-4);
    EXPECT_LT(found.largest, 1e-3);
}

TEST_F(RefractionOfABall, ThatAbsorbs_DoesSoByTheWayInside) {
    const Errors found = errors(1.333, 129, {0.9, 0.6, 0.2});
    EXPECT_LT(std::sqrt(found.meanSquare), 5e-4);
    EXPECT_LT(found.largest, 1e-3);
}

TEST_F(RefractionOfABall, Lens_TurnsTheSceneRound) {
    scene_.objects = {clear("ball", "solid-body", 1.5), glowing({1.0, 0.0, 0.0}, {-1.0, 0.0, -4.0}),
                      glowing({0.0, 1.0, 0.0}, {1.0, 0.0, -4.0})};
    const Image image = drawn(65);
    EXPECT_GT(pixel(image, 28, 32).g, 0.8f);
    EXPECT_LT(pixel(image, 28, 32).r, 0.1f);
    EXPECT_GT(pixel(image, 36, 32).r, 0.8f);
    EXPECT_LT(pixel(image, 36, 32).g, 0.1f);
}

/// Looks at the edge of a glowing square near the ball, which enlarges it, against the mean of many
/// exact rays of each pixel.
class SilhouettesBehindABall : public RefractionTest {
  protected:
    static constexpr int size = 97;
    static constexpr double index = 1.5;
    static constexpr double turn = 33.0; ///< degrees of the square about the view
    const glm::dvec3 across{std::cos(glm::radians(turn)), std::sin(glm::radians(turn)), 0.0};
    glm::dvec3 square{0.0}; ///< is its middle
    double half = 0.5;
    double reach = 0.7; ///< is how far from the middle of the ball pixels count

    void SetUp() override {
        RefractionTest::SetUp();
        scene_.background = glm::dvec3(0.0);
        place(glm::dvec3(0.0, 0.0, -1.6) + half * across);
    }

    void place(const glm::dvec3& middle) {
        square = middle;
        scene_.objects = {clear("ball", "solid-body", index), glowing({0.0, 1.0, 0.0}, middle)};
        scene_.objects[1].rotation.z = turn;
        scene_.objects[1].scale = glm::dvec3(half);
    }

    /// Returns the root of the mean square error over all pixels that are well on the ball.
    double error(const std::string& level) {
        scene_.objects[0].material.accuracy["silhouettes"] = level;
        const Image image = drawn(size);
        double sum = 0.0;
        int pixels = 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const double exact = exactPixel(x, y);
                if (exact != miss) {
                    const double off = double(pixel(image, x, y).g) - exact;
                    sum += off * off;
                    ++pixels;
                }
            }
        }
        return std::sqrt(sum / std::max(pixels, 1));
    }

  private:
    bool isHit(const glm::dvec3& from, const glm::dvec3& d) const {
        const double t = (square.z - from.z) / d.z;
        const glm::dvec3 at = from + t * d - square;
        return t > 0.0 && std::abs(across.x * at.x + across.y * at.y) < half &&
               std::abs(across.x * at.y - across.y * at.x) < half;
    }

    double exactRay(double x, double y) const {
        const glm::dvec3 origin = eye(scene_.camera);
        const glm::dvec3 d = rayThrough(x, y, size);
        const double b = glm::dot(origin, d);
        const double beside = glm::dot(origin, origin) - b * b;
        if (beside > reach * reach) {
            return miss;
        }
        const glm::dvec3 n = origin + (-b - std::sqrt(1.0 - beside)) * d;
        const Split in = split(d, n, index);
        const glm::dvec3 end = n - 2.0 * glm::dot(n, in.onwards) * in.onwards;
        const Split out = split(in.onwards, -end, 1.0 / index);
        return isHit(end, out.onwards) ? (1.0 - in.share) * (1.0 - out.share) : 0.0;
    }

    double exactPixel(int x, int y) const {
        constexpr int side = 8;
        double sum = 0.0;
        for (int i = 0; i < side * side; ++i) {
            const double ray =
                exactRay(x + (i % side + 0.5) / side - 0.5, y + (i / side + 0.5) / side - 0.5);
            if (ray == miss) {
                return miss;
            }
            sum += ray;
        }
        return sum / (side * side);
    }
};

// The figures that the descriptor states.
TEST_F(SilhouettesBehindABall, OfFourRays_AreNearerToExactOnesThanThoseOfOne) {
    EXPECT_NEAR(error("rays4"), 0.114, 0.005);
    EXPECT_NEAR(error("rays1"), 0.138, 0.005);
}

/// Rays that leave the ball near its rim go far across the picture, and past a thing there for a
/// short way only: it is not passed over.
TEST_F(SilhouettesBehindABall, OfASmallThingFarBehind_AreWhole) {
    reach = 0.95;
    half = 0.12;
    place({-1.0, 0.3, -3.4});
    EXPECT_LT(error("rays4"), 0.014);
    EXPECT_LT(error("rays1"), 0.0175);
}

TEST_F(SilhouettesBehindABall, WithNothingBehind_HasNoProgramOfItsOwn) {
    scene_.objects.resize(1);
    scene_.objects[0].material.accuracy["silhouettes"] = "rays4";
    drawn(9);
    scene_.objects[0].material.accuracy["silhouettes"] = "rays1";
    drawn(9);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(RefractionOfABall, WhatIsInside_IsSeen) {
    scene_.objects = {clear("ball", "solid-body", 1.5), glowing({1.0, 0.0, 0.0}, {0.0, 0.0, 0.0})};
    scene_.objects[1].scale = glm::dvec3(0.3);
    EXPECT_GT(middle(drawn(65)).r, 0.8f);
}

/// Rays that leave the ball's sides graze the floor, whose depth changes there more from pixel to
/// pixel than the rays are away from it.
TEST_F(RefractionOfABall, OverAFloor_HasNoSpecks) {
    scene_.objects = {clear("ball", "solid-body", 1.545), glowing({1.0, 0.0, 0.0}, {0, -1, 0})};
    scene_.objects[1].rotation = glm::dvec3(0.0);
    scene_.objects[1].scale = glm::dvec3(200.0);
    scene_.background = glm::dvec3(0.0);
    scene_.camera.pitch = 10.0;
    const Image image = drawn(129);
    const auto isRed = [&image](int x, int y) { return pixel(image, x, y).r > 0.4f; };
    int red = 0;
    int specks = 0;
    for (int y = 1; y < 128; ++y) {
        for (int x = 1; x < 128; ++x) {
            const int alike = (isRed(x - 1, y) == isRed(x, y)) + (isRed(x + 1, y) == isRed(x, y)) +
                              (isRed(x, y - 1) == isRed(x, y)) + (isRed(x, y + 1) == isRed(x, y));
            red += isRed(x, y) ? 1 : 0;
            specks += alike == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(red, 4000);
    EXPECT_LT(red, 12000);
    EXPECT_EQ(specks, 0);
}

TEST_F(RefractionOfABall, WithDispersion_HasColoursOfItsOwn) {
    scene_.objects = {clear("ball", "solid-body", 1.5)};
    surround(false);
    const Image plain = drawn(65);
    set(scene_.objects[0], "dispersion", 1.0);
    const Image fringed = drawn(65);
    const glm::vec3 before = pixel(plain, 16, 16);
    const glm::vec3 after = pixel(fringed, 16, 16);
    EXPECT_GT(std::abs(after.b - before.b), 2.0f * std::abs(after.g - before.g));
    EXPECT_GT(std::abs(after.b - before.b), 5e-3f);
}

/// Light of many wavelengths is the sum of pictures that are of one each, and so are the levels.
class WavelengthsOfABall : public RefractionTest {
  protected:
    static constexpr double index = 1.6;
    static constexpr double dispersion = 2.0;

    void SetUp() override {
        RefractionTest::SetUp();
        scene_.setPart(kinds::environment, block("environment", "strip-lights"));
        scene_.objects = {clear("sphere", "solid-body", index)};
    }

    /// Returns a pixel's mean error against so many pictures of one wavelength each.
    double error(const Image& picture, int count) {
        const auto found = sums_.find(count);
        const std::vector<double>& sum = found != sums_.end() ? found->second : sumOf(count);
        double error = 0.0;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            error += std::abs(double(picture.pixels[i]) - sum[i]);
        }
        return error / double(sum.size());
    }

    Image of(const std::string& level) {
        set(scene_.objects[0], "index", index);
        set(scene_.objects[0], "dispersion", dispersion);
        scene_.objects[0].material.accuracy["wavelengths"] = level;
        return drawn(size);
    }

  private:
    static constexpr int size = 17;

    const std::vector<double>& sumOf(int count) {
        std::vector<double>& sum = sums_[count];
        set(scene_.objects[0], "dispersion", 0.0);
        for (const WavelengthShare& each : wavelengthShares(count)) {
            // Cauchy's two terms through the lines F and C, 20 over the dispersion apart.
            const auto square = [](double length) { return 1.0 / (length * length); };
            const double spread =
                0.05 * dispersion * (index - 1.0) / (square(0.4861) - square(0.6563));
            set(scene_.objects[0], "index",
                index + spread * (square(0.001 * each.wavelength) - square(0.5876)));
            const Image one = drawn(size);
            sum.resize(one.pixels.size());
            for (std::size_t i = 0; i < one.pixels.size(); ++i) {
                const double share = i % 4 < 3 ? each.shares[static_cast<int>(i % 4)] : 1.0 / count;
                sum[i] += share * double(one.pixels[i]);
            }
        }
        return sum;
    }

    std::map<int, std::vector<double>> sums_;
};

TEST_F(WavelengthsOfABall, OfEachLevel_AreTheSumOfTheirPicturesAndNearerToAll) {
    double last = 1.0;
    for (const int count : {3, 5, 9, 15}) {
        const Image picture = of(std::to_string(count));
        EXPECT_LT(error(picture, count), 2e-4) << count;
        const double fromAll = error(picture, 30);
        EXPECT_LT(fromAll, last) << count;
        last = fromAll;
    }
}

/// Cauchy's two constants are an index and a dispersion.
TEST_F(WavelengthsOfABall, ByTheConstantsOfTheFresnelTerm_AreThoseOfItsIndexAndDispersion) {
    const auto square = [](double length) { return 1.0 / (length * length); };
    const double b = 0.05 * dispersion * (index - 1.0) / (square(0.4861) - square(0.6563));
    const Image own = of("5");
    BlockValues& term = scene_.objects[0].material.parts["fresnel"];
    term = block("fresnel", "dispersive");
    term.parameters["formula"] = std::string("cauchy");
    term.parameters["cauchy"] = glm::dvec3(index - b * square(0.5876) - 0.001, b, 0.0);
    term.parameters["temperature.slope"] = 1e-5;
    term.parameters["temperature.measured"] = 20.0;
    term.parameters["temperature"] = 120.0; // + 0.001
    set(scene_.objects[0], "index.from", std::string("surface"));
    set(scene_.objects[0], "index", 1.2);
    set(scene_.objects[0], "dispersion", 0.0);
    scene_.objects[0].material.accuracy["wavelengths"] = "5";
    const Image picture = drawn(17);
    for (std::size_t i = 0; i < own.pixels.size(); ++i) {
        EXPECT_NEAR(picture.pixels[i], own.pixels[i], 1e-4f) << i;
    }
}

class RefractionOfAPane : public RefractionTest {};

TEST_F(RefractionOfAPane, Tilted_ShiftsWhatIsBehind) {
    constexpr int size = 257;
    constexpr double thickness = 0.8;
    scene_.objects = {glowing(glm::dvec3(1.0), {1.0, 0.0, -2.0}), clear("plane", "thin-pane", 1.5)};
    scene_.objects[1].rotation = {90.0, 40.0, 0.0};
    const auto edge = [&] {
        const Image image = drawn(size);
        int x = 0;
        while (x < size - 1 && pixel(image, x, size / 2).r < 0.6f) {
            ++x;
        }
        return x;
    };
    set(scene_.objects[1], "thickness", 0.0);
    const int before = edge();
    set(scene_.objects[1], "thickness", thickness);
    const int after = edge();
    // t sin(i) (1 - cos(i) / (n cos(o))), across the view, at the edge's distance of 6 m.
    const double in = glm::radians(40.0);
    const double out = std::asin(std::sin(in) / 1.5);
    const double shift = thickness * std::sin(in) * (1.0 - std::cos(in) / (1.5 * std::cos(out)));
    const double pixels =
        shift / (6.0 * std::tan(0.5 * glm::radians(scene_.camera.fieldOfView))) * 0.5 * size;
    EXPECT_NEAR(std::abs(after - before), pixels, 1.0);
}

TEST_F(RefractionOfAPane, OfAirUnderWater_MirrorsAllBeyondTheCriticalAngle) {
    scene_.objects = {clear("plane", "thin-pane", 0.75)};
    scene_.objects[0].rotation = {90.0, 60.0, 0.0}; // the critical angle is 48.6 degrees
    surround(false);
    const glm::dvec3 n(std::sin(glm::radians(60.0)), 0.0, std::cos(glm::radians(60.0)));
    const glm::dvec3 exact = smooth(glm::reflect(glm::dvec3(0.0, 0.0, -1.0), n));
    EXPECT_LT(glm::distance(glm::dvec3(middle(drawn(33))), exact), 2e-3);
}

TEST_F(RefractionOfAPane, OfIndexOne_IsAFilter) {
    scene_.objects = {clear("plane", "thin-pane", 1.0), glowing({1.0, 0.5, 0.25}, {0, 0, -1})};
    scene_.objects[0].rotation.x = 90.0;
    set(scene_.objects[0], "tint", glm::dvec3(0.5, 1.0, 0.5));
    EXPECT_LT(glm::distance(middle(drawn(33)), glm::vec3(0.5f, 0.5f, 0.125f)), 1e-3f);
}

TEST_F(RefractionOfAPane, Opacity_MixesTheSurfaceIn) {
    scene_.objects = {clear("plane", "thin-pane", 1.0)};
    scene_.objects[0].rotation.x = 90.0;
    scene_.objects[0].material.opacity = 0.25;
    scene_.objects[0].material.model.parameters["emissive.color"] = glm::dvec3(1.0, 0.0, 0.0);
    set(scene_.objects[0], "tint", glm::dvec3(0.5));
    const glm::vec3 expected(0.25f + 0.75f * 0.125f, 0.75f * 0.25f, 0.75f * 0.0625f);
    EXPECT_LT(glm::distance(middle(drawn(33)), expected), 1e-3f);
}

class Refraction : public RefractionTest {};

/// Bodies whose Fresnel term decides what they mirror.
class MirroredByATerm : public RefractionTest {
  protected:
    /// Makes a body of which a white square is seen, with a film of magnesium fluoride on it.
    void coat(const std::string& mesh, const std::string& kind, double thickness) {
        scene_.background = glm::dvec3(0.0);
        scene_.objects = {clear(mesh, kind, 1.2), glowing(glm::dvec3(1.0), {0.0, 0.0, -2.0})};
        scene_.objects[0].rotation.x = mesh == "plane" ? 90.0 : 0.0;
        set(scene_.objects[0], "index.from", std::string("surface"));
        BlockValues& term = scene_.objects[0].material.parts["fresnel"];
        term = block("fresnel", "thin-film");
        term.parameters["film.thickness"] = thickness;
    }

    /// Returns what the film mirrors facing the light.
    glm::dvec3 facing() const {
        const BlockValues& term = *scene_.objects[0].material.part("fresnel");
        const Block& film = *catalog->find("fresnel", term.id);
        return reference::findBlock("fresnel", term.id)
            ->fresnel(1.0, 0.0, packed(film, term.parameters, {}));
    }
};

/// Four per cent of each face of bare glass become one of coated glass.
TEST_F(MirroredByATerm, ABall_TransmitsWhatItsFilmDoesTwice) {
    for (const double thickness : {0.0, 549.1 / (4.0 * 1.38), 250.0}) {
        coat("ball", "solid-body", thickness);
        const glm::dvec3 left = 1.0 - facing();
        const glm::dvec3 seen(middle(drawn(33)));
        EXPECT_LT(glm::distance(seen, left * left), 1e-3) << thickness;
    }
    coat("ball", "solid-body", 549.1 / (4.0 * 1.38));
    EXPECT_GT(middle(drawn(33)).g, 0.97f);
}

TEST_F(MirroredByATerm, APane_TransmitsWhatBothItsFacesDo) {
    for (const double thickness : {0.0, 549.1 / (4.0 * 1.38), 250.0}) {
        coat("plane", "thin-pane", thickness);
        const glm::dvec3 share = facing();
        const glm::dvec3 seen(middle(drawn(33)));
        EXPECT_LT(glm::distance(seen, 1.0 - 2.0 * share / (1.0 + share)), 1e-3) << thickness;
    }
}

TEST_F(MirroredByATerm, InWhiteSurroundings_IsWhite) {
    surround(true);
    for (const char* fresnel : {"thin-film", "schlick", "empirical", "constant"}) {
        for (const double dispersion : {0.0, 1.0}) {
            scene_.objects = {clear("sphere", "solid-body", 1.5)};
            set(scene_.objects[0], "index.from", std::string("surface"));
            set(scene_.objects[0], "dispersion", dispersion);
            BlockValues& term = scene_.objects[0].material.parts["fresnel"];
            term = block("fresnel", fresnel);
            if (const Parameter* f0 = catalog->find("fresnel", fresnel)->withRole(roles::f0)) {
                term.parameters[f0->id] = glm::dvec3(0.1, 0.2, 0.3);
            }
            scene_.objects[0].material.accuracy["wavelengths"] = "3";
            for (const float value : drawn(17).pixels) {
                ASSERT_NEAR(value, 1.0f, 2e-3f) << fresnel << ' ' << dispersion;
            }
        }
    }
}

/// With as thick a film as is none the body is the clear one of its index. Rays of several
/// wavelengths share what three channels mirror, so there it is near.
TEST_F(MirroredByATerm, WithoutAFilm_IsTheBodyOfItsIndex) {
    for (const double dispersion : {0.0, 1.0}) {
        surround(false);
        coat("sphere", "solid-body", 0.0);
        set(scene_.objects[0], "dispersion", dispersion);
        scene_.objects[0].material.accuracy["wavelengths"] = "3";
        const Image coated = drawn(17);
        scene_.objects[0].material.parts.erase("fresnel");
        set(scene_.objects[0], "index", 1.52);
        const Image bare = drawn(17);
        for (std::size_t i = 0; i < bare.pixels.size(); ++i) {
            ASSERT_NEAR(coated.pixels[i], bare.pixels[i], dispersion > 0.0 ? 1e-2f : 1e-3f)
                << dispersion << ' ' << i;
        }
    }
}

/// The body's own index says nothing of its surface, nor does a term that is told by an index.
TEST_F(MirroredByATerm, OnlyWhereItsIndexIsTheTerms) {
    coat("sphere", "solid-body", 100.0);
    const auto text = [this] {
        const EffectSet set = effectSet(scene_.objects[0].material, scene_, *catalog);
        const auto program = surfaceProgram(set, *catalog);
        EXPECT_TRUE(program);
        return program ? program->fragment.text : std::string();
    };
    EXPECT_NE(text().find("termShare"), std::string::npos);
    set(scene_.objects[0], "index.from", std::string("own"));
    EXPECT_EQ(text().find("termShare"), std::string::npos);
    set(scene_.objects[0], "index.from", std::string("surface"));
    for (const char* fresnel : {"dielectric", "dispersive"}) {
        scene_.objects[0].material.parts["fresnel"] = block("fresnel", fresnel);
        EXPECT_EQ(text().find("termShare"), std::string::npos) << fresnel;
    }
}

/// All that arrives is 1: neither more nor less leaves, whatever becomes of the rays.
TEST_F(Refraction, InWhiteSurroundings_IsWhite) {
    surround(true);
    for (const char* shape : {"sphere", "torus", "cube"}) {
        for (const char* kind : {"solid-body", "thin-pane"}) {
            for (const double index : {0.6, 1.1, 2.5, 10.0}) {
                scene_.objects = {clear(shape, kind, index)};
                scene_.objects[0].rotation = {20.0, 30.0, 0.0};
                for (const float value : drawn(33).pixels) {
                    ASSERT_NEAR(value, 1.0f, 2e-3f) << shape << ' ' << kind << ' ' << index;
                }
            }
        }
    }
}

TEST_F(Refraction, OfAlmostNone_IsPlainTransparency) {
    scene_.objects = {clear("sphere", "solid-body", 1.0001),
                      glowing({1.0, 0.25, 0.0}, {0.5, 0.0, -2.0})};
    scene_.objects[0].material.accuracy["silhouettes"] = "rays1"; // several smooth what is behind
    const Image refracted = drawn(65);
    scene_.objects.erase(scene_.objects.begin());
    const Image plain = drawn(65);
    int different = 0;
    for (std::size_t i = 0; i < refracted.pixels.size(); ++i) {
        different += std::abs(refracted.pixels[i] - plain.pixels[i]) > 2e-2f ? 1 : 0;
    }
    EXPECT_LT(different, 65 * 3); // along the square's edge
}

TEST_F(Refraction, AWayOfLayers_ChangesNothing) {
    scene_.objects = {clear("sphere", "solid-body", 1.5), glowing({1.0, 0.0, 0.0}, {0, 0, -2})};
    const Image sorted = drawn(33);
    for (const char* way : {"peeled", "weighted"}) {
        scene_.setPart(kinds::transparency, block("transparency", way));
        EXPECT_EQ(drawn(33).pixels, sorted.pixels) << way;
    }
}

TEST_F(Refraction, BehindAnother_IsSeenThroughIt) {
    scene_.objects = {clear("plane", "thin-pane", 1.0), clear("plane", "thin-pane", 1.0)};
    for (Object& object : scene_.objects) {
        object.rotation.x = 90.0;
        set(object, "tint", glm::dvec3(0.5));
    }
    scene_.objects[1].translation.z = -1.0;
    const glm::vec3 expected = 0.25f * glm::vec3(scene_.background);
    EXPECT_LT(glm::distance(middle(drawn(33)), expected), 1e-3f);
}

} // namespace
} // namespace patina::refraction_test
