// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/model.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/parameter_layout.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/highlight_width.h"
#include "shading/effects/surface_text.h"
#include "shading/program/block_source.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Two values are the same everywhere only while no image changes one of them.
void forgetEqualOfTextured(BlockUse& use, const EffectSet& set) {
    const auto hasImage = [&](std::string_view id) {
        return std::ranges::any_of(set.textures, [&](const BoundTexture& texture) {
            return texture.kind == use.block().kind && texture.parameter->id == id;
        });
    };
    for (const Parameter& parameter : use.block().parameters) {
        if (use.isEqual(parameter) && (hasImage(parameter.id) || hasImage(parameter.equalTo))) {
            use.setUnequal(parameter);
        }
    }
}

/// Returns the condition under which the model counts as 0 without being asked.
std::string gateSource(const Block& model) {
    std::string condition;
    if (model.hasGate("light")) {
        condition = "(d).nl <= 0.0";
    }
    if (model.hasGate("view")) {
        condition += condition.empty() ? "(d).nv <= 0.0" : " || (d).nv <= 0.0";
    }
    return condition.empty() ? "false" : condition;
}

/// Returns what keeps a model's value from being negative: nothing, where it says that it never is,
/// which it says of unit normals. (What is stored is cut anyway.)
const char* cutSource(const Block& model, bool hasUnitNormals) {
    const bool isKept = std::ranges::find(model.claims, "non_negative") != model.claims.end();
    return isKept && hasUnitNormals ? "(color)" : "max(color, vec3(0.0))";
}

/// Widens highlights by the curvature of the surface, after images have changed their widths.
void writeWideHighlights(SurfaceText& text) {
    text.out.addFile("lib/math.glsl");
    text.out.addFile("passes/widened_highlight.glsl");
    text.main += "    float spread = highlightSpread(s.n);\n" +
                 widenedSource(text.set.model->block(), "model");
    for (const BlockUse& slot : text.set.slots) {
        text.main += widenedSource(slot.block(), "model." + slot.block().kind);
    }
}

} // namespace

void ModelEffect::choose(const MaterialSubject& subject, const EffectSet&) {
    const Material& material = subject.material;
    const Block* block = subject.catalog.find(kinds::models, material.model.id);
    model.reset();
    if (block != nullptr && areSlotsFilled(*block, subject)) {
        model.emplace(*block, material.model.parameters, material.accuracy);
    }
}

void ModelEffect::adjust(const EffectSet& set) {
    if (model) {
        forgetEqualOfTextured(*model, set);
        makeTexturedExact(*model, set);
    }
}

void ModelEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (!model) {
        return;
    }
    std::string detail = detailed(compiledText(*model), set.lightsAtVertices, "lit per vertex");
    detail = detailed(std::move(detail), set.leavesNormals, "normals as blended");
    listing.add(effectName(*model),
                detailed(std::move(detail), set.widensHighlights, "highlights widened"),
                always("The material's model."));
}

/// "Roughness x and roughness y are both 0.3.": which difference is not in the program.
void ModelEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const Material* material = listing.subject().material;
    if (material == nullptr) {
        return;
    }
    if (listing.subject().catalog.find(kinds::models, material->model.id) == nullptr) {
        listing.add("the model", fmt::format("No model \"{}\" is known; a plain fallback is drawn.",
                                             material->model.id));
    }
    if (!model) {
        return;
    }
    for (const Parameter& parameter : model->block().parameters) {
        const Value& both = givenValue(parameter, material->model.parameters);
        const auto* number = std::get_if<double>(&both);
        if (model->isEqual(parameter) && number != nullptr) {
            listing.add("anisotropy",
                        fmt::format("{} and {} are both {:.4g}.",
                                    model->block().parameter(parameter.equalTo)->label,
                                    parameter.label, *number));
        }
    }
}

void ModelEffect::place(ObjectLayout& layout, const EffectSet&) const {
    if (model) {
        layout.model = placed(*model, layout.vec4s);
        layout.tables.add(*layout.model, *model, TableReader::Model);
    }
}

/// Returns the function that leaves only the highlight of a model's parameters, and whether it can.
std::string leaveHighlightSource(const Block& model) {
    std::string body;
    for (const ParameterField& field : layoutOf(model).fields) {
        if (field.parameter != nullptr && field.parameter->role == roles::diffuse) {
            body += fmt::format("    p.{} = vec3(0.0);\n", field.name);
        }
    }
    return fmt::format("const bool HAS_TERMS = {};\nvoid leaveHighlight(inout Model p) {{\n{}}}\n",
                       body.empty() ? "false" : "true", body);
}

void writeModel(SurfaceText& text) {
    const BlockUse& use = *text.set.model;
    const Block& model = use.block();
    writeSlots(text);
    const std::vector<CompiledValue> compiled = use.compiled();
    text.addBlock(model, compiled);
    text.out.add(unpackSource(model, {"unpackModel", compiled, text.filled}));
    text.out.add(fmt::format("#define Model {}\n#define {} {}\n#define IS_DARK(d) ({})\n"
                             "#define IS_UNLIT(nl) ({})\n"
                             "#define CUT_AT_ZERO(color) {}\n",
                             structName(model), text.isInspected() ? "modelValue" : "shadeModel",
                             functionName(model), gateSource(model),
                             isLitFromBehind(text) ? "false" : "(nl) <= 0.0",
                             cutSource(model, !text.leavesNormals())));
    if (text.isInspected()) {
        text.out.add(leaveHighlightSource(model));
        text.out.addFile("passes/inspected_model.glsl");
        text.out.add("#define shadeModel inspectedModel\n");
    }
    text.main += fmt::format("    Model model = unpackModel({});\n", text.object.model->first);
    if (!isTable(text.output)) {
        text.main += text.textures.values(kinds::models, "model");
        for (const SlotFill& slot : text.filled) {
            text.main += text.textures.values(slot.kind, fmt::format("model.{}", slot.kind));
        }
    }
    if (text.isPicture() && text.set.widensHighlights) {
        writeWideHighlights(text);
    }
    if (text.isInspected() && model.slot(kinds::fresnel) != nullptr) {
        text.main += "    fresnelTerm = vec4(vec3(slotFresnel(incidenceBetween(s.n, s.v), "
                     "model.fresnel)), 1.0);\n";
        text.out.addFile("lib/incidence.glsl");
    }
}

void ModelEffect::writeLight(SurfaceText& text) const {
    if (model) {
        writeModel(text);
    }
}

bool isLitFromBehind(const SurfaceText& text) {
    return text.set.model && !text.set.model->block().hasGate("light");
}

std::string_view ModelEffect::whyPerPixel(const EffectSet& set) const {
    return set.model && drawsMarks(set.model->block()) ? "the model draws marks."
                                                       : std::string_view();
}

/// What fills its slots goes along: without a model nobody calls it.
void ModelEffect::remove(Scene& scene, const EffectName& effect, const Catalog& catalog) {
    if (effect.kind != kinds::models) {
        return;
    }
    const Block* model = catalog.find(kinds::models, effect.id);
    for (Object& object : scene.objects) {
        if (object.material.model.id != effect.id) {
            continue;
        }
        object.material.model = BlockValues();
        for (const Slot& slot : model != nullptr ? model->slots : std::vector<Slot>()) {
            object.material.parts.erase(slot.kind);
        }
    }
}

} // namespace patina
