// SPDX-License-Identifier: GPL-3.0-or-later
// How well marks of strokes stay where they are while a model turns and comes nearer, beside
// hatching that is drawn on the screen.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "benchmarks.h"
#include "core/surface_marks.h"
#include "gl/headless_context.h"
#include "material/block_values.h"
#include "material/preset_file.h"
#include "primitive_meshes.h"
#include "render/lights/frustum.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "shading/effects/strokes.h"
#include "stage.h"

namespace patina::benchmarks {
namespace {

constexpr int turnFrames = 120;
constexpr glm::ivec2 dotSize{256, 256};
constexpr glm::ivec2 toneSize{512, 512};
constexpr double minKept = 0.99; // of the marks
constexpr double maxOff = 0.5;   // pixels
constexpr double maxSizeFactor = 2.0;
constexpr double tone = 1.0 / 6.0; // of what lies between ink and paper

/// Where ink lies together: its middle, in pixels, and how much of it there is, in whole pixels.
struct Blot {
    glm::dvec2 middle{0.0};
    double ink = 0.0;
};

class CoherenceStage {
  public:
    CoherenceStage()
        : context_(gl::HeadlessContext::create().value()),
          catalog_(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()))),
          renderer_(Stage::rendererOf(catalog_)) {
        scene_ = readScene(presets() / "drawing.patina-scene.json", *catalog_)->scene;
        scene_.objects.resize(1);
        scene_.objects.front().mesh = "builtin:sphere";
        scene_.camera.pivot = glm::dvec3(0.0);
        scene_.setPart(kinds::tone, std::nullopt);
    }

    static std::filesystem::path presets() { return PATINA_SOURCE_DIR "/presets"; }

    Scene& scene() { return scene_; }
    const Catalog& catalog() const { return *catalog_; }

    Image draw(glm::ivec2 size, bool display) {
        View view;
        view.size = size;
        view.camera = scene_.camera;
        return renderer_->capture(scene_, view, meshes_.source(), display).value();
    }

    /// Black dots apart from each other on white paper, whatever their light is: 4 pixels wide, 45
    /// on a square of 100 x 100 pixels. Sizes are those of a picture that is twice as high.
    void useDots() {
        Material& material = scene_.objects.front().material;
        material = defaultMaterial(*catalog_->find("models", "lambert"));
        BlockValues dots = defaultBlockValues(*catalog_->find("strokes", "stipple"));
        dots.parameters["density"] = 45.0 / 4.0;
        dots.parameters["dot.length"] = 8.0;
        dots.parameters["dot.width"] = 8.0;
        dots.parameters["variation"] = 0.0;
        dots.parameters["tone.dark"] = 10.0;
        dots.parameters["tone.light"] = 10.0;
        dots.parameters["ink.color"] = glm::dvec3(0.0);
        dots.parameters["paper.color"] = glm::dvec3(1.0);
        material.parts["strokes"] = dots;
        scene_.background = glm::dvec3(1.0);
    }

    /// Marks of a kind of strokes, black and so few that they lie apart on white paper.
    void useFewMarks(const char* strokes) {
        Material& material = scene_.objects.front().material;
        material = defaultMaterial(*catalog_->find("models", "lambert"));
        BlockValues marks = defaultBlockValues(*catalog_->find("strokes", strokes));
        const Values black{{"ink.color", glm::dvec3(0.0)},
                           {"paper.color", glm::dvec3(1.0)},
                           {"fill.color", glm::dvec3(0.0)},
                           {"fill", 1.0},
                           {"ground.color", glm::dvec3(1.0)},
                           {"ground", 1.0},
                           {"tone.dark", 10.0},
                           {"tone.light", 10.0},
                           {"tone.variation", 0.0},
                           {"hue.variation", 0.0},
                           {"variation", 0.0},
                           {"angle.cross", 0.0},
                           {"inside", 1.0},
                           {"relief", 0.0},
                           {"bristles", 0.0},
                           {"density", 40.0},
                           {"stroke.length", 8.0},
                           {"weight", 4.0},
                           {"tuft.length", 4.0},
                           {"tuft.width", 4.0},
                           {"opacity", 1.0},
                           {"loading", 1.0}};
        for (const auto& [id, value] : black) {
            if (marks.parameters.contains(id)) {
                marks.parameters[id] = value;
            }
        }
        // Marks have the surface's colour or one of their own.
        const double own = marks.parameters.contains("fill.color") ? 1.0 : 0.0;
        material.model.parameters["diffuse.color"] = glm::dvec3(0.0);
        material.model.parameters["emissive.color"] = glm::dvec3(own);
        material.parts["strokes"] = marks;
        scene_.background = glm::dvec3(1.0);
    }

