// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of cut stones against rays that are followed in double precision from plane to plane.
#include <algorithm>
#include <numeric>

#include <glm/gtc/matrix_inverse.hpp>

#include "catalog/parameter_layout.h"
#include "core/convex_facets.h"
#include "measured/spectrum_color.h"
#include "measure/choice/choices.h"
#include "measure/error/display_curve.h"
#include "measure/error/flip.h"
#include "measure/error/frame_error.h"
#include "measure/error/parallel.h"
#include "measure/error/reference_frame.h"
#include "reference/reference.h"
#include "refraction_fixture.h"
#include "render/lights/placement.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina::faceted_body_test {
namespace {

constexpr int size = 64;
constexpr int raysPerPixel = 16;
constexpr int usualWavelengths = 3; ///< of tests that are not about them

// Where the program has the rays of a pixel begin (passes/environment_points.glsl), so that the
// same rays are compared, and not the grain of others.

std::uint32_t hash(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

double scrambled(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    for (const std::uint32_t factor : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u}) {
        x ^= x * factor;
    }
    std::uint32_t reversed = 0;
    for (int i = 0; i < 32; ++i) {
        reversed |= ((x >> i) & 1u) << (31 - i);
    }
    return (reversed >> 8) / 16777216.0;
}

/// Returns the place of a ray in its pixel, from the middle; rows count from the bottom.
glm::dvec2 placeInPixel(std::uint32_t ray, int column, int row) {
    constexpr std::uint32_t use = 9;
    const std::uint32_t seed = hash(static_cast<std::uint32_t>(column) +
                                    hash(static_cast<std::uint32_t>(row) + hash(use)));
    std::uint32_t pascal = ray ^ (ray >> 16);
    pascal ^= (pascal & 0xff00ff00u) >> 8;
    pascal ^= (pascal & 0xf0f0f0f0u) >> 4;
    pascal ^= (pascal & 0xccccccccu) >> 2;
    pascal ^= (pascal & 0xaaaaaaaau) >> 1;
    return glm::dvec2(scrambled(ray, hash(seed)), scrambled(pascal, hash(seed + 1))) - 0.5;
}

/// Is a plane of a stone in the world: x on it has dot(n, x) = offset, and n points outward.
struct Plane {
    glm::dvec3 n;
    double offset;
};

std::vector<Plane> planesOf(const Mesh& mesh, const glm::dmat4& world) {
    std::vector<Plane> planes;
    const glm::dmat3 turn = glm::inverseTranspose(glm::dmat3(world));
    const Vertex* last = nullptr;
    for (const Vertex& vertex : mesh.vertices) {
        if (last == nullptr || vertex.normal != last->normal) {
            const glm::dvec3 n = glm::normalize(turn * glm::dvec3(vertex.normal));
            const glm::dvec3 x(world * glm::dvec4(glm::dvec3(vertex.position), 1.0));
            planes.push_back({n, glm::dot(n, x)});
        }
        last = &vertex;
    }
    return planes;
}

/// Holds a stone and what is around it.
struct Stone {
    std::vector<Plane> planes;
    /// Are the indices of the wavelengths that are followed, and what each channel has of them.
    std::vector<std::pair<double, glm::dvec3>> wavelengths;
    int reflections;
    std::function<glm::dvec3(const glm::dvec3&)> light;
};

/// Returns the facet through which a ray comes in, and where; null where it misses the stone.
const Plane* entry(const Stone& stone, const glm::dvec3& origin, const glm::dvec3& d, double& way) {
    const Plane* first = nullptr;
    double end = 1e300;
    way = 0.0;
    for (const Plane& plane : stone.planes) {
        const double along = glm::dot(plane.n, d);
        const double t = (plane.offset - glm::dot(plane.n, origin)) / along;
        if (along < 0.0 && t > way) {
            way = t;
            first = &plane;
        } else if (along > 0.0) {
            end = std::min(end, t);
        }
    }
    return way < end ? first : nullptr;
}

/// Returns the facet that a ray inside meets, and where. Most of the time of a test goes by here,
/// and tests are compiled as they are written.
const Plane* exit(const Stone& stone, const glm::dvec3& x, const glm::dvec3& d, double& way) {
    const Plane* next = nullptr;
    const double dx = d.x;
    const double dy = d.y;
    const double dz = d.z;
    const double x0 = x.x;
    const double y0 = x.y;
    const double z0 = x.z;
    way = 1e300;
    const Plane* const end = stone.planes.data() + stone.planes.size();
    for (const Plane* plane = stone.planes.data(); plane != end; ++plane) {
        const double along = plane->n.x * dx + plane->n.y * dy + plane->n.z * dz;
        const double left = plane->offset - plane->n.x * x0 - plane->n.y * y0 - plane->n.z * z0;
        if (along > 0.0 && left < way * along) {
            way = left / along;
            next = plane;
        }
    }
    way = std::max(way, 0.0);
    return next;
}

/// Returns the share that is reflected; `onwards` is where the rest goes. n is on the ray's side.
double split(const glm::dvec3& d, const glm::dvec3& n, double eta, glm::dvec3& onwards) {
    const double c = std::clamp(-glm::dot(d, n), 0.0, 1.0);
    const double sine2 = (1.0 - c * c) / (eta * eta);
    if (sine2 >= 1.0) {
        return 1.0;
    }
    const double beyond = std::sqrt(1.0 - sine2);
    onwards = (d + (c - eta * beyond) * n) / eta;
    const double across = (c - eta * beyond) / (c + eta * beyond);
    const double along = (eta * c - beyond) / (eta * c + beyond);
    return 0.5 * (across * across + along * along);
}

/// Returns what a ray of one wavelength sees that comes in at x through a facet.
glm::dvec3 seen(const Stone& stone, glm::dvec3 x, glm::dvec3 d, const Plane& facet, double index) {
    glm::dvec3 inside(0.0);
    double share = split(d, facet.n, index, inside);
    glm::dvec3 sum = share * stone.light(glm::reflect(d, facet.n));
    share = 1.0 - share;
    d = inside;
    for (int i = 0; i <= stone.reflections; ++i) {
        double way = 0.0;
        const Plane* next = exit(stone, x, d, way);
        x += way * d;
        glm::dvec3 out(0.0);
        const double kept = split(d, -next->n, 1.0 / index, out);
        sum += kept < 1.0 ? share * (1.0 - kept) * stone.light(out) : glm::dvec3(0.0);
        share *= kept;
        d = glm::reflect(d, next->n);
    }
    return sum + share * stone.light(d);
}

/// Returns the index for a wavelength in nm: Cauchy's, by the lines d, F and C.
double cauchys(double wavelength, double index, double dispersion) {
    const double spread = 0.05 * dispersion * (index - 1.0) /
                          (1.0 / (0.4861 * 0.4861) - 1.0 / (0.6563 * 0.6563));
    return index + spread * (1e6 / (wavelength * wavelength) - 1.0 / (0.5876 * 0.5876));
}

/// Returns a flat body with so many sides around its upright axis, and two ends.
Mesh coin(int sides) {
    Mesh made;
    const auto corner = [&](int i, float y, const glm::dvec3& n) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        Vertex vertex{};
        vertex.position = {std::cos(angle), y, std::sin(angle)};
        vertex.normal = n;
        made.vertices.push_back(vertex);
        return static_cast<unsigned>(made.vertices.size() - 1);
    };
    const auto triangle = [&](unsigned a, unsigned b, unsigned c) {
        made.indices.insert(made.indices.end(), {a, b, c});
    };
    for (int i = 0; i < sides; ++i) {
        const double middle = 2.0 * std::numbers::pi * (i + 0.5) / sides;
        const glm::dvec3 n(std::cos(middle), 0.0, std::sin(middle));
        const unsigned first = corner(i, -0.5f, n);
        corner(i, 0.5f, n);
        corner(i + 1, 0.5f, n);
        corner(i + 1, -0.5f, n);
        triangle(first, first + 1, first + 2);
        triangle(first, first + 2, first + 3);
    }
    for (const float y : {-0.5f, 0.5f}) {
        const glm::dvec3 n(0.0, 2.0 * double(y), 0.0);
        const unsigned first = corner(0, y, n);
        for (int i = 1; i < sides; ++i) {
            corner(i, y, n);
            const auto here = first + static_cast<unsigned>(i);
            triangle(first, y > 0.0f ? here : here - 1, y > 0.0f ? here - 1 : here);
        }
    }
    made.bounds = boundsOf(made.vertices);
    return made;
}

