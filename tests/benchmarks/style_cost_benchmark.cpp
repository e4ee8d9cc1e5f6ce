// SPDX-License-Identifier: GPL-3.0-or-later
// What each style takes beside the plain picture, level by level, and how far cheaper levels are
// from the first one: written into docs/style-cost.md, with the machine.
#include <optional>
#include <string>
#include <vector>

#include "benchmarks.h"
#include "catalog/parameter_type.h"
#include "gl/headless_context.h"
#include "machine_text.h"
#include "material/block_values.h"
#include "measure/error/flip.h"
#include "measure/error/picture_distance.h"
#include "measure/match/free_numbers.h"
#include "primitive_meshes.h"
#include "stage.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr glm::ivec2 size{512, 512};
/// Every way is drawn so often, unless its frames took so long together.
constexpr std::size_t rounds = 9;
constexpr std::size_t roundsOfSlow = 3;
constexpr double enoughSeconds = 4.0;

/// Is a style at one of its levels, with what was measured of it.
struct Way {
    std::string style;
    std::string level; ///< is empty for the block's own values
    Scene scene;
    /// Is the number of the way whose picture this one's is compared with, if any.
    std::optional<std::size_t> other{};
    std::vector<double> ratios{};
    std::vector<double> extra{}; ///< seconds more than the plain picture
    double seconds = 0.0;        ///< of all frames together

    bool isMeasured() const {
        return ratios.size() >= rounds ||
               (ratios.size() >= roundsOfSlow && seconds > enoughSeconds);
    }
};

/// Draws one ball in the scene for drawings, in every style that ships.
class StyleStage {
  public:
    StyleStage()
        : context_(gl::HeadlessContext::create().value()),
          catalog_(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()))),
          renderer_(Stage::rendererOf(catalog_)) {
        plain_ = readScene(PATINA_SOURCE_DIR "/presets/drawing.patina-scene.json", *catalog_)
                     .value()
                     .scene;
        plain_.objects.resize(1);
        plain_.objects.front().mesh = "builtin:sphere";
        plain_.objects.front().material = defaultMaterial(*catalog_->find("models", "lambert"));
    }

    std::vector<Way> ways() const {
        std::vector<Way> ways;
        for (const Block* model : catalog_->ofKind(kinds::models)) {
            if (model->lighting == LightsWanted::Key) {
                addModel(ways, *model);
            }
        }
        for (const Block* pass : catalog_->ofKind(kinds::pass)) {
            addPass(ways, *pass);
        }
        for (const std::string_view kind : {kinds::strokes, kinds::shells}) {
            for (const Block* block : catalog_->ofKind(kind)) {
                addMaterialPart(ways, *block);
            }
        }
        return ways;
    }

    /// Draws a pair of frames, the plain one first.
    void measure(Way& way) {
        const double plain = secondsOf(plain_);
        const double styled = secondsOf(way.scene);
        way.ratios.push_back(styled / plain);
        way.extra.push_back(styled - plain);
        way.seconds += styled;
    }

    void warmUp(const Way& way) { secondsOf(way.scene); }

    std::vector<glm::dvec3> pictureOf(const Scene& scene) {
        return displayColors(
            renderer_->capture(scene, viewOf(scene), meshes_.source(), true).value());
    }

    double plainSeconds() { return secondsOf(plain_); }

  private:
    static View viewOf(const Scene& scene) {
        View view;
        view.size = size;
        view.camera = scene.camera;
        return view;
    }

    /// Adds a model as it is, then with every level that is not exact.
    void addModel(std::vector<Way>& ways, const Block& model) const {
        const std::size_t exact = ways.size();
        Scene scene = plain_;
        Material& material = scene.objects.front().material;
        material = defaultMaterial(model);
        ways.push_back({model.label, {}, scene});
        for (const AccuracyChoice& choice : model.accuracy) {
            for (const EnumValue& level : choice.values) {
                if (!level.exact) {
                    material.accuracy[choice.id] = level.id;
                    ways.push_back({model.label, choice.id + " = " + level.id, scene, exact});
                }
            }
            material.accuracy.erase(choice.id);
        }
    }

    /// Adds a pass as it is, then with every other state of what is compiled into it.
    void addPass(std::vector<Way>& ways, const Block& pass) const {
        Scene scene = plain_;
        scene.passes = {defaultBlockValues(pass)};
        ways.push_back({pass.label, {}, scene});
        const std::size_t asItIs = ways.size() - 1;
        for (const Parameter* choice : choicesOf(pass, scene.passes.front().parameters)) {
            addStates(ways, pass, asItIs, *choice);
        }
    }

    /// Adds a way for each other state of a choice, and behind one by which more choices count, one
    /// for each state of those.
    void addStates(std::vector<Way>& ways, const Block& pass, std::size_t other,
                   const Parameter& choice) const {
        for (const Value& state : infoOf(choice.type).states(choice)) {
            if (state == choice.defaultValue) {
                continue;
            }
            Way way{pass.label, ways[other].level, ways[other].scene, other};
            way.level += (way.level.empty() ? "" : ", ") + choice.id + " = " + textOf(state);
            way.scene.passes.front().parameters[choice.id] = state;
            ways.push_back(way);
            const std::size_t number = ways.size() - 1;
            const auto before = choicesOf(pass, ways[other].scene.passes.front().parameters);
            for (const Parameter* more : choicesOf(pass, way.scene.passes.front().parameters)) {
                if (std::ranges::find(before, more) == before.end()) {
                    addStates(ways, pass, number, *more);
                }
            }
        }
    }

    /// Returns what is compiled into a pass and counts as its values stand.
    static std::vector<const Parameter*> choicesOf(const Block& pass, const Values& values) {
        std::vector<const Parameter*> choices;
        for (const Parameter& parameter : pass.parameters) {
            if (parameter.compiled == Compiled::Yes && infoOf(parameter.type).states != nullptr &&
                counts(parameter, EvalBlock{&pass, values, {}})) {
                choices.push_back(&parameter);
            }
        }
        return choices;
    }

    static std::string textOf(const Value& state) {
        const auto* word = std::get_if<std::string>(&state);
        return word != nullptr ? *word : std::get<bool>(state) ? "on" : "off";
    }

    /// Adds a block of the material at every level.
    void addMaterialPart(std::vector<Way>& ways, const Block& block) const {
        Scene scene = plain_;
        Material& material = scene.objects.front().material;
        setPart(material.parts, block.kind, defaultBlockValues(block));
        for (const AccuracyChoice& choice : block.accuracy) {
            std::optional<std::size_t> exact;
            for (const EnumValue& level : choice.values) {
                material.accuracy[choice.id] = level.id;
                ways.push_back({block.label, choice.id + " = " + level.id, scene, exact});
                exact = exact.value_or(ways.size() - 1);
            }
        }
    }

    double secondsOf(const Scene& scene) {
        const double began = wallSeconds();
        renderer_->capture(scene, viewOf(scene), meshes_.source(), true).value();
        return wallSeconds() - began;
    }

    std::unique_ptr<gl::HeadlessContext> context_;
    std::shared_ptr<const Catalog> catalog_;
    std::unique_ptr<Renderer> renderer_;
    PrimitiveMeshes meshes_;
    Scene plain_;
};

