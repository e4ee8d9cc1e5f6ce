// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/strokes.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"
#include "shading/program/block_source.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Is how many marks of full size may lie over a place on average.
constexpr double maxMarksOver = 32.0;

/// Densities are those of a square of so many square units.
constexpr double densityArea = 100.0 * 100.0;

/// Returns the whole number of percent that a level is called; 0 where it is none.
int percentNamed(const std::string& level) {
    int percent = 0;
    const auto [end, error] = std::from_chars(level.data(), level.data() + level.size(), percent);
    const bool isWhole = error == std::errc() && end == level.data() + level.size();
    return isWhole && percent <= 100 ? percent : 0;
}

/// Returns the accuracy choice whose levels are all whole numbers of percent.
const AccuracyChoice* marksChoice(const Block& block) {
    const auto found = std::ranges::find_if(block.accuracy, [](const AccuracyChoice& choice) {
        return !choice.values.empty() &&
               std::ranges::all_of(choice.values, [](const EnumValue& level) {
                   return percentNamed(level.id) > 0;
               });
    });
    return found == block.accuracy.end() ? nullptr : &*found;
}

double strokesNumber(std::string_view role, const Block& block, const Values& values) {
    const Parameter* parameter = block.withRole(role);
    const double* number =
        parameter == nullptr ? nullptr : std::get_if<double>(&givenValue(*parameter, values));
    return number == nullptr ? 0.0 : *number;
}

/// Returns the text that reads the field of a role from the struct `p`.
std::string readOf(std::string_view role, const Block& block) {
    return "(p)." + fieldName(block.withRole(role)->id);
}

/// Adds the block, with `Strokes` for its struct and `unpackStrokes` for what fills it.
void addStrokesBlock(SurfaceText& text, const BlockUse& use) {
    const Block& block = use.block();
    text.readFrom("objectData");
    text.out.addFile("lib/mark_point.glsl");
    text.addBlock(block);
    text.addUnpack(use, "unpackStrokes");
    const std::string function = functionName(block);
    text.out.add(
        fmt::format("#define Strokes {}\n#define strokesInk {}\n", structName(block), function));
    for (const char* suffix : {"Share", "Size", "Along", "Shape", "Opacity", "Under"}) {
        text.out.add(fmt::format("#define strokes{0} {1}{0}\n", suffix, function));
    }
}

std::string unpackText(const SurfaceText& text) {
    return fmt::format("unpackStrokes({})", text.object.part(kinds::strokes)->first);
}

} // namespace

StrokesChoice strokesChoice(const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kinds::strokes);
    if (part == nullptr) {
        return {};
    }
    const Block* block = catalog.find(kinds::strokes, part->id);
    if (block == nullptr) {
        return {nullptr, nullptr, "No strokes of this kind are known."};
    }
    const auto hasNo = [&](std::string_view role) {
        return !(strokesNumber(role, *block, part->parameters) > 0.0);
    };
    if (hasNo(roles::density)) {
        return {nullptr, nullptr, "Its density is 0: there are no marks."};
    }
    if (hasNo(roles::length) || hasNo(roles::width)) {
        return {nullptr, nullptr, "Its marks are 0 pixels long or wide."};
    }
    if (isTransparent(material, catalog)) {
        return {nullptr, nullptr, "The material is transparent: marks are set on solid ones."};
    }
    if (shellsChoice(material, catalog).block != nullptr) {
        return {nullptr, nullptr, "Fur or grass grows over the surface and would hide them."};
    }
    return {block, &part->parameters, ""};
}

double marksPerUnit(const Material& material, const Catalog& catalog) {
    const StrokesChoice choice = strokesChoice(material, catalog);
    if (choice.block == nullptr) {
        return 0.0;
    }
    const auto number = [&](std::string_view role) {
        return strokesNumber(role, *choice.block, *choice.values);
    };
    const double limit = maxMarksOver / (number(roles::length) * number(roles::width));
    const BlockUse use(*choice.block, *choice.values, material.accuracy);
    return shareOfMarks(use) * std::min(number(roles::density) / densityArea, limit);
}