    /// Black dots of a halftone that lies on the surface, of a tone that keeps them apart.
    void useSurfaceDots() {
        usePreset("surface-halftone/red-comic.patina.json");
        Material& material = scene_.objects.front().material;
        for (const char* part : {"strokes", "outline", "fresnel", "specular"}) {
            material.parts.erase(part);
        }
        material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
        material.model.parameters["ink.color"] = glm::dvec3(0.0);
        material.model.parameters["cell"] = 12.0;
        scene_.lights.front().block.parameters["color"] = glm::dvec3(1.0);
        scene_.background = glm::dvec3(1.0);
    }

    void usePreset(const char* file) {
        scene_.objects.front().material = readPreset(presets() / file, *catalog_)->material;
    }

    const Mesh& ball() { return ball_; }

  private:
    std::unique_ptr<gl::HeadlessContext> context_;
    std::shared_ptr<const Catalog> catalog_;
    std::unique_ptr<Renderer> renderer_;
    Scene scene_;
    PrimitiveMeshes meshes_;
    Mesh ball_ = primitive("sphere").value();
};

double inkAt(const Image& image, int x, int y) {
    const std::size_t at =
        (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * std::size_t(image.channels);
    return std::clamp(1.0 - double(image.pixels[at + 1]), 0.0, 1.0);
}

/// Adds a pixel's ink to the blot around it, and that of its neighbours.
void soakUp(const Image& image, std::vector<bool>& taken, int x, int y, Blot& blot) {
    std::vector<glm::ivec2> next{{x, y}};
    while (!next.empty()) {
        const glm::ivec2 at = next.back();
        next.pop_back();
        if (at.x < 0 || at.y < 0 || at.x >= image.width || at.y >= image.height ||
            taken[std::size_t(at.y * image.width + at.x)] || inkAt(image, at.x, at.y) < 0.02) {
            continue;
        }
        taken[std::size_t(at.y * image.width + at.x)] = true;
        const double ink = inkAt(image, at.x, at.y);
        blot.middle += ink * (glm::dvec2(at) + 0.5);
        blot.ink += ink;
        for (const glm::ivec2 step :
             {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
            next.push_back(at + step);
        }
    }
}

std::vector<Blot> blotsOf(const Image& image) {
    std::vector<bool> taken(std::size_t(image.width) * std::size_t(image.height), false);
    std::vector<Blot> blots;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            Blot blot;
            soakUp(image, taken, x, y, blot);
            if (blot.ink > 0.0) {
                blot.middle /= blot.ink;
                blots.push_back(blot);
            }
        }
    }
    return blots;
}

/// Returns where a point of the ball is in the picture, in pixels from its upper left corner.
glm::dvec2 pixelOf(const Scene& scene, const glm::dvec3& place) {
    DepthRange depths;
    const glm::dmat4 worldToClip = projection(scene.camera, 1.0, depths) * viewMatrix(scene.camera);
    const glm::dvec4 clip = worldToClip * glm::dvec4(place, 1.0);
    return glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) *
           glm::dvec2(dotSize);
}

double distanceToNearest(const std::vector<Blot>& blots, const glm::dvec2& place) {
    double nearest = 1e9;
    for (const Blot& blot : blots) {
        nearest = std::min(nearest, glm::distance(blot.middle, place));
    }
    return nearest;
}

/// Over a turn, of the marks that are wholly there and face the viewer, the share with ink whose
/// middle is within half a pixel of where their point of the surface is.
bool keptPlaces(CoherenceStage& stage) {
    stage.useDots();
    SurfaceMarks marks(stage.ball().view());
    while (!marks.isMeasured() || marks.marks().size() < 4096) {
        marks.proceed(stage.ball().view(), 10000, 4096);
    }
    stage.scene().camera.pitch = 10.0;
    const double pixel =
        2.0 * std::tan(glm::radians(0.5 * stage.scene().camera.fieldOfView)) / dotSize.y;
    int all = 0;
    int kept = 0;
    for (int frame = 0; frame < turnFrames; ++frame) {
        stage.scene().camera.yaw = 360.0 * frame / turnFrames;
        const glm::dvec3 from = eye(stage.scene().camera);
        const std::vector<Blot> blots = blotsOf(stage.draw(dotSize, false));
        for (const SurfaceMark& mark : marks.marks()) {
            const glm::dvec3 place(mark.at.position);
            const double facing =
                glm::dot(glm::normalize(from - place), glm::dvec3(mark.at.normal));
            const double range = glm::distance(from, place) * pixel;
            const double wanted = 45e-4 / (range * range) * facing;
            if (facing > 0.5 && wanted > 1.5 * double(mark.needed)) {
                ++all;
                kept += distanceToNearest(blots, pixelOf(stage.scene(), place)) <= maxOff ? 1 : 0;
            }
        }
    }
    const double share = double(kept) / all;
    std::printf("coherence: marks that keep their place within half a pixel over a turn of %d "
                "frames: %.2f %% of %d (target: %.0f %%)\n",
                turnFrames, 100.0 * share, all, 100.0 * minKept);
    return share >= minKept;
}

