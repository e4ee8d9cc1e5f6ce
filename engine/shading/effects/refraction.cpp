// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/refraction.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <string_view>

#include <fmt/format.h>

#include "catalog/wavelength_ray_choices.h"
#include "measured/spectrum_color.h"
#include "shading/effects/body_index.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/refracted_wavelengths.h"
#include "shading/effects/surface_text.h"
#include "shading/program/compiled_block.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

bool isNeutral(const Material& material, const RefractionChoice& choice, const Catalog& catalog) {
    const auto colors = [&choice](const Parameter& parameter) {
        return parameter.role == roles::filter &&
               givenValue(parameter, *choice.values) != Value(glm::dvec3(1.0));
    };
    return std::ranges::none_of(choice.block->parameters, colors) &&
           BodyIndex(material, choice, catalog).channels() == glm::dvec3(1.0);
}

const char* whatIsBehind(const EffectSet& set) {
    if (set.isShownRefracted) {
        return set.environment ? "the scene and the environment" : "the scene";
    }
    return set.environment ? "the environment" : "the background's colour";
}

std::string indexText(const BodyIndex& index) {
    const glm::dvec3& each = index.channels();
    return index.bendsApart()
               ? fmt::format("indices of {:.4g}, {:.4g} and {:.4g} for red, green and blue", each.x,
                             each.y, each.z)
               : fmt::format("an index of {:.4g}", each.y);
}

std::string refractionText(const EffectSubject& subject, const EffectSet& set) {
    const RefractionChoice choice = refractionChoice(*subject.material, subject.catalog);
    const char* order = subject.scene.part(kinds::transparency)
                            ? " Such objects are sorted, and hide what else is transparent."
                            : "";
    const int wavelengths = set.refraction ? wavelengthCount(*set.refraction) : 0;
    const std::string rays =
        wavelengths > 0 ? fmt::format(", in light of {} wavelengths,", wavelengths) : "";
    const BodyIndex index(*subject.material, choice, subject.catalog, subject.scene.wavelengths);
    const char* mirrored =
        set.mirrorsByTerm ? " What its surface mirrors is by the Fresnel term." : "";
    return fmt::format("What passes is refracted with {}{} and shows {}.{}{}", indexText(index),
                       rays, whatIsBehind(set), mirrored, order);
}

bool bendsColorsApart(const BlockUse& use) {
    const Parameter* dispersion = use.block().withRole(roles::dispersion);
    return dispersion != nullptr &&
           std::ranges::none_of(use.compiled(), [dispersion](const CompiledValue& value) {
               return value.id == dispersion->id && value.value == "zero";
           });
}

/// One ray stands for all colours where they are refracted and mirrored alike: green. Else each
/// wavelength has one, or each channel where the block does not let wavelengths be chosen.
std::string channelSource(const SurfaceText& text, const BlockUse& use) {
    if (const auto wavelengths = wavelengthPlace(text.object)) {
        return fmt::format("#define WAVELENGTHS {}\n#define FIRST_WAVELENGTH {}\n"
                           "#define WAVELENGTH_INDEX {}\n#define WAVELENGTH_DISPERSION {}\n",
                           wavelengths->count, wavelengths->first,
                           fieldName(use.block().withRole(roles::index)->id),
                           fieldName(use.block().withRole(roles::dispersion)->id));
    }
    return bendsColorsApart(use) || text.set.mirrorsByTerm
               ? "#define FIRST_CHANNEL 0\n#define LAST_CHANNEL 2\n"
               : "#define FIRST_CHANNEL 1\n#define LAST_CHANNEL 1\n";
}

/// Writes the way of a ray inside. A sheet's field may be called otherwise than its role.
void writePassage(SurfaceText& text, const Block& block) {
    if (!isSheet(block)) {
        text.out.addFile("passes/refraction_body.glsl");
        return;
    }
    const std::string field = fieldName(block.withRole(roles::thickness)->id);
    const bool isOther = field != roles::thickness;
    text.out.add(isOther ? fmt::format("#define {} {}\n", roles::thickness, field) : "");
    text.out.addFile("passes/refraction_sheet.glsl");
    text.out.add(isOther ? fmt::format("#undef {}\n", roles::thickness) : "");
}