class FacetedBody : public RefractionTest {
  protected:
    void SetUp() override {
        RefractionTest::SetUp();
        scene_.objects = {clear("brilliant", "faceted-body", 2.417)};
        scene_.setPart(kinds::environment, block("environment", "strip-lights"));
    }

    Object& gem() { return scene_.objects[0]; }

    void follow(int reflections) {
        gem().material.accuracy["reflections"] = std::to_string(reflections);
    }

    View stoneView() const {
        View view = viewOf(scene_, size);
        view.samples = 1;
        view.environmentImage = environment_;
        view.environmentSamples = 4 * raysPerPixel; // a round has one ray
        return view;
    }

    Image stone() {
        auto image = renderer->capture(scene_, stoneView(), meshSource(), false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    /// Returns what stands for all light: so many wavelengths where colours bend apart.
    std::vector<std::pair<double, glm::dvec3>> wavelengths(int count) const {
        const Values& values = scene_.objects[0].material.parts.at("refraction").parameters;
        const double index = std::get<double>(values.at("index"));
        const double dispersion = std::get<double>(values.at("dispersion"));
        if (dispersion == 0.0) {
            return {{index, glm::dvec3(1.0)}};
        }
        std::vector<std::pair<double, glm::dvec3>> all;
        for (const WavelengthShare& each : wavelengthShares(count)) {
            all.emplace_back(cauchys(each.wavelength, index, dispersion), each.shares);
        }
        return all;
    }

    Stone exact(int reflections, int count = usualWavelengths) {
        const BlockValues& part = *scene_.part(kinds::environment);
        const reference::Block* sky = reference::findBlock("environment", part.id);
        std::vector<double> values =
            packed(*catalog->find(kinds::environment, part.id), part.parameters, {});
        mesh(gem());
        const std::string name = gem().mesh.substr(gem().mesh.find(':') + 1);
        return {planesOf(meshes.at(name), worldMatrix(gem())), wavelengths(count), reflections,
                [sky, values](const glm::dvec3& d) {
                    return sky->environment(d, glm::dvec3(1.0), values);
                }};
    }

    /// Returns the mean of a pixel's rays, all through the facet that its middle shows; what the
    /// picture has where that misses the stone.
    glm::dvec3 exactPixel(const Stone& stone, int x, int y, const glm::dvec3& drawn) const {
        const glm::dvec3 from = eye(scene_.camera);
        double way = 0.0;
        const Plane* facet = entry(stone, from, rayThrough(x, y, size), way);
        if (facet == nullptr) {
            return drawn;
        }
        glm::dvec3 sum(0.0);
        for (std::uint32_t i = 0; i < raysPerPixel; ++i) {
            const glm::dvec2 aside = placeInPixel(i, x, size - 1 - y);
            const glm::dvec3 d = rayThrough(x + aside.x, y - aside.y, size);
            const double to = (facet->offset - glm::dot(facet->n, from)) / glm::dot(facet->n, d);
            for (const auto& [index, shares] : stone.wavelengths) {
                sum += shares * seen(stone, from + to * d, d, *facet, index);
            }
        }
        return sum / double(raysPerPixel);
    }

    /// Returns what rays of so many reflections and wavelengths see; what the picture has beside
    /// the stone.
    std::vector<glm::dvec3> exactPicture(const Image& picture, int reflections,
                                         int count = usualWavelengths) {
        const Stone stone = exact(reflections, count);
        std::vector<glm::dvec3> right = lightOf(picture);
        inParallel(right.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const int place = static_cast<int>(i);
                right[i] = exactPixel(stone, place % size, place / size, right[i]);
            }
        });
        return right;
    }

