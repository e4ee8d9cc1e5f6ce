// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/content_hash.h"
#include "cli/cost_request.h"
#include "cli/job.h"
#include "cli/lobe_drawing.h"
#include "cli/long_work.h"
#include "cli/option_numbers.h"
#include "cli/preset_folder.h"
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
constexpr std::string_view plotSuffix = ".svg"; ///< of plots in a folder

struct LobeOptions {
    std::vector<std::string> presets;
    PictureOptions picture; ///< only its model, its Fresnel block and its values are options
    std::string plot = "polar";
    std::string term = "whole";
    std::string scale = "linear";
    double degrees = 45.0;
    double azimuthDegrees = 0.0;
    std::string out = "-"; ///< is a folder where there is a plot of each preset
    JobOptions job;

    bool isIntoFolder() const { return !presets.empty() && isFolder(out); }
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
Checked<void> writeOut(const std::string& file, const std::vector<PlotShape>& shapes,
                       const std::string& csv) {
    if (file == "-") {
        std::cout << csv;
        return {};
    }
    const std::string ending = endingOf(file);
    const Result<void> written = ending == ".csv" ? writeFileAtomically(file, csv)
                                                  : writeDrawing(shapes, lobePlotSize, file);
    return written ? Checked<void>() : tl::unexpected(oneError(written.error()));
}

/// Is a plot of some materials: what is drawn, and its numbers as comma-separated values.
struct LobePicture {
    std::vector<PlotShape> shapes;
    std::string csv;
};

Checked<LobePicture> slicePicture(const std::vector<Named>& materials, const LobeOptions& options,
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
    return LobePicture{sliceDrawing(slice, shown.name, *lobeScaleOf(options.scale), lobePlotSize),
                       sliceCsv(slice)};
}

Checked<LobePicture> linesPicture(const std::vector<Named>& materials, const LobeOptions& options,
                                  const Catalog& catalog, EvalGpu& device) {
    constexpr double degree = std::numbers::pi / 180.0;
    LobeRequest request;
    request.plot = *lobePlotOf(options.plot);
    request.incoming = {options.degrees * degree, options.azimuthDegrees * degree};
    request.term = *lobeTermOf(options.term);
    std::vector<LobeSubject> subjects;
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
    auto shapes =
        request.plot == LobePlot::Polar
            ? polarDrawing(subjects, *lobeScaleOf(options.scale), options.degrees, lobePlotSize)
        : request.plot == LobePlot::Float32 || request.plot == LobePlot::Float16
            ? errorDrawing(subjects, request.plot, lobePlotSize)
        : request.plot == LobePlot::Spectrum ? spectrumDrawing(subjects, lobePlotSize)
                                             : shareDrawing(subjects, lobePlotSize);
    return LobePicture{std::move(shapes), linesCsv(subjects, request.plot)};
}

Checked<LobePicture> pictureOf(const std::vector<Named>& materials, const LobeOptions& options,
                               const Catalog& catalog, EvalGpu& device) {
    return options.plot == halfPlot ? slicePicture(materials, options, catalog)
                                    : linesPicture(materials, options, catalog, device);
}

/// Plots each preset by itself: into a file of a folder, or as numbers into the file of results.
class LobeWork : public JobWork {
  public:
    LobeWork(const LobeOptions& options, const Catalog& catalog)
        : options_(options), catalog_(catalog) {}

    Checked<nlohmann::json> resultOf(const std::string& preset) override {
        auto material = namedMaterial(preset, options_, catalog_);
        if (!material) {
            return tl::unexpected(material.error());
        }
        const auto picture = pictureOf({std::move(*material)}, options_, catalog_, device_);
        if (!picture) {
            return tl::unexpected(picture.error());
        }
        if (!options_.isIntoFolder()) {
            return nlohmann::json{{"csv", picture->csv}};
        }
        const std::string name = nameInFolder(preset, plotSuffix);
        if (auto written = writeOut(inFolder(name), picture->shapes, picture->csv); !written) {
            return tl::unexpected(written.error());
        }
        return nlohmann::json{{"plot", name}, {"hash", fileHash(inFolder(name))}};
    }

    bool isThere(const nlohmann::json& result) const override {
        const std::string name = result.value("plot", std::string());
        return !options_.isIntoFolder() ||
               fileHash(inFolder(name)) == result.value("hash", std::string());
    }

  private:
    std::string inFolder(const std::string& name) const {
        return (std::filesystem::path(options_.out) / name).string();
    }

    const LobeOptions& options_;
    const Catalog& catalog_;
    EvalGpu device_; ///< opens a context only for what needs one
};

/// Plots each preset, also where some fail; returns the exit status.
Checked<int> plotEach(const CLI::App& command, const LobeOptions& options, const Catalog& catalog) {
    if (options.isIntoFolder()) {
        if (auto made = prepareFolder(options.out, options.presets, plotSuffix, "plot"); !made) {
            return tl::unexpected(oneError(made.error()));
        }
    }
    LobeWork work(options, catalog);
    LongWork longWork;
    if (options.job.isWanted()) {
        return runJob({command, options.job, options.presets, catalog, false}, work, longWork);
    }
    int status = 0;
    for (const std::string& preset : options.presets) {
        if (longWork.isStopped()) {
            return LongWork::stoppedStatus;
        }
        longWork.report(preset);
        if (const auto plotted = work.resultOf(preset); !plotted) {
            report(plotted.error());
            status = 1;
        }
    }
    return status;
}

/// Returns the exit status.
Checked<int> lobe(const CLI::App& command, const LobeOptions& options) {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    report(catalog.errors);
    if (options.job.isWanted() && options.out != "-" && !options.isIntoFolder()) {
        return tl::unexpected(oneError(
            failure("--results are of each preset by itself", "-o FOLDER/, or no -o").value()));
    }
    if (options.isIntoFolder() || options.job.isWanted()) {
        return plotEach(command, options, catalog);
    }
    const auto materials = materialsOf(options, catalog);
    if (!materials) {
        return tl::unexpected(materials.error());
    }
    EvalGpu device; // opens a context only for what needs one
    const auto picture = pictureOf(*materials, options, catalog, device);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    return writeOut(options.out, picture->shapes, picture->csv).map([] { return 0; });
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
    return isKnown || isFolder(file)
               ? std::string()
               : "expected a file that ends in .svg, .png or .csv, or FOLDER/";
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
        ->add_option(
            "-o,--output", options->out,
            "A file: .svg, .png or .csv; - writes .csv to standard output; FOLDER/ takes an "
            ".svg of each preset, named after its file")
        ->check(checkOut);
    addAllowOutside(*command, options->picture.allowsOutside);
    addJobOptions(*command, options->job);
    command->callback([command, options, &status] {
        const Checked<int> ended = lobe(*command, *options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