double shareOfMarks(const BlockUse& strokes) {
    const AccuracyChoice* choice = marksChoice(strokes.block());
    return choice == nullptr ? 1.0 : 0.01 * percentNamed(strokes.level(*choice).id);
}

void StrokesEffect::choose(const MaterialSubject& subject, const EffectSet&) {
    const StrokesChoice choice = strokesChoice(subject.material, subject.catalog);
    strokes.reset();
    if (choice.block != nullptr) {
        strokes.emplace(*choice.block, *choice.values, subject.material.accuracy);
    }
}

void StrokesEffect::list(EffectListing& listing, const EffectSet&) const {
    if (!strokes) {
        return;
    }
    listing.add(*strokes, [](const EffectSubject& subject) -> std::string {
        const StrokesChoice choice = subject.material == nullptr
                                         ? StrokesChoice()
                                         : strokesChoice(*subject.material, subject.catalog);
        const bool isCut = choice.block != nullptr &&
                           strokesNumber(roles::density, *choice.block, *choice.values) *
                                   strokesNumber(roles::length, *choice.block, *choice.values) *
                                   strokesNumber(roles::width, *choice.block, *choice.values) >
                               maxMarksOver * densityArea;
        return isCut ? "The material has marks on its surface; no more of them than 32 over a "
                       "pixel are drawn."
                     : "The material has marks on its surface.";
    });
}

void StrokesEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const Material* material = listing.subject().material;
    const BlockValues* part = material == nullptr ? nullptr : material->part(kinds::strokes);
    if (part != nullptr && !strokes) {
        listing.add(effectName(kinds::strokes, part->id),
                    strokesChoice(*material, listing.subject().catalog).whyNot);
    }
}

void StrokesEffect::place(ObjectLayout& layout, const EffectSet&) const {
    if (strokes) {
        layout.parts.push_back(placed(*strokes, layout.vec4s));
    }
}

/// The surface becomes what lies under the marks, and a mark its own ink.
void StrokesEffect::write(SurfaceText& text) const {
    if (!text.drawsStrokes()) {
        return;
    }
    if (text.isOfMarks) {
        text.out.addFile(areStanding(*strokes) ? "passes/strokes_standing.glsl"
                                               : "passes/strokes_painted.glsl");
        text.main += "    shaded = markInk(s, shaded);\n";
        text.alpha = "markAlpha";
        return;
    }
    addStrokesBlock(text, *strokes);
    text.out.addFile("passes/strokes_under.glsl");
    text.main += fmt::format("    shaded = underMarks(s, shaded, {});\n", unpackText(text));
}

void StrokesEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::strokes) {
        removePart(scene, effect);
    }
}

void writeMarks(SurfaceText& text) {
    addStrokesBlock(text, *text.set.strokes);
    text.out.addFile("passes/strokes.glsl");
    text.main += fmt::format("    beginMark({});\n", unpackText(text));
}

std::string writeMarksVertex(SurfaceText& text) {
    const BlockUse& use = *text.set.strokes;
    const Block& block = use.block();
    addStrokesBlock(text, use);
    const double share = shareOfMarks(use);
    text.out.add(fmt::format("#define MARK_SHARE {:.2f}\n#define IS_STANDING {}\n"
                             "#define MARK_DENSITY(p) min({} * {}, {:.1f} / max({} * {}, 1e-6))\n",
                             share, areStanding(use), readOf(roles::density, block),
                             1.0 / densityArea, maxMarksOver, readOf(roles::length, block),
                             readOf(roles::width, block)));
    text.out.addFile("passes/strokes.vert");
    return fmt::format("    placeMark({});\n", unpackText(text));
}

bool areStanding(const BlockUse& strokes) {
    const Parameter* layering = strokes.block().withRole(roles::layering);
    const std::vector<CompiledValue> compiled = strokes.compiled();
    return layering != nullptr &&
           std::ranges::count(compiled, CompiledValue{layering->id, "standing"}) > 0;
}

} // namespace patina