    static std::vector<glm::dvec3> lightOf(const Image& picture) {
        std::vector<glm::dvec3> light;
        for (int i = 0; i < size * size; ++i) {
            light.emplace_back(pixel(picture, i % size, i / size));
        }
        return light;
    }

    /// Returns the mean FLIP of a picture from what is right.
    double flip(const Image& picture, std::vector<glm::dvec3> right) const {
        const DisplayCurve curve = DisplayCurve::of(scene_, *catalog);
        std::vector<glm::dvec3> shown = lightOf(picture);
        for (std::vector<glm::dvec3>* each : {&right, &shown}) {
            for (glm::dvec3& light : *each) {
                light = curve.shown(light);
            }
        }
        const std::vector<double> map = Flip({size, size}, right).differences(shown);
        return std::accumulate(map.begin(), map.end(), 0.0) / double(map.size());
    }

    double flip(const Image& picture, int reflections) {
        return flip(picture, exactPicture(picture, reflections));
    }
};

TEST_F(FacetedBody, FromFiveDirections_IsWhatRaysSee) {
    set(gem(), "dispersion", 0.36);
    gem().material.accuracy["wavelengths"] = std::to_string(usualWavelengths);
    for (const glm::dvec3& rotation :
         {glm::dvec3(90.0, 0.0, 0.0), glm::dvec3(70.0, 20.0, 0.0), glm::dvec3(20.0, -35.0, 0.0),
          glm::dvec3(-60.0, 10.0, 15.0), glm::dvec3(0.0, 80.0, 40.0)}) {
        gem().rotation = rotation;
        EXPECT_LT(flip(stone(), 8), 0.005) << rotation.x << ' ' << rotation.y;
    }
}

