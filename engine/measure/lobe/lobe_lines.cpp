// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/lobe_lines.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <numbers>
#include <span>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "core/color.h"
#include "material/blocks_in_use.h"
#include "material/measured_preset.h"
#include "measure/eval/model_values.h"
#include "measure/lobe/device_lobe.h"
#include "measure/lobe/fresnel_curve.h"
#include "measure/lobe/index_spectrum.h"
#include "measure/lobe/lobe_factor.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

constexpr LobePlot linePlots[] = {LobePlot::Polar,    LobePlot::Albedo,  LobePlot::Fresnel,
                                  LobePlot::Spectrum, LobePlot::Float32, LobePlot::Float16};

constexpr double stepDegrees = 2.5;
/// Holds the angles, in degrees, of every sketch of an albedo.
constexpr double coarseSketch[] = {0.0, 45.0, 72.0, 89.5};
/// Holds those between them, in degrees, of a sketch whose model is quick.
constexpr double fineSketch[] = {25.0, 60.0, 80.0, 84.0, 88.0};
constexpr std::chrono::milliseconds quickSketch{2}; ///< for the coarse part
constexpr IntegralAim sketchAim{.isSketch = true};

/// Is the aim for a measured file, which is straight between its bins: every bin is a kink, and the
/// file itself is not known any better.
constexpr IntegralAim measuredAim{.tolerance = 1e-3, .panels = 20, .ringPanels = 10};

bool isOfErrors(LobePlot plot) {
    return plot == LobePlot::Float32 || plot == LobePlot::Float16;
}

double inDegrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

LobeLine polarLine(const DirectionsValue& value, const LobeRequest& request) {
    LobeLine line{"reflectance", LobeStroke::Main, false, {}, {}};
    const CurveFineness fineness =
        request.isSketch ? CurveFineness{120, 5e-3, 400} : CurveFineness();
    for (const LobePoint& point : polarCurve(value, request.incoming, fineness)) {
        line.at.push_back(inDegrees(point.angle));
        line.values.push_back(point.f);
    }
    return line;
}

/// Returns the albedo at so few angles that a plot keeps up with a slider: as many as the model's
/// time allows.
std::vector<AlbedoPoint> sketchedAlbedo(const LobeModel& model, double azimuth,
                                        const std::function<bool()>& isWanted) {
    const auto at = [&](std::span<const double> degrees) {
        std::vector<double> angles;
        for (const double each : degrees) {
            angles.push_back(each * std::numbers::pi / 180.0);
        }
        return albedoCurve(model, azimuth, angles, sketchAim, isWanted);
    };
    const auto start = std::chrono::steady_clock::now();
    std::vector<AlbedoPoint> curve = at(coarseSketch);
    if (std::chrono::steady_clock::now() - start < quickSketch) {
        std::ranges::copy(at(fineSketch), std::back_inserter(curve));
        std::ranges::sort(curve, {}, &AlbedoPoint::angle);
    }
    return curve;
}

LobeLine lineOf(const std::vector<AlbedoPoint>& curve) {
    LobeLine line{"albedo", LobeStroke::Main, false, {}, {}};
    for (const AlbedoPoint& point : curve) {
        line.at.push_back(inDegrees(point.angle));
        line.values.push_back(point.albedo);
    }
    return line;
}

IntegralAim albedoAim(const Catalog& catalog, const Material& material) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    return model != nullptr && tableParameter(*model) != nullptr ? measuredAim : IntegralAim();
}

LobeLine albedoLine(const LobeModel& model, const LobeRequest& request, const IntegralAim& aim,
                    const std::function<bool()>& isWanted) {
    const double azimuth = request.incoming.azimuth;
    return lineOf(request.isSketch
                      ? sketchedAlbedo(model, azimuth, isWanted)
                      : albedoCurve(model, azimuth, albedoAngles(stepDegrees), aim, isWanted));
}

/// Tells whether the material's model, or what fills its slot, is computed less exactly.
bool isInexact(const Catalog& catalog, const Material& material) {
    for (const Block* block : blocksInUse(material, catalog)) {
        for (const auto& [id, level] : material.accuracy) {
            const AccuracyChoice* choice = block->accuracyChoice(id);
            if (choice != nullptr && level != choice->values.front().id) {
                return true;
            }
        }
    }
    return false;
}