/// Returns where the ball is seen at a place of the picture; nothing beside it or near its edge,
/// where a pixel is much of the surface.
std::optional<glm::dvec3> surfaceAt(const Scene& scene, const glm::dvec2& pixel) {
    DepthRange depths;
    const glm::dmat4 clipToWorld =
        glm::inverse(projection(scene.camera, 1.0, depths) * viewMatrix(scene.camera));
    const glm::dvec2 at = 2.0 * pixel / glm::dvec2(dotSize) - 1.0;
    const glm::dvec4 far = clipToWorld * glm::dvec4(at.x, -at.y, 0.5, 1.0);
    const glm::dvec3 from = eye(scene.camera);
    const glm::dvec3 along = glm::normalize(glm::dvec3(far) / far.w - from);
    const double middle = -glm::dot(from, along);
    const double inside = middle * middle - glm::dot(from, from) + 1.0;
    if (inside < 0.0) {
        return std::nullopt;
    }
    const glm::dvec3 place = from + (middle - std::sqrt(inside)) * along;
    return glm::dot(place, along) < -0.5 ? std::optional(place) : std::nullopt;
}

/// Says what became of marks that were followed.
struct FollowedMarks {
    int stayed = 0; ///< lie within half a pixel of their place of the surface
    int moved = 0;  ///< lie beside it
    int gone = 0;   ///< have no ink within two pixels of it
};

/// Follows each blot of a picture to where its place on the surface is when the ball has turned on
/// for some frames. Where blots touch, their middle is none of a mark's: such are left out.
FollowedMarks followed(CoherenceStage& stage) {
    constexpr int ahead = 4; // of the frames of a turn: 12 degrees
    std::vector<std::vector<Blot>> blots(turnFrames + ahead);
    FollowedMarks found;
    for (int frame = 0; frame < turnFrames + ahead; ++frame) {
        stage.scene().camera.yaw = 360.0 * frame / turnFrames;
        blots[std::size_t(frame)] = blotsOf(stage.draw(dotSize, false));
        if (frame < ahead) {
            continue;
        }
        std::vector<double> inks;
        const std::vector<Blot>& before = blots[std::size_t(frame - ahead)];
        for (const Blot& blot : before) {
            inks.push_back(blot.ink);
        }
        std::ranges::nth_element(inks, inks.begin() + std::ptrdiff_t(inks.size() / 2));
        const double usual = inks.empty() ? 0.0 : inks[inks.size() / 2];
        Scene earlier = stage.scene();
        earlier.camera.yaw = 360.0 * (frame - ahead) / turnFrames;
        for (const Blot& blot : before) {
            const auto place = surfaceAt(earlier, blot.middle);
            if (!place || blot.ink < 0.5 * usual || blot.ink > 1.5 * usual) {
                continue;
            }
            const double facing =
                glm::dot(glm::normalize(eye(stage.scene().camera) - *place), *place);
            if (facing < 0.5) {
                continue;
            }
            const double off =
                distanceToNearest(blots[std::size_t(frame)], pixelOf(stage.scene(), *place));
            (off <= maxOff ? found.stayed : off <= 2.0 ? found.moved : found.gone) += 1;
        }
    }
    return found;
}

/// The median width of dots in the picture from a distance of 1 to 16.
bool keptSizes(CoherenceStage& stage) {
    stage.useDots();
    stage.scene().objects.front().scale = glm::dvec3(0.8);
    double least = 1e9;
    double greatest = 0.0;
    for (const double distance : {1.0, 2.0, 4.0, 8.0, 16.0}) {
        stage.scene().camera.distance = distance;
        std::vector<double> widths;
        for (const Blot& blot : blotsOf(stage.draw(dotSize, false))) {
            widths.push_back(2.0 * std::sqrt(blot.ink / 3.14159265358979));
        }
        std::ranges::sort(widths);
        const double width = widths.empty() ? 0.0 : widths[widths.size() / 2];
        std::printf("coherence: at %4.0f m %4zu dots, half of them wider than %.2f pixels\n",
                    distance, widths.size(), width);
        least = std::min(least, width);
        greatest = std::max(greatest, width);
    }
    const double factor = greatest / least;
    std::printf(
        "coherence: width of marks from 1 to 16 m: within a factor of %.2f (target: %.1f)\n",
        factor, maxSizeFactor);
    stage.scene().objects.front().scale = glm::dvec3(1.0);
    return factor <= maxSizeFactor;
}