/// Returns the frame that charts measure errors against.
LinearFrame frameInDoubles(Renderer& renderer, const BufferedScene& around) {
    std::unique_ptr<ReferenceFrame> frame;
    for (int round = 0; round < raysPerPixel; ++round) {
        auto buffer = renderer.surfaces().capture(around.scene, around.view, around.meshes, round);
        if (round == 0) {
            auto made = ReferenceFrame::create(std::move(*buffer), {true}, &around);
            EXPECT_TRUE(made) << (made ? "" : made.error().text());
            frame = std::move(*made);
        } else {
            frame->goOn(std::move(*buffer));
        }
        while (!frame->step(std::chrono::milliseconds(10))) {
        }
    }
    return frame->frame();
}

/// The rays of the test and those that charts are measured against were written apart.
TEST_F(FacetedBody, InDoublePrecision_IsWhatRaysSeeAndTellsTheErrorsOfLevels) {
    set(gem(), "dispersion", 0.36);
    set(gem(), "absorption.color", glm::dvec3(1.0));
    gem().material.accuracy["wavelengths"] = std::to_string(usualWavelengths);
    gem().rotation = {70.0, 20.0, 0.0};
    const View view = stoneView();
    const MeshSource source = meshSource();
    const LinearFrame frame = frameInDoubles(*renderer, {scene_, view, source, *catalog});
    const Image drawnImage = stone();
    const std::vector<glm::dvec3> right = exactPicture(drawnImage, 8);
    int shown = 0;
    int other = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        if (frame.counts[i] != 0) {
            ++shown;
            const double near = 1e-3 * (1.0 + glm::length(right[i]));
            other += glm::distance(frame.colors[i], right[i]) > near ? 1 : 0;
        }
    }
    EXPECT_GT(shown, size * size / 5);
    EXPECT_LE(other, shown / 100);

    const ErrorMeter meter(frame, DisplayCurve::of(scene_, *catalog));
    double last = 0.0;
    for (const int reflections : {8, 6, 4, 2, 0}) {
        follow(reflections);
        const FrameError error = meter.errorOf({{size, size}, lightOf(stone()), {}});
        EXPECT_GT(error.flip, last) << reflections;
        last = error.flip;
        RecordProperty("flip" + std::to_string(reflections), std::to_string(error.flip));
    }
}