std::string noteOf(const Block& model, const Material& material) {
    std::string note;
    if (!material.textures.empty()) {
        note += "without its images";
    }
    if (material.part(kinds::fresnel) != nullptr && model.slot(kinds::fresnel) == nullptr) {
        note += note.empty() ? "" : ", ";
        note += "without the Fresnel term that is blended over the light";
    }
    return note;
}

/// Returns the lines of a model that cannot be evaluated in double precision, for which the note
/// has the reason.
Result<LobeLines> deviceLines(const Catalog& catalog, const EvalCase& variant,
                              const LobeRequest& request, EvalGpu& device, const Error& whyNot) {
    LobeLines all;
    LobeLine& line = all.lines.emplace_back();
    if (request.plot == LobePlot::Polar) {
        line.name = "reflectance";
        const auto curve = devicePolarCurve(device, catalog, variant, request.incoming);
        if (!curve) {
            return tl::unexpected(curve.error());
        }
        for (const LobePoint& point : *curve) {
            line.at.push_back(inDegrees(point.angle));
            line.values.push_back(point.f);
        }
    } else {
        const auto curve = deviceAlbedoCurve(device, catalog, variant, request.incoming.azimuth);
        if (!curve) {
            return tl::unexpected(curve.error());
        }
        line = lineOf(*curve);
    }
    all.note = "in single precision, by the device: " + whyNot.text();
    return all;
}

Result<LobeLines> floatLines(const Catalog& catalog, const EvalCase& variant,
                             const LobeRequest& request, EvalGpu& device) {
    const auto errors = floatErrors(device, catalog, variant, request.incoming);
    if (!errors) {
        return tl::unexpected(errors.error());
    }
    LobeLines all;
    LobeLine& line = all.lines.emplace_back();
    line.name = "float32 error";
    double worst = 0.0;
    double at = 0.0;
    for (const FloatError& error : *errors) {
        line.at.push_back(inDegrees(error.angle));
        line.values.push_back(error.ulps);
        const double here = std::max({error.ulps.x, error.ulps.y, error.ulps.z});
        if (here > worst) {
            worst = here;
            at = line.at.back();
        }
    }
    all.note =
        fmt::format("at worst {:.3g} units in the last place, {:.3g} degrees from the normal",
                    worst, std::abs(at));
    return all;
}

/// Returns the line of the wanted term: of a reflectance, or of a factor in a polar plot.
Result<LobeLine> termLine(const Catalog& catalog, const Material& material,
                          const LobeRequest& request, const std::function<bool()>& isWanted) {
    if (request.plot == LobePlot::Polar && isFactor(request.term)) {
        const auto factor = LobeFactor::create(catalog, material, request.term);
        if (!factor) {
            return tl::unexpected(factor.error());
        }
        LobeLine line = polarLine(
            [&factor](const glm::dvec3& l, const glm::dvec3& v) { return factor->at(l, v); },
            request);
        line.name = factor->name();
        line.isShare = request.term != LobeTerm::Distribution;
        return line;
    }
    const auto model = LobeModel::create(catalog, material, request.term);
    if (!model) {
        return tl::unexpected(model.error());
    }
    LobeLine line =
        request.plot == LobePlot::Polar
            ? polarLine([&model](const glm::dvec3& l,
                                 const glm::dvec3& v) { return model->reflectance(l, v); },
                        request)
            : albedoLine(*model, request, albedoAim(catalog, material), isWanted);
    if (const auto ended = model->ending(); !ended) {
        return tl::unexpected(ended.error());
    }
    return line;
}

