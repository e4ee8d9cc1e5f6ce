// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/passes_effect.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/picture_roles.h"
#include "shading/effects/neutral_values.h"
#include "shading/program/block_source.h"
#include "shading/program/source_builder.h"

namespace patina {
namespace {

std::string reasonFor(const Block& block) {
    const std::size_t stages = block.picture.stages.size();
    std::string reason = "It works over the finished picture.";
    if (stages > 0) {
        reason +=
            fmt::format(" Before its result it draws {} image{}.", stages, stages > 1 ? "s" : "");
    }
    if (block.picture.readsSurfaces) {
        reason += " Depths, normals and objects are drawn for it.";
    }
    return reason;
}

void addBegin(SourceBuilder& fragment, const BlockUse& pass) {
    const Block& block = pass.block();
    fragment.addFile("passes/picture.glsl");
    fragment.addFile(block.picture.isLinear ? "passes/picture_linear.glsl"
                                            : "passes/picture_display.glsl");
    if (block.picture.readsSurfaces) {
        fragment.addFile("passes/picture_surface.glsl");
    }
    if (block.withRole(roles::threshold) != nullptr) {
        fragment.addFile("passes/picture_threshold.glsl");
    }
    if (const int vec4s = vec4Count(block); vec4s > 0) {
        fragment.add(fmt::format("uniform vec4 passData[{}];\n", vec4s));
    }
    fragment.add(unpackedFrom("passData"));
    fragment.add(constantsSource(block) + structSource(block, pass.compiled()));
    fragment.addBlock(block);
    fragment.add(unpackSource(block, {"unpackPass", pass.compiled()}));
}

std::string stageCall(const Block& block, std::string_view stage) {
    return fmt::format("kept({}{}(picturePoint(), unpackPass(0)))", functionName(block), stage);
}

std::string resultCall(const Block& block) {
    return fmt::format("shownColor({}(picturePoint(), unpackPass(0)))", functionName(block));
}

/// Returns the word that a pass has for a state; nothing for that of a pass without one.
std::string_view stateOf(const BlockUse& pass, std::string_view role) {
    const Parameter* parameter = pass.block().withRole(role);
    for (const CompiledValue& value : pass.compiled()) {
        if (parameter != nullptr && value.id == parameter->id) {
            return value.value;
        }
    }
    return {};
}

/// Returns the function that puts the picture and what the pass returns together.
std::string_view blendFunction(std::string_view word) {
    return word == "multiply" ? "pictureMultiply"
           : word == "screen" ? "pictureScreen"
           : word == "add"    ? "pictureAdd"
                              : "pictureOver";
}

bool isBlended(const BlockUse& pass) {
    const std::string_view word = stateOf(pass, roles::blend);
    return !word.empty() && word != "replace";
}

bool isTested(const BlockUse& pass) {
    const std::string_view word = stateOf(pass, roles::depthTest);
    return !word.empty() && word != "everywhere";
}

/// Returns the main function that draws a pass's result with its state; that of a pass without one
/// only stores what it returns.
std::string resultMain(const BlockUse& pass) {
    const Block& block = pass.block();
    if (!isBlended(pass) && !isTested(pass)) {
        return fmt::format("void main() {{\n    drawn = {};\n}}\n", resultCall(block));
    }
    std::string text = fmt::format("void main() {{\n    PicturePoint at = picturePoint();\n"
                                   "    {} p = unpackPass(0);\n"
                                   "    vec3 below = pictureColor(at.pixel);\n"
                                   "    vec3 above = {}(at, p);\n",
                                   structName(block), functionName(block));
    if (isBlended(pass)) {
        const Parameter* amount = block.withRole(roles::blendAmount);
        text += fmt::format("    above = mix(below, {}(below, clamp(above, 0.0, 1.0)), {});\n",
                            blendFunction(stateOf(pass, roles::blend)),
                            amount ? "p." + fieldName(amount->id) : std::string("1.0"));
    }
    if (isTested(pass)) {
        text += fmt::format("    bool isSurface = pictureSurface(at.pixel).number > 0.0;\n"
                            "    above = isSurface == {} ? above : below;\n",
                            stateOf(pass, roles::depthTest) == "surfaces");
    }
    return text + "    drawn = shownColor(above);\n}\n";
}

} // namespace

void PassesEffect::choose(const Scene& scene, const Catalog& catalog) {
    passes.clear();
    for (std::size_t i = 0; i < scene.passes.size(); ++i) {
        const BlockValues& values = scene.passes[i];
        const Block* block = catalog.find(kinds::pass, values.id);
        if (block != nullptr && !isNeutral(*block, values.parameters)) {
            passes.push_back({BlockUse(*block, values.parameters), i});
        }
    }
}

void PassesEffect::addTo(ChoiceHash& hash) const {
    for (const PassUse& pass : passes) {
        hash.add(pass.use);
        hash.add(static_cast<std::uint64_t>(pass.place));
    }
}

/// A block that works several times has one row: a row's name is that of the block.
void PassesEffect::list(EffectListing& listing, const DisplaySet&) const {
    for (auto pass = passes.begin(); pass != passes.end(); ++pass) {
        const auto isSame = [pass](const PassUse& other) {
            return &other.use.block() == &pass->use.block();
        };
        if (std::any_of(passes.begin(), pass, isSame)) {
            continue;
        }
        const auto times = std::count_if(pass, passes.end(), isSame);
        listing.add(effectName(pass->use),
                    detailed(compiledText(pass->use), times > 1, fmt::format("{} times", times)),
                    always(reasonFor(pass->use.block())));
    }
}

void PassesEffect::listMissing(LeftOutListing& listing, const DisplaySet&) const {
    const EffectSubject& subject = listing.subject();
    for (const BlockValues& values : subject.scene.passes) {
        const Block* block = subject.catalog.find(kinds::pass, values.id);
        if (block == nullptr) {
            listing.add(effectName(kinds::pass, values.id),
                        fmt::format("No picture pass \"{}\" is known.", values.id));
        } else if (isNeutral(*block, values.parameters)) {
            listing.add(effectName(kinds::pass, values.id), whyNeutral(*block, values.parameters));
        }
    }
    if (subject.scene.passes.empty()) {
        listing.add(std::string(kinds::pass), "None works over the picture.");
    }
}

void PassesEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::pass) {
        std::erase_if(scene.passes,
                      [&effect](const BlockValues& pass) { return pass.id == effect.id; });
    }
}

