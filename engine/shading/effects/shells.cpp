// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/shells.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "catalog/combing_role.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"
#include "shading/program/block_source.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Is the number of layers of a block that offers none to choose from.
constexpr int usualLayers = 16;
constexpr int maxLayers = 256;

/// Returns the whole number that a level is called; 0 where it is none.
int layersNamed(const std::string& level) {
    int layers = 0;
    const auto [end, error] = std::from_chars(level.data(), level.data() + level.size(), layers);
    return error == std::errc() && end == level.data() + level.size() ? layers : 0;
}

/// Returns the accuracy choice whose levels are all whole numbers above 0.
const AccuracyChoice* layersChoice(const Block& block) {
    const auto found = std::ranges::find_if(block.accuracy, [](const AccuracyChoice& choice) {
        return !choice.values.empty() &&
               std::ranges::all_of(
                   choice.values, [](const EnumValue& level) { return layersNamed(level.id) > 0; });
    });
    return found == block.accuracy.end() ? nullptr : &*found;
}

double numberWith(std::string_view role, const Block& block, const Values& values) {
    const Parameter* parameter = block.withRole(role);
    const double* number =
        parameter == nullptr ? nullptr : std::get_if<double>(&givenValue(*parameter, values));
    return number == nullptr ? 0.0 : *number;
}

/// Tells whether the parameter of a role has a value that is part of the program.
bool isCompiledAs(const BlockUse& shells, std::string_view role, std::string_view value) {
    const Parameter* parameter = shells.block().withRole(role);
    const std::vector<CompiledValue> compiled = shells.compiled();
    return parameter != nullptr &&
           std::ranges::count(compiled, CompiledValue{parameter->id, value}) > 0;
}

std::string fieldOf(std::string_view role, const Block& block) {
    return fieldName(block.withRole(role)->id);
}

/// Adds the block, with `Shells` for its struct and `unpackShells` for what fills it.
void addShellsBlock(SurfaceText& text, const BlockUse& use) {
    const Block& block = use.block();
    text.readFrom("objectData");
    text.out.addFile("lib/strand.glsl");
    text.addBlock(block);
    text.addUnpack(use, "unpackShells");
    const std::string function = functionName(block);
    text.out.add(fmt::format("#define SHELL_LAYERS {}\n#define Shells {}\n"
                             "#define shellsOwn {}\n",
                             shellLayers(use), structName(block), function));
    for (const char* suffix : {"Offset", "Radius", "Curl", "Tint"}) {
        text.out.add(fmt::format("#define shells{0} {1}{0}\n", suffix, function));
    }
    text.out.add(fmt::format("#define SHELLS_LENGTH(p) (p).{}\n", fieldOf(roles::length, block)));
}

/// Writes the image of the combing, if there is one, and returns the statement that changes the
/// values `p` by it: a direction in place of that of the values or added to it, or, multiplied, how
/// far strands are combed the way of the values.
std::string writeCombing(SurfaceText& text) {
    std::string statements;
    for (std::size_t i = 0; i < text.set.textures.size(); ++i) {
        const BoundTexture& image = text.set.textures[i];
        if (image.parameter == nullptr || image.parameter->role != roles::combing ||
            image.kind != kinds::shells) {
            continue;
        }
        text.out.add(fmt::format("uniform sampler2D {};\n", samplerName(i)));
        text.out.addFile("passes/shells_combed.vert");
        const std::string field = "p." + fieldName(image.parameter->id);
        const std::string made = image.mode == TextureMode::Add ? field + " + combed.xyz"
                                 : image.mode == TextureMode::Multiply
                                     ? field + " * length(combed.xyz)"
                                     : "combed.xyz";
        statements += fmt::format("    vec4 combed = combedTowards(textureLod({0}, "
                                  "vertexImagePlace({1}), 0.0).rgb, {1});\n"
                                  "    {2} = mix({2}, {3}, combed.w);\n",
                                  samplerName(i), text.object.texture(i), field, made);
    }
    return statements;
}

} // namespace

ShellsChoice shellsChoice(const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kinds::shells);
    if (part == nullptr) {
        return {};
    }
    const Block* block = catalog.find(kinds::shells, part->id);
    if (block == nullptr) {
        return {nullptr, nullptr, "No shells of this kind are known."};
    }
    if (!(numberWith(roles::length, *block, part->parameters) > 0.0)) {
        return {nullptr, nullptr, "Its strands are 0 metres long."};
    }
    if (!(numberWith(roles::density, *block, part->parameters) > 0.0)) {
        return {nullptr, nullptr, "Its density is 0: no strand grows."};
    }
    if (isTransparent(material, catalog)) {
        return {nullptr, nullptr, "The material is transparent: strands grow on solid ones."};
    }
    return {block, &part->parameters, ""};
}

double shellsLength(const Material& material, const Catalog& catalog) {
    const ShellsChoice choice = shellsChoice(material, catalog);
    return choice.block == nullptr ? 0.0 : numberWith(roles::length, *choice.block, *choice.values);
}

int shellLayers(const BlockUse& shells) {
    const AccuracyChoice* choice = layersChoice(shells.block());
    return choice == nullptr ? usualLayers
                             : std::clamp(layersNamed(shells.level(*choice).id), 1, maxLayers);
}