TEST_F(FacetedBody, BesideOthersOrUnderAnImage_IsNotKnownInDoublePrecision) {
    const auto whyNot = [this] {
        const View view = stoneView();
        const MeshSource source = meshSource();
        const BufferedScene around{scene_, view, source, *catalog};
        auto buffer = renderer->surfaces().capture(scene_, view, source, 0);
        const auto made = ReferenceFrame::create(
            std::move(*buffer), std::vector<bool>(scene_.objects.size(), true), &around);
        return made ? std::string() : made.error().problem;
    };
    EXPECT_EQ(whyNot(), "");
    gem().mesh = "builtin:torus";
    EXPECT_NE(whyNot().find("no convex body"), std::string::npos) << whyNot();
    gem().mesh = "builtin:brilliant";
    scene_.objects.push_back(glowing({1.0, 0.0, 0.0}, {0, 0, -2}));
    EXPECT_EQ(whyNot(), "other objects are seen through it");
    scene_.objects.pop_back();
    surround(true);
    EXPECT_EQ(whyNot(), "an image is what surrounds it");
    scene_.parts.clear();
    EXPECT_EQ(whyNot(), "");
}

TEST_F(FacetedBody, ThatIsStretched_IsWhatRaysSee) {
    gem().mesh = "builtin:emeraldcut";
    gem().rotation = {65.0, 15.0, 30.0};
    gem().scale = {1.1, 1.6, 0.7};
    EXPECT_LT(flip(stone(), 8), 0.02);
}

/// Each level is what its number says, and fewer reflections are farther from eight.
TEST_F(FacetedBody, OfFewerReflections_IsThoseRaysAndFartherFromAll) {
    gem().rotation = {75.0, 10.0, 0.0};
    double last = 0.0;
    for (const int reflections : {4, 0}) {
        follow(reflections);
        const Image image = stone();
        EXPECT_LT(flip(image, reflections), 0.02) << reflections;
        const double error = flip(image, 8);
        EXPECT_GT(error, last) << reflections;
        last = error;
    }
    EXPECT_GT(last, 0.1);
}

TEST_F(FacetedBody, OfFiveWavelengths_IsThoseRays) {
    gem() = clear("cube", "faceted-body", 1.6);
    gem().rotation = {35.0, 25.0, 0.0};
    set(gem(), "dispersion", 2.0);
    follow(1);
    gem().material.accuracy["wavelengths"] = "5";
    const Image image = stone();
    EXPECT_LT(flip(image, exactPicture(image, 1, 5)), 0.005);
    EXPECT_GT(flip(image, exactPicture(image, 1, 3)), 0.005);
}

/// 64 rays of 15 wavelengths among 128 facets: the driver ends none of their loops.
TEST_F(FacetedBody, OfAsManyFacetsAsThereMayBe_IsWhiteInWhiteSurroundings) {
    surround(true);
    gem() = clear("cube", "faceted-body", 2.417);
    gem().mesh = "builtin:coin";
    meshes["coin"] = coin(126);
    ASSERT_EQ(convexFacetsOf(mesh(gem())).planes.size(), 128u);
    for (const char* wavelengths : {"5", "15"}) {
        set(gem(), "dispersion", 0.36);
        gem().material.accuracy["wavelengths"] = wavelengths;
        View view = viewOf(scene_, 5);
        view.samples = 1;
        view.environmentImage = environment_;
        view.environmentSamples = 256;
        const auto image = renderer->capture(scene_, view, meshSource(), false);
        ASSERT_TRUE(image);
        for (const float value : image->pixels) {
            ASSERT_NEAR(value, 1.0f, 2e-3f) << wavelengths;
        }
    }
}