bool PassesEffect::readSurfaces() const {
    return std::ranges::any_of(
        passes, [](const PassUse& pass) { return pass.use.block().picture.readsSurfaces; });
}

Checked<ProgramSource> pictureProgram(const BlockUse& pass, std::string_view stage,
                                      const Catalog& catalog) {
    return screenProgram(catalog, [&](SourceBuilder& fragment) {
        addBegin(fragment, pass);
        const Block& block = pass.block();
        if (!stage.empty()) {
            fragment.add(
                fmt::format("void main() {{\n    drawn = {};\n}}\n", stageCall(block, stage)));
            return;
        }
        if (isBlended(pass)) {
            fragment.addFile("passes/picture_blend.glsl");
        }
        fragment.add(resultMain(pass));
    });
}

Checked<ProgramSource> pictureSurfacesProgram(const Catalog& catalog) {
    return program(
        catalog,
        [](SourceBuilder& vertex) {
            vertex.add("#define OBJECT_VEC4S 1\n");
            vertex.addFile("passes/surface.vert");
            vertex.add("void main() {\n    placeSurface();\n}\n");
        },
        [](SourceBuilder& fragment) { fragment.addFile("passes/picture_surfaces.glsl"); });
}

Checked<ProgramSource> pictureTrialProgram(const BlockUse& pass, const Catalog& catalog) {
    return screenProgram(catalog, [&](SourceBuilder& fragment) {
        addBegin(fragment, pass);
        const Block& block = pass.block();
        std::string sum = resultCall(block);
        for (const std::string& stage : block.picture.stages) {
            sum += " + " + stageCall(block, stage);
        }
        fragment.add(fmt::format("void main() {{\n    drawn = {};\n}}\n", sum));
    });
}

} // namespace patina