/// Writes the look for what is behind the body, with the rays that a pixel has for it.
void writeBehind(SurfaceText& text, const BlockUse& use) {
    if (!text.set.isShownRefracted) {
        text.out.addFile("passes/refraction_alone.glsl");
        return;
    }
    text.out.addFile("passes/refraction_behind.glsl");
    const AccuracyChoice* choice = rayChoice(use.block());
    const int rays = choice == nullptr ? 1 : rayCount(use.level(*choice)).value_or(1);
    if (rays > 1) {
        text.out.add(fmt::format("#define RAYS_BEHIND {}\n", rays));
        text.out.addFile("passes/refraction_behind_rays.glsl");
    } else {
        text.out.addFile("passes/refraction_behind_ray.glsl");
    }
}

std::string namesSource(const Block& block) {
    const std::string function = functionName(block);
    return fmt::format("#define Refraction {0}\n#define refractedRay {1}\n"
                       "#define mirroredShare {1}Mirrored\n#define leftShare {1}Left\n",
                       structName(block), function);
}

/// Returns the material's Fresnel term that the model calls or that is blended over its light.
const BlockUse* termIn(const EffectSet& set) {
    const auto slot = std::ranges::find(set.slots, kinds::fresnel, [](const BlockUse& use) {
        return std::string_view(use.block().kind);
    });
    return slot != set.slots.end() ? &*slot : set.blend ? &*set.blend : nullptr;
}

int placeOf(const BlockUse& term, const SurfaceText& text) {
    const auto isSlot = [&term](const BlockPlace& place) { return place.block == &term.block(); };
    const auto slot = std::ranges::find_if(text.object.slots, isSlot);
    return slot != text.object.slots.end() ? slot->first : text.object.part(kinds::fresnel)->first;
}

/// Tells whether the term reflects what a clear surface of its index does.
bool isOfIndex(const Block& term) {
    const auto code = compiledBlock(term);
    return term.withRole(roles::indexInside) != nullptr ||
           (code && (*code)->optionalCall(reference::indicesSuffix) != nullptr);
}

/// Tells whether the material's Fresnel term decides what a body mirrors, and its index does not.
bool isMirroredByTerm(const MaterialSubject& subject, const RefractionChoice& choice,
                      const EffectSet& set) {
    const BlockUse* term = termIn(set);
    const BlockValues* part = subject.material.part(kinds::fresnel);
    return term != nullptr && part != nullptr && part->id == term->block().id &&
           !hasOwnIndex(choice) && !isOfIndex(term->block());
}

/// Puts the share that the Fresnel term mirrors in the place of the block's own.
void writeTerm(SurfaceText& text, const Block& refraction, bool bendsApart) {
    const BlockUse& use = *termIn(text.set);
    const Block& term = use.block();
    text.addBlock(term);
    text.addUnpack(use, "unpackTerm");
    text.out.add(fmt::format("#define Term {}\n#define termReflectance {}\n"
                             "#define OF_FACES(share) {}\n",
                             structName(term), functionName(term),
                             isSheet(refraction) ? "paneReflectance(share)" : "(share)"));
    text.out.addFile(bendsApart ? "passes/refraction_term_wavelength.glsl"
                                : "passes/refraction_term_channel.glsl");
    text.out.addFile("passes/refraction_term.glsl");
    text.out.add("#undef mirroredShare\n#define mirroredShare termShare\n");
    text.out.add(bendsApart ? "#define forWavelength termForWavelength\n" : "");
    text.last += fmt::format("    surfaceTerm = unpackTerm({});\n", placeOf(use, text)) +
                 text.textures.values(kinds::fresnel, "surfaceTerm");
}

/// Returns the choice whose levels count reflections inside of a body; null where there is none.
const AccuracyChoice* reflectionChoice(const Block& block) {
    const AccuracyChoice* wavelengths = wavelengthChoice(block);
    const auto found =
        std::ranges::find_if(block.accuracy, [wavelengths](const AccuracyChoice& choice) {
            return &choice != wavelengths &&
                   std::ranges::all_of(choice.values, [](const EnumValue& level) {
                       return wholeNumber(level).has_value();
                   });
        });
    return found == block.accuracy.end() ? nullptr : &*found;
}

/// Returns how many facets a round of the search looks at: a software driver may end a program
/// after 65536 rounds of its loops, and 64 rays of all wavelengths with nine ways inside have
/// fewer.
int facetsAtOnce(int wavelengths) {
    return wavelengths > 9 ? 32 : wavelengths > 5 ? 16 : wavelengths > 3 ? 8 : 4;
}