TEST_F(FacetedBody, Reflections_AreAChoiceOfItsChart) {
    const std::vector<Choice> choices = materialChoices(scene_, 0, *catalog);
    const auto found = std::ranges::find(choices, "refraction.reflections", &Choice::id);
    ASSERT_NE(found, choices.end());
    EXPECT_EQ(found->levels.size(), 9u);
}

/// All that arrives is 1: neither more nor less leaves, whatever becomes of the rays.
TEST_F(FacetedBody, InWhiteSurroundings_IsWhite) {
    surround(true);
    for (const char* shape : {"brilliant", "emeraldcut", "cube"}) {
        for (const int reflections : {0, 8}) {
            for (const double index : {0.6, 1.1, 2.417, 10.0}) {
                gem() = clear(shape, "faceted-body", index);
                gem().rotation = {20.0, 30.0, 0.0};
                follow(reflections);
                for (const float value : drawn(33).pixels) {
                    ASSERT_NEAR(value, 1.0f, 2e-3f) << shape << ' ' << reflections << ' ' << index;
                }
            }
        }
    }
}

TEST_F(FacetedBody, OfAMeshThatIsNoSuchBody_IsASolidBody) {
    for (const char* shape : {"torus", "sphere", "shaderball", "plane"}) {
        gem() = clear(shape, "faceted-body", 1.5);
        const Image faceted = drawn(33);
        gem() = clear(shape, "solid-body", 1.5);
        EXPECT_EQ(faceted.pixels, drawn(33).pixels) << shape;
    }
}

TEST_F(FacetedBody, ThatAbsorbs_IsDarkerTheFartherRaysGo) {
    set(gem(), "absorption.color", glm::dvec3(0.9, 0.5, 0.5));
    scene_.background = glm::dvec3(0.0);
    gem().rotation = {75.0, 10.0, 0.0};
    const auto total = [](const Image& image, std::size_t channel) {
        double sum = 0.0;
        for (std::size_t i = channel; i < image.pixels.size();
             i += static_cast<std::size_t>(image.channels)) {
            sum += double(image.pixels[i]);
        }
        return sum;
    };
    const Image image = stone();
    EXPECT_GT(total(image, 0), 1.3 * total(image, 1));
}

TEST_F(FacetedBody, OfValuesFromEndToEnd_IsFinite) {
    for (const double index : {0.1, 1.0, 10.0}) {
        for (const double dispersion : {0.0, 10.0}) {
            for (const glm::dvec3& scale :
                 {glm::dvec3(1.0), glm::dvec3(1e-6, 1.0, 1.0), glm::dvec3(-1.0, 1.0, 1.0),
                  glm::dvec3(1e4), glm::dvec3(1.0, 0.0, 1.0)}) {
                gem() = clear("brilliant", "faceted-body", index);
                gem().scale = scale;
                set(gem(), "dispersion", dispersion);
                set(gem(), "absorption.color", glm::dvec3(0.0, 0.5, 1.0));
                set(gem(), "absorption.distance", 0.0001);
                for (const float value : drawn(17).pixels) {
                    ASSERT_TRUE(value >= 0.0f && value <= 65504.0f)
                        << index << ' ' << dispersion << ' ' << scale.x << ' ' << value;
                }
            }
        }
    }
}

TEST_F(FacetedBody, BeforeSomething_ShowsItThroughACube) {
    scene_.parts.clear();
    scene_.objects = {clear("cube", "faceted-body", 1.5), glowing({1.0, 0.0, 0.0}, {0, 0, -2})};
    EXPECT_GT(middle(drawn(33)).r, 0.8f);
}

} // namespace
} // namespace patina::faceted_body_test