int layersOver(const Material& material, const Catalog& catalog) {
    const ShellsChoice choice = shellsChoice(material, catalog);
    return choice.block == nullptr
               ? 0
               : shellLayers(BlockUse(*choice.block, *choice.values, material.accuracy));
}

void ShellsEffect::choose(const MaterialSubject& subject, const EffectSet&) {
    const ShellsChoice choice = shellsChoice(subject.material, subject.catalog);
    shells.reset();
    if (choice.block != nullptr) {
        shells.emplace(*choice.block, *choice.values, subject.material.accuracy);
    }
}

void ShellsEffect::list(EffectListing& listing, const EffectSet&) const {
    if (shells) {
        listing.add(*shells, always("Strands grow on the material's surface."));
    }
}

void ShellsEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const Material* material = listing.subject().material;
    const BlockValues* part = material == nullptr ? nullptr : material->part(kinds::shells);
    if (part != nullptr && !shells) {
        listing.add(effectName(kinds::shells, part->id),
                    shellsChoice(*material, listing.subject().catalog).whyNot);
    }
}

void ShellsEffect::place(ObjectLayout& layout, const EffectSet&) const {
    if (shells) {
        layout.parts.push_back(placed(*shells, layout.vec4s));
    }
}

/// Has all that asks the model from here on ask for its light on the strand.
void ShellsEffect::writeLight(SurfaceText& text) const {
    if (!text.drawsShells() || !text.set.model) {
        return;
    }
    text.out.add(fmt::format("#define STRAND_MODEL(d, p) {}\n",
                             lightsStrands(*shells) ? "strandLight(d)" : "shadeModel(d, p)"));
    text.out.addFile("passes/shells_light.glsl");
    text.out.add("#undef shadeModel\n#define shadeModel shellsModel\n");
    text.unasked = "shellsAround() * ";
}

void ShellsEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::shells) {
        removePart(scene, effect);
    }
}

int instancesOf(const EffectSet& set) {
    return set.shells ? 1 + shellLayers(*set.shells) : 1;
}

void writeShells(SurfaceText& text) {
    const BlockUse& use = *text.set.shells;
    const Block& block = use.block();
    addShellsBlock(text, use);
    text.out.add(text.isOfFins ? "in float finShare;\n#define IS_FIN true\n"
                                 "#define FIN_SHARE finShare\n"
                               : "#define IS_FIN false\n#define FIN_SHARE 1.0\n");
    text.out.addFile("passes/shells.glsl");
    const std::string length = "shells." + fieldOf(roles::length, block);
    const std::string density = "shells." + fieldOf(roles::density, block);
    text.main +=
        fmt::format("    shells = unpackShells({});\n", text.object.part(kinds::shells)->first);
    const std::string images = text.textures.values(kinds::shells, "shells");
    if (images.empty()) {
        text.main += fmt::format("    growStrand(1.0, {}, 1.0);\n", density);
    } else {
        text.main += fmt::format("    float longest = {0};\n    float densest = {1};\n{2}"
                                 "    growStrand(min({0} / longest, 1.0), densest, "
                                 "min({1} / densest, 1.0));\n",
                                 length, density, images);
    }
    text.main += "    s = shellSurface(s);\n";
    if (lightsStrands(use)) {
        text.out.addFile("passes/shells_strands.glsl");
        text.main += "    turnStrand(s);\n";
    }
}

std::string writeShellsVertex(SurfaceText& text) {
    const BlockUse& use = *text.set.shells;
    addShellsBlock(text, use);
    const bool isAlong = lightsStrands(use);
    text.out.add(isAlong ? "void placeStrand(Shells p);\n#define PLACE_STRAND(p) placeStrand(p)\n"
                         : "#define PLACE_STRAND(p)\n");
    text.out.addFile("passes/shells.vert");
    if (isAlong) {
        text.out.addFile("passes/shells_along.vert");
    }
    if (text.isOfFins) {
        text.out.addFile("passes/fins.vert");
    }
    const char* place = text.isOfFins ? "placeFin" : "placeShell";
    const std::string unpacked =
        fmt::format("unpackShells({})", text.object.part(kinds::shells)->first);
    const std::string combing = writeCombing(text);
    return combing.empty()
               ? fmt::format("    {}({});\n", place, unpacked)
               : fmt::format("    Shells p = {};\n{}    {}(p);\n", unpacked, combing, place);
}

bool lightsStrands(const BlockUse& shells) {
    return isCompiledAs(shells, roles::lighting, "strand");
}

bool hasFins(const BlockUse& shells) {
    return isCompiledAs(shells, roles::fins, "true");
}

bool hasFins(const Material& material, const Catalog& catalog) {
    const ShellsChoice choice = shellsChoice(material, catalog);
    const Parameter* fins = choice.block == nullptr ? nullptr : choice.block->withRole(roles::fins);
    const bool* wanted =
        fins == nullptr ? nullptr : std::get_if<bool>(&givenValue(*fins, *choice.values));
    return wanted != nullptr && *wanted;
}

} // namespace patina