struct Difference {
    double mean = 0.0; ///< of the displayed channels
    double flip = 0.0;
};

Difference differenceOf(const std::vector<glm::dvec3>& first,
                        const std::vector<glm::dvec3>& other) {
    Difference difference;
    for (std::size_t i = 0; i < first.size(); ++i) {
        const glm::dvec3 off = glm::abs(first[i] - other[i]);
        difference.mean += (off.r + off.g + off.b) / (3.0 * double(first.size()));
    }
    for (const double each : Flip(size, first).differences(other)) {
        difference.flip += each / double(first.size());
    }
    return difference;
}

std::string rowsOf(StyleStage& stage, const std::vector<Way>& ways) {
    std::string rows;
    for (const Way& way : ways) {
        const Spread ratio = spreadOf(way.ratios);
        std::string off = "|";
        if (way.other) {
            const Difference difference =
                differenceOf(stage.pictureOf(ways[*way.other].scene), stage.pictureOf(way.scene));
            off = fmt::format("{:.2f} % | {:.3f}", 100.0 * difference.mean, difference.flip);
        }
        rows += fmt::format("| {} | {} | {:.0f} | {:.2f} ({:.2f} .. {:.2f}) | {} |\n", way.style,
                            way.level.empty() ? "" : '`' + way.level + '`',
                            1000.0 * spreadOf(way.extra).median, ratio.median, ratio.lower,
                            ratio.upper, off);
    }
    fmt::print("{}", rows);
    return rows;
}

} // namespace

bool styleCost() {
    StyleStage stage;
    const double before = load();
    std::vector<Way> ways = stage.ways();
    std::vector<double> plain;
    stage.plainSeconds();
    for (const Way& way : ways) {
        stage.warmUp(way);
    }
    for (std::size_t round = 0; round < rounds; ++round) {
        plain.push_back(stage.plainSeconds());
        for (Way& way : ways) {
            if (!way.isMeasured()) {
                stage.measure(way);
            }
        }
    }
    return writeDocument(
        "style-cost.md",
        fmt::format(
            "# What styles cost\n\n"
            "Written by `./packaging/benchmark style-cost` on {}: {}. The load was {:.1f} when it "
            "began and\n{:.1f} when it ended: above 1 other things were at work, and spreads are "
            "wide.\n\n"
            "Each style on a ball of {} x {} pixels under the drawing's key light, beside the "
            "plain "
            "matte\nball, which takes {:.0f} ms: milliseconds more, and the ratio, medians with "
            "the middle half. The pictures of\nlevels are compared with that of the first row of "
            "their style, or of the row with all but\nthe last of their states: the mean "
            "difference of the displayed channels, and FLIP. Of a pass's\nother patterns, marks "
            "and colours that is no error: they are other looks.\n\n"
            "| style | level | ms more | of the plain picture's time | differs by | FLIP |\n"
            "| --- | --- | --- | --- | --- | --- |\n{}",
            today(), machineText(), before, load(), size.x, size.y, 1000.0 * spreadOf(plain).median,
            rowsOf(stage, ways)));
}

} // namespace patina::benchmarks