Result<LobeLines> modelLines(const Catalog& catalog, const Material& material,
                             const LobeRequest& request, const std::function<bool()>& isWanted,
                             EvalGpu* device) {
    const Block* block = catalog.find(kinds::models, material.model.id);
    if (block != nullptr && !whyNoPlots(*block).empty()) {
        return failure(whyNoPlots(*block), "a model of a reflectance");
    }
    const Result<EvalCase> variant = sweepVariant(catalog, material);
    if (!variant) {
        return tl::unexpected(variant.error());
    }
    if (request.plot == LobePlot::Float32) {
        return device != nullptr ? floatLines(catalog, *variant, request, *device)
                                 : Result<LobeLines>(failure("there is no device to compare with"));
    }
    const bool isWhole = request.term == LobeTerm::Whole;
    if (device != nullptr && isWhole) {
        const auto values = ModelValues::of(*variant, catalog);
        if (!values && values.error() == endlessError(*block)) {
            return tl::unexpected(values.error()); // a driver cuts it off, and returns anything
        }
        if (!values) {
            return deviceLines(catalog, *variant, request, *device, values.error());
        }
    }
    LobeLines all;
    const auto add = [&](const Material& shown, LobeStroke stroke) -> Result<void> {
        Result<LobeLine> line = termLine(catalog, shown, request, isWanted);
        if (!line) {
            return tl::unexpected(line.error());
        }
        if (stroke == LobeStroke::Exact) {
            line->name += ", exact";
        }
        line->stroke = stroke;
        all.lines.push_back(std::move(*line));
        return {};
    };
    if (const auto added = add(material, LobeStroke::Main); !added) {
        return tl::unexpected(added.error());
    }
    if (isInexact(catalog, material)) {
        if (const auto added = add(atExactLevels(material), LobeStroke::Exact); !added) {
            return tl::unexpected(added.error());
        }
    }
    all.note = noteOf(*block, material);
    return all;
}

/// Returns an index as text; that of a reflectance of all light is as large as a double can be.
std::string indexText(double index) {
    constexpr double maxShown = 1e6;
    return index > maxShown ? "without bound" : fmt::format("{:.4g}", index);
}

LobeLine sideLine(const InterfaceSide& side, LobeStroke stroke, bool isFromInside) {
    const char* const light = stroke == LobeStroke::Across  ? "R_s"
                              : stroke == LobeStroke::Along ? "R_p"
                                                            : "R";
    LobeLine line{fmt::format("from {} {}", isFromInside ? "inside" : "outside", light),
                  stroke,
                  isFromInside,
                  {},
                  {}};
    for (const PolarisedPoint& point : side.points) {
        line.at.push_back(inDegrees(point.angle));
        line.values.push_back(stroke == LobeStroke::Across  ? point.s
                              : stroke == LobeStroke::Along ? point.p
                                                            : point.mean());
    }
    return line;
}

bool isEqual(const glm::dvec3& v) {
    return v.x == v.y && v.y == v.z;
}

/// Adds Brewster's and the critical angle, of the three channels' where these differ by a degree or
/// more, else of green alone.
void addMarks(LobeLines& all, const InterfaceSide& side, bool isFromInside) {
    constexpr const char* channels[] = {" (red)", " (green)", " (blue)"};
    const char* const from = isFromInside ? " from inside" : "";
    const auto add = [&](const char* name, const glm::dvec3& angles) {
        const double spread = inDegrees(std::max({angles.x, angles.y, angles.z}) -
                                        std::min({angles.x, angles.y, angles.z}));
        for (int i = 0; i < (isEqual(angles) ? 1 : 3); ++i) {
            if (inDegrees(angles[i]) < 89.995 && (i == 1 || spread == 0.0 || spread >= 1.0)) {
                all.marks.push_back(
                    {fmt::format("{}{}{}", name, from, isEqual(angles) ? "" : channels[i]),
                     inDegrees(angles[i])});
            }
        }
    };
    add("Brewster", side.brewster);
    add("critical", side.critical);
}

/// Tells whether the term is more than the interface that it describes, as a film on it is.
bool addsToItsInterface(const FresnelCurves& curves) {
    constexpr double rounding = 1e-3;
    if (!curves.media || curves.media->isFromReflectance) {
        return false;
    }
    return std::ranges::any_of(curves.term, [&curves](const FresnelPoint& point) {
        const glm::dvec3 bare = reflectedAt(*curves.media, point.angle).mean();
        return glm::any(glm::greaterThan(glm::abs(bare - point.exact), glm::dvec3(rounding)));
    });
}

