// SPDX-License-Identifier: GPL-3.0-or-later
// What each model costs per pixel: beside the matte surface, and beside the same formula written as
// books print it.
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "gl/framebuffer.h"
#include "gl/headless_context.h"
#include "gl/vertex_array.h"
#include "model_program.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int rounds = 41;
constexpr int framesPerRound = 3;

/// The most that a stable form may cost of its textbook form; the others only count for the median.
const std::map<std::string_view, double> limits = {
    {"ashikhmin-shirley", 1.0}, {"blinn-phong", 1.45},     {"cook-torrance", 1.0},
    {"gaussian", 1.45},         {"heidrich-seidel", 1.45}, {"oren-nayar", 1.0},
    {"phong", 1.45},            {"schlick", 1.45},         {"strauss", 1.45},
    {"ward", 1.0}};
constexpr double medianLimit = 1.0;

struct Contest {
    const Block* model = nullptr;
    ModelProgram stable;
    std::optional<ModelProgram> textbook;
    std::vector<double> gross;  ///< seconds per pixel
    std::vector<double> net;    ///< without what every program pays
    std::vector<double> ratios; ///< net, to the textbook form
};

ModelProgram linkedOrExit(Checked<ModelProgram> program, const std::string& name) {
    if (!program) {
        for (const Error& error : program.error()) {
            fmt::print(stderr, "{}: {}\n", name, text(error));
        }
        std::exit(2);
    }
    return std::move(*program);
}

std::vector<Contest> contests(const Catalog& catalog) {
    const auto folder =
        std::filesystem::path(PATINA_SOURCE_DIR) / "tests" / "benchmarks" / "textbook";
    std::vector<Contest> all;
    for (const Block* model : catalog.ofKind("models")) {
        const auto file = folder / (model->id + ".glsl");
        Contest contest{model, linkedOrExit(ModelProgram::link(catalog, *model), model->id),
                        {}, {}, {}, {}};
        if (exists(file)) {
            contest.textbook =
                linkedOrExit(ModelProgram::link(catalog, *model, file), file.string());
        }
        all.push_back(std::move(contest));
    }
    return all;
}

void run(Contest& contest, const ModelProgram& empty) {
    const double base = empty.secondsPerPixel(framesPerRound);
    const double stable = contest.stable.secondsPerPixel(framesPerRound);
    contest.gross.push_back(stable);
    contest.net.push_back(stable - base);
    if (contest.textbook) {
        const double textbook = contest.textbook->secondsPerPixel(framesPerRound) - base;
        contest.ratios.push_back((stable - base) / std::max(textbook, 1e-12));
    }
}

/// A target to draw to, bound as long as it lives.
class Target {
  public:
    Target()
        : color_(gl::Renderbuffer::create({ModelProgram::targetSize, ModelProgram::targetSize},
                                          GL_RGBA16F, 0)) {
        framebuffer_.attachColor(color_);
        glViewport(0, 0, ModelProgram::targetSize, ModelProgram::targetSize);
        vertices_.bind();
    }

  private:
    gl::Renderbuffer color_;
    gl::Framebuffer framebuffer_ = gl::Framebuffer::create();
    gl::VertexArray vertices_ = gl::VertexArray::create();
};

void printCost(const Contest& contest, double matte) {
    const Spread gross = spreadOf(contest.gross);
    report(contest.model->id + ": per pixel",
           fmt::format("{}, {:.2f} x lambert, net {:.2f}", text(gross, 1e9, "ns"),
                       gross.median / matte, spreadOf(contest.net).median * 1e9),
           true, "");
}

bool printRatio(const Contest& contest) {
    const Spread ratio = spreadOf(contest.ratios);
    const auto limit = limits.find(contest.model->id);
    const bool kept = limit == limits.end() || ratio.median <= limit->second;
    report(contest.model->id + ": stable / textbook form", text(ratio, 1.0, ""), kept,
           limit == limits.end() ? "" : fmt::format("<= {}", limit->second));
    return kept;
}

bool print(const std::vector<Contest>& all) {
    const auto matte = std::ranges::find(
        all, "lambert", [](const Contest& contest) { return contest.model->id; });
    bool kept = true;
    std::vector<double> medians;
    for (const Contest& contest : all) {
        printCost(contest, spreadOf(matte->gross).median);
    }
    for (const Contest& contest : all) {
        if (!contest.ratios.empty()) {
            kept = printRatio(contest) && kept;
            medians.push_back(spreadOf(contest.ratios).median);
        }
    }
    const Spread middle = spreadOf(medians);
    report("All models: stable / textbook form", text(middle, 1.0, ""),
           middle.median <= medianLimit, fmt::format("<= {}", medianLimit));
    return kept && middle.median <= medianLimit;
}

} // namespace

bool modelCost() {
    const auto context = gl::HeadlessContext::create().value();
    const Catalog catalog = loadCatalog(standardBlockRoots());
    const Target target;
    const ModelProgram empty = linkedOrExit(ModelProgram::linkEmpty(catalog), "model_cost.frag");
    std::vector<Contest> all = contests(catalog);
    for (int round = 0; round < rounds; ++round) {
        for (Contest& contest : all) {
            run(contest, empty);
        }
    }
    return print(all);
}

} // namespace patina::benchmarks
