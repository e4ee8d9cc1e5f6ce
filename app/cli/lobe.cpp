// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/cost_request.h"
#include "cli/lobe_drawing.h"
#include "cli/option_numbers.h"
#include "cli/scene_setup.h"
#include "core/atomic_file.h"
#include "core/number_text.h"
#include "measure/approximation/half_lines.h"
#include "measure/eval/eval_gpu.h"
#include "measure/lobe/lobe_table.h"

namespace patina {
namespace {

constexpr glm::ivec2 lobePlotSize{960, 600};
constexpr int sliceCells = 90;
constexpr std::string_view halfPlot = "half";

struct LobeOptions {
    std::vector<std::string> presets;
    PictureOptions picture; ///< only its model, its Fresnel block and its values are options
    std::string plot = "polar";
    std::string term = "whole";
    std::string scale = "linear";
    double degrees = 45.0;
    double azimuthDegrees = 0.0;
    std::string out = "-";
};

/// Is a material that is plotted.
struct Named {
    std::string name;
    Material material;
};

Checked<Named> namedMaterial(const std::string& preset, const LobeOptions& options,
                             const Catalog& catalog) {
    const auto setup = sceneFor(preset, options.picture, catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    const Material& material = setup->scene.objects.front().material;
    const std::string name = !material.name.empty() ? material.name
                             : !preset.empty() ? std::filesystem::path(preset).filename().string()
                                               : material.model.id;
    return Named{name, material};
}

Checked<std::vector<Named>> materialsOf(const LobeOptions& options, const Catalog& catalog) {
    std::vector<std::string> presets = options.presets;
    if (presets.empty()) {
        if (options.picture.model.empty()) {
            return tl::unexpected(
                oneError(failure("there is nothing to plot", "a preset or --model").value()));
        }
        presets.emplace_back();
    }
    std::vector<Named> all;
    for (const std::string& preset : presets) {
        auto named = namedMaterial(preset, options, catalog);
        if (!named) {
            return tl::unexpected(named.error());
        }
        all.push_back(std::move(*named));
    }
    return all;
}

/// Writes a plot in the form that the file's name asks for.
Checked<void> writeOut(const LobeOptions& options, const std::vector<PlotShape>& shapes,
                       const std::string& csv) {
    if (options.out == "-") {
        std::cout << csv;
        return {};
    }
    const std::string ending = endingOf(options.out);
    const Result<void> written = ending == ".csv" ? writeFileAtomically(options.out, csv)
                                                  : writeDrawing(shapes, lobePlotSize, options.out);
    return written ? Checked<void>() : tl::unexpected(oneError(written.error()));
}

Checked<void> plotSlice(const std::vector<Named>& materials, const LobeOptions& options,
                        const Catalog& catalog) {
    if (materials.size() > 1) {
        return tl::unexpected(
            oneError(failure("the slice is of one material", "a single preset").value()));
    }
    const Named& shown = materials.front();
    const auto model = reflectanceModel(catalog, shown.material, *lobeTermOf(options.term));
    if (!model) {
        return tl::unexpected(oneError(model.error()));
    }
    const HalfDifferenceSlice slice = halfDifferenceSlice(*model, sliceCells);
    if (const auto ended = model->ending(); !ended) {
        return tl::unexpected(oneError(ended.error()));
    }
    return writeOut(options,
                    sliceDrawing(slice, shown.name, *lobeScaleOf(options.scale), lobePlotSize),
                    sliceCsv(slice));
}

Checked<void> plotLines(const std::vector<Named>& materials, const LobeOptions& options,
                        const Catalog& catalog) {
    constexpr double degree = std::numbers::pi / 180.0;
    LobeRequest request;
    request.plot = *lobePlotOf(options.plot);
    request.incoming = {options.degrees * degree, options.azimuthDegrees * degree};
    request.term = *lobeTermOf(options.term);
    std::vector<LobeSubject> subjects;
    EvalGpu device; // opens a context only for what needs one
    for (const Named& named : materials) {
        auto lines = request.plot == LobePlot::Float16
                         ? halfLines(catalog, named.material, request, catalog.roots.front().folder)
                         : lobeLines(
                               catalog, named.material, request, [] { return true; }, &device);
        if (!lines) {
            Error why = lines.error();
            if (materials.size() > 1) {
                why.problem = fmt::format("{}: {}", named.name, why.problem);
            }
            return tl::unexpected(oneError(why));
        }
        subjects.push_back({named.name, std::move(*lines)});
    }
    const auto shapes =
        request.plot == LobePlot::Polar
            ? polarDrawing(subjects, *lobeScaleOf(options.scale), options.degrees, lobePlotSize)
        : request.plot == LobePlot::Float32 || request.plot == LobePlot::Float16
            ? errorDrawing(subjects, request.plot, lobePlotSize)
        : request.plot == LobePlot::Spectrum ? spectrumDrawing(subjects, lobePlotSize)
                                             : shareDrawing(subjects, lobePlotSize);
    return writeOut(options, shapes, linesCsv(subjects, request.plot));
}

Checked<void> lobe(const LobeOptions& options) {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    report(catalog.errors);
    const auto materials = materialsOf(options, catalog);
    if (!materials) {
        return tl::unexpected(materials.error());
    }
    return options.plot == halfPlot ? plotSlice(*materials, options, catalog)
                                    : plotLines(*materials, options, catalog);
}

void addAngle(CLI::App& command, const char* option, double& degrees, double max,
              const std::string& description) {
    command
        .add_option_function<std::string>(
            option,
            [option, &degrees, max](const std::string& text) {
                degrees = optionNumber(
                    option, text,
                    {"an angle", fmt::format("degrees from 0 to {:g}", max),
                     [max](double angle) { return angle >= 0.0 && angle <= max; }, parseNumber});
            },
            description)
        ->default_str(fmt::format("{:g}", degrees));
}

std::string checkOut(const std::string& file) {
    const std::string ending = endingOf(file);
    const bool isKnown = file == "-" || ending == ".svg" || ending == ".png" || ending == ".csv";
    return isKnown ? std::string() : "expected a file that ends in .svg, .png or .csv";
}

} // namespace

void addLobe(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "lobe", "Plot the reflectance of presets over angles, in double precision");
    auto options = std::make_shared<LobeOptions>();
    command->add_option("presets", options->presets, "Presets (*.patina.json)");
    command->add_option("--model", options->picture.model,
                        "This model in place of the presets', or by itself with its defaults");
    command->add_option("--fresnel", options->picture.parts[std::string(kinds::fresnel)],
                        "This Fresnel term, or none");
    command->add_option("--set", options->picture.sets, "Set a value: id=value");
    command
        ->add_option("--plot", options->plot,
                     "polar: f in the plane of incidence; albedo: what is reflected in all; "
                     "fresnel: what the surface reflects of each polarisation, from both sides; "
                     "spectrum: the index of refraction over the wavelength; "
                     "half: a slice over half and difference angle; float32: how far single "
                     "precision on the device is from double; float16: the same of floats of 16 "
                     "bits, rounded on the processor")
        ->check(CLI::IsMember(
            {"polar", "albedo", "fresnel", "spectrum", "half", "float32", "float16"}));
    command
        ->add_option(
            "--term", options->term,
            "The whole model, a term alone, or, in a polar plot, a factor of the highlight")
        ->check(
            CLI::IsMember({"whole", "diffuse", "highlight", "distribution", "masking", "fresnel"}));
    command->add_option("--scale", options->scale, "How f becomes a length, or a brightness")
        ->check(CLI::IsMember({"linear", "cube-root", "log"}));
    addAngle(*command, "--angle", options->degrees, 90.0,
             "The light's angle from the normal, of a polar plot");
    addAngle(*command, "--azimuth", options->azimuthDegrees, 360.0,
             "The light's angle from the tangent, which matters for a grain");
    command
        ->add_option("-o,--output", options->out,
                     "A file: .svg, .png or .csv; - writes .csv to standard output")
        ->check(checkOut);
    command->callback([options, &status] {
        const auto done = lobe(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