Result<LobeLines> fresnelLines(const Catalog& catalog, const Material& material) {
    const Result<FresnelCurves> curves = fresnelCurves(catalog, material);
    if (!curves) {
        return tl::unexpected(curves.error());
    }
    LobeLines all;
    LobeLine chosen{curves->label, LobeStroke::Main, false, {}, {}};
    LobeLine exact{curves->label + ", exact", LobeStroke::Exact, false, {}, {}};
    bool isExact = true;
    for (const FresnelPoint& point : curves->term) {
        for (LobeLine* line : {&chosen, &exact}) {
            line->at.push_back(inDegrees(point.angle));
        }
        chosen.values.push_back(point.chosen);
        exact.values.push_back(point.exact);
        isExact = isExact && point.chosen == point.exact;
    }
    all.lines.push_back(std::move(chosen));
    if (!isExact) {
        all.lines.push_back(std::move(exact));
    }
    const bool isBare = addsToItsInterface(*curves);
    for (const bool isFromInside : {false, true}) {
        const InterfaceSide& side = isFromInside ? curves->fromInside : curves->fromOutside;
        for (const LobeStroke stroke : {LobeStroke::Across, LobeStroke::Along, LobeStroke::Main}) {
            if (!side.points.empty()) {
                all.lines.push_back(sideLine(side, stroke, isFromInside));
                all.lines.back().name.insert(0, isBare ? "bare: " : "");
            }
        }
        if (curves->media && curves->media->isClear() && !side.points.empty() && !isBare) {
            addMarks(all, side, isFromInside);
        }
    }
    if (curves->media) {
        const glm::dvec3& n = curves->media->index;
        all.note = fmt::format(
            "{}{}",
            curves->media->isFromReflectance ? "polarised light as of the clear material of index "
                                             : "index ",
            isEqual(n) ? indexText(n.x)
                       : fmt::format("{}, {}, {}", indexText(n.x), indexText(n.y), indexText(n.z)));
        if (!curves->media->isClear()) {
            const glm::dvec3& k = curves->media->extinction;
            all.note += fmt::format(", extinction {:.4g}, {:.4g}, {:.4g}", k.x, k.y, k.z);
        }
        if (isBare) {
            all.note += fmt::format("; polarised light is that of the bare interface, without what "
                                    "{} adds",
                                    curves->label);
        }
    }
    return all;
}

LobeLine spectrumLine(const IndexSpectrum& spectrum, const char* name,
                      const std::vector<double>& values) {
    LobeLine line;
    line.name = name;
    line.isSampled = spectrum.isOfChannels;
    line.at = spectrum.wavelengths;
    for (const double value : values) {
        line.values.emplace_back(value);
    }
    return line;
}

Result<LobeLines> spectrumLines(const Catalog& catalog, const Material& material) {
    const Result<IndexSpectrum> spectrum = indexSpectrum(catalog, material);
    if (!spectrum) {
        return tl::unexpected(spectrum.error());
    }
    LobeLines all;
    all.lines.push_back(spectrumLine(*spectrum, "index n", spectrum->index));
    all.lines.back().digits = 5; // an index of 1.5 differs by a hundredth from red to blue
    if (!spectrum->extinction.empty()) {
        all.lines.push_back(spectrumLine(*spectrum, "extinction k", spectrum->extinction));
        all.lines.back().stroke = LobeStroke::Extinction;
    }
    all.lines.push_back(spectrumLine(*spectrum, "R facing the surface", spectrum->reflectance));
    all.lines.back().isShare = true;
    constexpr const char* channels[] = {"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
        all.marks.push_back({channels[i], spectrum->channels[i]});
    }
    if (spectrum->isOfChannels) {
        all.note = "known at the wavelengths of the channels alone";
    }
    return all;
}

} // namespace

std::string_view abscissaOf(LobePlot plot) {
    return plot == LobePlot::Spectrum ? "nanometres" : "degrees";
}

std::string_view wordOf(LobePlot plot) {
    switch (plot) {
    case LobePlot::Spectrum:
        return "spectrum";
    case LobePlot::Albedo:
        return "albedo";
    case LobePlot::Fresnel:
        return "fresnel";
    case LobePlot::Float32:
        return "float32";
    case LobePlot::Float16:
        return "float16";
    default:
        return "polar";
    }
}

std::optional<LobePlot> lobePlotOf(std::string_view word) {
    const auto found =
        std::ranges::find_if(linePlots, [word](LobePlot plot) { return wordOf(plot) == word; });
    return found == std::end(linePlots) ? std::nullopt : std::optional(*found);
}