/// Writes the ways of rays from facet to facet.
void writeFacets(SurfaceText& text, const BlockUse& use) {
    const int wavelengths = wavelengthCount(use);
    text.out.add(fmt::format("#define INNER_REFLECTIONS {}\n#define FACETS_AT_ONCE {}\n",
                             innerReflections(use), facetsAtOnce(wavelengths)));
    text.out.addFile(text.set.environment ? "passes/refraction_facets_environment.glsl"
                                          : "passes/refraction_facets_plain.glsl");
    text.out.addFile(text.set.isShownRefracted ? "passes/refraction_facets_behind.glsl"
                                               : "passes/refraction_facets_alone.glsl");
    text.out.addFile("passes/refraction_facets.glsl");
    text.out.addFile(wavelengths > 0 ? "passes/refraction_facets_colors.glsl"
                                     : "passes/refraction_facets_color.glsl");
    text.out.addFile("passes/refraction_facets_rays.glsl");
}

/// Returns what is compiled of the block, without a number of wavelengths that bend alike, or of
/// rays that look for nothing.
std::string detailOf(const BlockUse& use, const EffectSet& set) {
    const AccuracyChoice* idle = wavelengthCount(use) > 0 ? nullptr : wavelengthChoice(use.block());
    const AccuracyChoice* rays = set.isShownRefracted ? nullptr : rayChoice(use.block());
    std::string text;
    for (const CompiledValue& value : use.compiled()) {
        if ((idle == nullptr || value.id != idle->id) &&
            (rays == nullptr || value.id != rays->id)) {
            text += fmt::format("{}{}={}", text.empty() ? "" : ", ", value.id, value.value);
        }
    }
    return text;
}

/// Finds the wavelengths of each number once.
const std::vector<WavelengthShare>& sharesOf(std::size_t count) {
    static constexpr std::size_t maxCount = 64;
    static std::array<std::vector<WavelengthShare>, maxCount + 1> known;
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    std::vector<WavelengthShare>& shares = known[std::min(count, maxCount)];
    if (shares.empty()) {
        shares = wavelengthShares(static_cast<int>(count));
    }
    return shares;
}

/// Packs the shares of the wavelengths; the indices for them, which depend on the catalogue, are
/// packed with the refraction.
void packShares(std::span<glm::vec4> out, const Material&, const EffectSet&) {
    const std::vector<WavelengthShare>& shares = sharesOf(out.size());
    for (std::size_t i = 0; i < out.size() && i < shares.size(); ++i) {
        out[i] = glm::vec4(glm::vec3(shares[i].shares), shares[i].wavelength);
    }
}

/// Writes what is seen where a ray leaves everything.
void writeDistance(SurfaceText& text) {
    if (!text.set.environment) {
        text.out.add(
            fmt::format("#define REFRACTION_BACKGROUND {}\n", text.object.refractionBackground()));
        text.out.addFile("passes/refraction_plain.glsl");
        return;
    }
    if (!text.set.model) {
        addEnvironment(text.out, *text.set.environment);
    }
    text.out.addFile("passes/environment_points.glsl");
    text.out.addFile("passes/refraction_environment.glsl");
}

} // namespace

RefractionChoice refractionChoice(const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kinds::refraction);
    if (part == nullptr) {
        return {};
    }
    const RefractionChoice choice{catalog.find(kinds::refraction, part->id), &part->parameters, ""};
    if (choice.block == nullptr) {
        return {nullptr, nullptr, "No refraction of this kind is known."};
    }
    if (!isTransparent(material, catalog)) {
        return {nullptr, nullptr, "The material's opacity is 1: nothing passes."};
    }
    if (isNeutral(material, choice, catalog)) {
        return {nullptr, nullptr, "Its index is 1 and it colours nothing."};
    }
    return choice;
}

int wavelengthCount(const BlockUse& refraction) {
    const AccuracyChoice* choice = wavelengthChoice(refraction.block());
    return choice == nullptr || !bendsColorsApart(refraction)
               ? 0
               : wholeNumber(refraction.level(*choice)).value_or(0);
}

int innerReflections(const BlockUse& refraction) {
    const AccuracyChoice* choice = reflectionChoice(refraction.block());
    return choice == nullptr ? 0 : wholeNumber(refraction.level(*choice)).value_or(0);
}

std::optional<WavelengthPlace> wavelengthPlace(const ObjectLayout& layout) {
    const auto found = std::ranges::find_if(
        layout.own, [](const ObjectLayout::Place& place) { return place.pack == packShares; });
    return found == layout.own.end() ? std::nullopt
                                     : std::optional(WavelengthPlace{found->first, found->vec4s});
}

bool isSheet(const Block& refraction) {
    return refraction.withRole(roles::thickness) != nullptr;
}

bool followsFacets(const Block& refraction) {
    return reflectionChoice(refraction) != nullptr;
}

