// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/block_trials.h"

#include <algorithm>
#include <array>
#include <memory>

#include "catalog/catalog.h"
#include "gl/headless_context.h"
#include "render/renderer.h"
#include "scene/builtin_mesh.h"
#include "shading/effects/block_trial.h"
#include "shading/program/program_cache.h"

namespace patina {
namespace {

constexpr int side = 16; ///< pixels of the square picture, which nobody sees

std::string nameOf(const Block& block) {
    return block.kind + '/' + block.id;
}

std::string hashIn(const ProgramSource& source, const Block& block) {
    for (const ShaderSource* stage :
         {&source.vertex, &source.fragment, source.geometry ? &*source.geometry : nullptr}) {
        if (stage == nullptr) {
            continue;
        }
        for (const StrangerBlock& stranger : stage->strangers) {
            if (stranger.kind == block.kind && stranger.id == block.id) {
                return stranger.hash;
            }
        }
    }
    return {};
}

/// Compiles and draws blocks one after the other in a context of its own.
class TrialDrawer {
  public:
    explicit TrialDrawer(std::shared_ptr<const Catalog> catalog)
        : catalog_(std::move(catalog)), mesh_(builtinMesh(Object()).value_or(Mesh())) {}

    /// Makes the context and the renderer; false where that fails.
    bool open() {
        context_ = gl::HeadlessContext::create().value_or(nullptr);
        renderer_ = context_ ? Renderer::create({}).value_or(nullptr) : nullptr;
        if (renderer_) {
            renderer_->setCatalog(catalog_);
        }
        return renderer_ != nullptr;
    }

    /// Calls `tell` with the block's hash before the driver gets its code, and with the mistakes
    /// after that.
    void tryOut(const Block& block, const std::function<void(const TrialReport&)>& report) {
        const Checked<ProgramSource> source = trialProgram(block, *catalog_);
        if (!source) {
            report({nameOf(block), true, {}, source.error()});
            return;
        }
        const std::string hash = hashIn(*source, block);
        report({nameOf(block), false, hash});
        const auto program = compileProgram(*source);
        report({nameOf(block), true, hash, program ? drawnMistakes(block) : program.error()});
    }

  private:
    /// Draws the block and returns those messages that are about its own shader file.
    Errors drawnMistakes(const Block& block) {
        View view;
        view.size = {side, side};
        const auto image = renderer_->capture(
            trialScene(block, *catalog_), view, [this](const Object&) { return mesh_.view(); },
            true);
        Errors mistakes;
        const FrameReport& report = renderer_->report();
        std::copy_if(report.messages.begin(), report.messages.end(), std::back_inserter(mistakes),
                     [&](const Error& error) { return error.file == block.shaderFile.string(); });
        return mistakes;
    }

    std::shared_ptr<const Catalog> catalog_;
    Mesh mesh_;
    std::unique_ptr<gl::HeadlessContext> context_;
    std::unique_ptr<Renderer> renderer_;
};

const Block* blockNamed(const Catalog& catalog, const std::string& name) {
    const auto found = std::find_if(catalog.blocks.begin(), catalog.blocks.end(),
                                    [&](const Block& block) { return nameOf(block) == name; });
    return found == catalog.blocks.end() ? nullptr : &*found;
}

} // namespace

void tryBlocks(const TrialRequest& request, const std::function<void(const TrialReport&)>& report) {
    const std::array<BlockRoot, 2> roots{BlockRoot{request.shaders, true},
                                         BlockRoot{request.own, false}};
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(roots));
    TrialDrawer drawer(catalog);
    if (!drawer.open()) {
        report({{}, true});
        return;
    }
    for (const std::string& name : request.blocks) {
        report({name, false});
        const Block* block = blockNamed(*catalog, name);
        if (block == nullptr) {
            report({name, true});
        } else {
            drawer.tryOut(*block, report);
        }
    }
}

} // namespace patina