Result<LobeLines> lobeLines(const Catalog& catalog, const Material& material,
                            const LobeRequest& request, const std::function<bool()>& isWanted,
                            EvalGpu* device) {
    switch (request.plot) {
    case LobePlot::Fresnel:
        return fresnelLines(catalog, material);
    case LobePlot::Spectrum:
        return spectrumLines(catalog, material);
    case LobePlot::Float16:
        return failure("floats of 16 bits are evaluated elsewhere");
    default:
        return modelLines(catalog, material, request, isWanted, device);
    }
}

glm::dvec3 valueAt(const LobeLine& line, double at) {
    const auto after = std::ranges::lower_bound(line.at, at);
    if (after == line.at.begin() || line.at.size() == 1) {
        return line.values.front();
    }
    if (after == line.at.end()) {
        return line.values.back();
    }
    const auto right = static_cast<std::size_t>(after - line.at.begin());
    const double from = line.at[right - 1];
    const double share = (at - from) / (line.at[right] - from);
    return glm::mix(line.values[right - 1], line.values[right], share);
}

std::optional<LobeLine> transmittedLine(const LobeLine& line) {
    if (line.name.find("from ") == std::string::npos) {
        return std::nullopt;
    }
    LobeLine passed = line;
    passed.name[passed.name.find('R')] = 'T';
    for (glm::dvec3& value : passed.values) {
        value = glm::dvec3(1.0) - value;
    }
    return passed;
}

bool isGrey(const LobeLine& line) {
    constexpr double rounding = 1e-6;
    return std::ranges::all_of(line.values, [](const glm::dvec3& v) {
        const double max = std::max({v.x, v.y, v.z});
        return max - std::min({v.x, v.y, v.z}) <= rounding * max;
    });
}

double overlaidValue(LobePlot plot, const glm::dvec3& channels) {
    return isOfErrors(plot) ? std::max({channels.x, channels.y, channels.z}) : luminance(channels);
}

std::string_view overlaidWord(LobePlot plot, const std::vector<LobeSubject>& subjects) {
    const bool areGrey = std::ranges::all_of(subjects, [](const LobeSubject& subject) {
        return std::ranges::all_of(subject.lines.lines, isGrey);
    });
    return subjects.size() < 2 || areGrey ? ""
           : isOfErrors(plot)             ? "largest of the channels"
                                          : "luminance";
}

std::vector<LobeLine> turnedAlbedos(const Catalog& catalog, const Material& material,
                                    const LobeRequest& request,
                                    const std::function<bool()>& isWanted) {
    constexpr int azimuths = 4;         // in half a turn
    constexpr double coarseStep = 10.0; // degrees
    const auto model = LobeModel::create(catalog, material, request.term);
    if (!model || model->isIsotropic()) {
        return {};
    }
    std::vector<LobeLine> lines;
    for (int i = 1; i < azimuths; ++i) {
        const double azimuth = request.incoming.azimuth + std::numbers::pi * i / azimuths;
        lines.push_back(lineOf(albedoCurve(*model, azimuth, albedoAngles(coarseStep),
                                           albedoAim(catalog, material), isWanted)));
    }
    return lines;
}

EnergyRange energyRange(std::span<const LobeLine> albedos) {
    std::optional<EnergyRange> all;
    for (const LobeLine& albedo : albedos) {
        std::vector<AlbedoPoint> curve;
        for (std::size_t i = 0; i < albedo.values.size(); ++i) {
            curve.push_back({albedo.at[i] * std::numbers::pi / 180.0, albedo.values[i], 0.0});
        }
        const EnergyRange range = energyRange(curve);
        const EnergyRange before = all.value_or(EnergyRange{range.min, glm::dvec3(0.0), range.max});
        all = EnergyRange{glm::min(before.min, range.min),
                          before.mean + range.mean / double(albedos.size()),
                          glm::max(before.max, range.max)};
    }
    return all.value_or(EnergyRange());
}

EnergyRange luminanceRange(std::span<const LobeLine> albedos) {
    std::vector<LobeLine> greys(albedos.begin(), albedos.end());
    for (LobeLine& grey : greys) {
        for (glm::dvec3& value : grey.values) {
            value = glm::dvec3(luminance(value));
        }
    }
    return energyRange(greys);
}

} // namespace patina