bool hasRefraction(const Scene& scene, const Catalog& catalog) {
    return std::ranges::any_of(scene.objects, [&catalog](const Object& object) {
        return isDrawn(object) && refractionChoice(object.material, catalog).block != nullptr;
    });
}

bool showsSceneRefracted(const Scene& scene, const Catalog& catalog) {
    if (!hasRefraction(scene, catalog)) {
        return false;
    }
    const auto drawn =
        std::ranges::count_if(scene.objects, [](const Object& object) { return isDrawn(object); });
    return isSeen(scene.ground) || drawn > 1;
}

void RefractionEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    const RefractionChoice choice = refractionChoice(subject.material, subject.catalog);
    refraction.reset();
    if (choice.block != nullptr) {
        refraction.emplace(*choice.block, *choice.values, subject.material.accuracy);
        const Parameter* dispersion = choice.block->withRole(roles::dispersion);
        if (dispersion != nullptr &&
            BodyIndex(subject.material, choice, subject.catalog).bendsApart()) {
            refraction->setUnequal(*dispersion);
        }
        const AccuracyChoice* wavelengths = wavelengthChoice(*choice.block);
        if (wavelengths != nullptr && !bendsColorsApart(*refraction)) {
            refraction->setExact(*wavelengths);
        }
    }
    mirrorsByTerm = refraction && isMirroredByTerm(subject, choice, set);
}

void RefractionEffect::addTo(ChoiceHash& hash) const {
    hash.add(refraction);
    hash.add(mirrorsByTerm);
}

/// Where nothing is behind the body no rays look for it.
void RefractionEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const AccuracyChoice* rays = refraction ? rayChoice(refraction->block()) : nullptr;
    if (rays != nullptr && !showsSceneRefracted(subject.scene, subject.catalog)) {
        refraction->setExact(*rays);
    }
}

void RefractionEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (refraction) {
        listing.add(effectName(*refraction), detailOf(*refraction, set),
                    [&set](const EffectSubject& subject) { return refractionText(subject, set); });
    }
}

void RefractionEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const Material* material = listing.subject().material;
    const BlockValues* part = material == nullptr ? nullptr : material->part(kinds::refraction);
    if (part != nullptr && !refraction) {
        listing.add("refraction/" + part->id,
                    refractionChoice(*material, listing.subject().catalog).whyNot);
    }
}

void RefractionEffect::place(ObjectLayout& layout, const EffectSet&) const {
    if (refraction) {
        layout.refraction = placed(*refraction, layout.vec4s);
        layout.vec4s += 1;
        if (const int wavelengths = wavelengthCount(*refraction); wavelengths > 0) {
            layout.place(packShares, wavelengths, layout.vec4s);
        }
    }
}

/// What passes takes the place of what would be blended with: the pixel hides what is behind it.
/// The inspection looks at the surface alone.
void RefractionEffect::write(SurfaceText& text) const {
    if (!refraction || text.isInspected()) {
        return;
    }
    const Block& block = refraction->block();
    writeDistance(text);
    text.readFrom("objectData");
    text.addBlock(block);
    text.addUnpack(*refraction, "unpackRefraction");
    text.out.add(namesSource(block) + channelSource(text, *refraction));
    text.out.addFile("passes/refraction_passage.glsl");
    const bool bendsApart = wavelengthCount(*refraction) > 0;
    if (bendsApart) {
        text.out.addFile("passes/refraction_wavelengths.glsl");
    }
    if (mirrorsByTerm) {
        writeTerm(text, block, bendsApart);
    }
    // The way inside is looked along only where there is one.
    text.out.add(isSheet(block) ? "#define HAS_INSIDE false\n" : "#define HAS_INSIDE true\n");
    writeBehind(text, *refraction);
    writePassage(text, block);
    text.out.addFile(bendsApart ? "passes/refraction_colors.glsl" : "passes/refraction_color.glsl");
    if (followsFacets(block)) {
        writeFacets(text, *refraction);
    }
    text.last += fmt::format("    {0} = {3}(s, {0}, {1}, unpackRefraction({2}));\n", text.stored,
                             text.alpha, text.object.refraction->first,
                             followsFacets(block) ? "refractedByFacets" : "refracted");
    text.alpha = "1.0";
}

void RefractionEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::refraction) {
        removePart(scene, effect);
    }
}

void RefractedSceneEffect::choose(const SceneSubject& subject, const EffectSet&) {
    isShownRefracted = showsSceneRefracted(subject.scene, subject.catalog);
}

} // namespace patina