/// Returns how wide strokes are on average, in pixels: twice their ink over the length of its
/// edges, both of which grow alike with how dark they are.
double strokeWidth(const Image& image) {
    double ink = 0.0;
    double edges = 0.0;
    for (int y = 0; y + 1 < image.height; ++y) {
        for (int x = 0; x + 1 < image.width; ++x) {
            const double here = inkAt(image, x, y);
            ink += here;
            edges += std::hypot(inkAt(image, x + 1, y) - here, inkAt(image, x, y + 1) - here);
        }
    }
    return edges > 0.0 ? 2.0 * ink / edges : 0.0;
}

/// The width of strokes of tonal art maps from a distance of 1 to 16, whose squares of paper are so
/// wide that there are strokes at 16.
bool keptStrokes(CoherenceStage& stage) {
    stage.usePreset("tonal-art-maps/sketchbook.patina.json");
    Material& material = stage.scene().objects.front().material;
    material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
    material.model.parameters["ink.color"] = glm::dvec3(0.0);
    material.model.parameters["map.size"] = 4.0;
    stage.scene().background = glm::dvec3(1.0);
    stage.scene().objects.front().scale = glm::dvec3(0.8);
    double narrowest = 1e9;
    double widest = 0.0;
    for (const double distance : {1.0, 2.0, 4.0, 8.0, 16.0}) {
        stage.scene().camera.distance = distance;
        const double width = strokeWidth(stage.draw(dotSize, false));
        std::printf("coherence: at %4.0f m strokes of tonal art maps are %.2f pixels wide\n",
                    distance, width);
        narrowest = std::min(narrowest, width);
        widest = std::max(widest, width);
    }
    const double factor = widest / narrowest;
    std::printf("coherence: width of strokes of tonal art maps from 1 to 16 m: within a factor of "
                "%.2f (target: %.1f)\n",
                factor, maxSizeFactor);
    stage.scene().objects.front().scale = glm::dvec3(1.0);
    return factor <= maxSizeFactor;
}

/// Returns the share of the object's pixels that change by more than one tone of six from frame to
/// frame of a turn.
double changingPixels(CoherenceStage& stage, const char* preset) {
    stage.usePreset(preset);
    stage.scene().camera.distance = 4.0;
    Image before;
    std::int64_t all = 0;
    std::int64_t changed = 0;
    for (int frame = 0; frame <= turnFrames; ++frame) {
        stage.scene().camera.yaw = 360.0 * frame / turnFrames;
        const Image image = stage.draw(toneSize, true);
        for (int y = 0; frame > 0 && y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const double r = std::hypot(x + 0.5 - 0.5 * toneSize.x, y + 0.5 - 0.5 * toneSize.y);
                if (r < 0.35 * toneSize.x) {
                    ++all;
                    changed += std::abs(inkAt(image, x, y) - inkAt(before, x, y)) > tone ? 1 : 0;
                }
            }
        }
        before = image;
    }
    return double(changed) / double(all);
}

/// Of marks of each kind that are still there when the ball has turned on, the share that is within
/// half a pixel of its place on the surface.
bool keptMarks(CoherenceStage& stage) {
    stage.scene().camera.pitch = 10.0;
    bool kept = true;
    const auto follow = [&](const char* name, bool isStanding) {
        const FollowedMarks found = followed(stage);
        const int there = found.stayed + found.moved;
        const double share = there > 0 ? double(found.stayed) / there : 0.0;
        std::printf("coherence: %s within half a pixel of their place after 12 degrees: %.2f %% of "
                    "%d, besides %d that are gone (target: %.0f %%)\n",
                    name, 100.0 * share, there, found.gone, 100.0 * minKept);
        // What stands up from the surface has its root there, and its middle elsewhere.
        kept = kept && (isStanding || share >= minKept);
    };
    for (const Block* strokes : stage.catalog().ofKind("strokes")) {
        stage.useFewMarks(strokes->id.c_str());
        follow(strokes->label.c_str(),
               areStanding(BlockUse(*strokes, defaultBlockValues(*strokes).parameters)));
    }
    stage.useSurfaceDots();
    follow("dots of surface halftone", false);
    return kept;
}

} // namespace

bool coherence() {
    CoherenceStage stage;
    bool kept = keptPlaces(stage);
    kept = keptMarks(stage) && kept;
    kept = keptSizes(stage) && kept;
    kept = keptStrokes(stage) && kept;
    for (const char* preset : {"hatching/pen-and-ink.patina.json", "lambert/pen-sketch.patina.json",
                               "lambert/stippled.patina.json", "oren-nayar/oil-painted.patina.json",
                               "tonal-art-maps/sketchbook.patina.json"}) {
        std::printf("coherence: pixels that change by more than a tone from frame to frame of a "
                    "turn, %s: %.2f %%\n",
                    preset, 100.0 * changingPixels(stage, preset));
    }
    return kept;
}

} // namespace patina::benchmarks
