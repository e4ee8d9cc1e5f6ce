// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "catalog/json_text.h"
#include "catalog/suggestion.h"
#include "cli/command.h"
#include "cli/long_work.h"
#include "cli/option_families.h"
#include "cli/prepared_subject.h"
#include "cli/ways_table.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "measure/approximation/approximation_subject.h"
#include "measure/approximation/level_check.h"
#include "measure/approximation/written_block.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

/// Is the share of --seconds for pairs of frames that are timed.
constexpr double shareOfTimes = 0.08;

struct ApproximateRequest {
    std::string subject;
    std::vector<const GpuFamily*> families;
    double seconds = 120.0;
    double budgetError = 0.25;
    std::size_t levels = 5;
    std::size_t cases = 100000;
    bool json = false;
    bool declared = false; ///< judges the levels that the block has in the same way
    std::string output;
};

/// Is what cheaper ways are searched for, with the blocks that it refers to.
struct ApproximateSubject {
    std::shared_ptr<const Catalog> catalog;
    EvalCase subject;
    bool ofValues = false;
};

Checked<ApproximateSubject> subjectOfBlock(std::shared_ptr<const Catalog> catalog,
                                           const Block& block) {
    auto made = defaultCase(*catalog, block);
    if (!made) {
        return tl::unexpected(made.error());
    }
    return ApproximateSubject{std::move(catalog), std::move(*made), false};
}

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code missing;
    return std::filesystem::equivalent(a, b, missing) && !missing;
}

/// Reads a GLSL file with the descriptor beside it.
Checked<ApproximateSubject> subjectOfShader(const std::filesystem::path& file) {
    std::vector<BlockRoot> roots = standardBlockRoots();
    const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
    const std::filesystem::path folder = whole.parent_path();
    std::error_code ignored; // a file that cannot be examined is not there
    if (!std::filesystem::is_regular_file(whole, ignored)) {
        return tl::unexpected(oneError({file.string(), 0, 0, "there is no such file", {}}));
    }
    if (findKind(folder.filename().string()) == nullptr) {
        return tl::unexpected(
            oneError({file.string(), 0, 0, "the folder is not named after a kind of block",
                      "a file such as models/my-model.glsl"}));
    }
    for (const bool isAdded : {false, true}) {
        if (isAdded) {
            roots.push_back({folder.parent_path(), false});
        }
        auto catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        for (const Block& block : catalog->blocks) {
            if (isSameFile(block.shaderFile, whole)) {
                return subjectOfBlock(catalog, block);
            }
        }
        if (isAdded) {
            Errors errors;
            for (const Error& error : catalog->errors) {
                if (std::filesystem::path(error.file).stem() == file.stem()) {
                    errors.push_back(error);
                }
            }
            return tl::unexpected(
                errors.empty() ? oneError({file.string(), 0, 0, "there is no block in this file",
                                           "a GLSL file with a descriptor of its name beside it"})
                               : errors);
        }
    }
    return tl::unexpected(Errors());
}

Checked<ApproximateSubject> subjectOfPreset(const std::string& file) {
    auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    const auto reading = readPreset(file, *catalog);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    report(reading->notes);
    auto made = sweepVariant(*catalog, reading->material);
    if (!made) {
        return tl::unexpected(oneError(made.error()));
    }
    if (!reading->material.textures.empty()) {
        report({{file,
                 0,
                 0,
                 "its images are left out: where one drives a value, the ways that are "
                 "for the values of the preset do not hold",
                 {}}});
    }
    return ApproximateSubject{std::move(catalog), std::move(*made), true};
}

bool isNamed(const Block& block, std::string_view name) {
    return name == block.id || name == fmt::format("{}/{}", block.kind, block.id);
}

Checked<ApproximateSubject> subjectNamed(const std::string& name) {
    auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    std::vector<std::string> ids;
    for (const Block* model : catalog->ofKind(kinds::models)) {
        ids.push_back(model->id);
    }
    const Block* found = catalog->find(kinds::models, name);
    for (const Block& block : catalog->blocks) {
        if (found == nullptr && isNamed(block, name)) {
            found = &block;
        }
    }
    if (found == nullptr) {
        return tl::unexpected(oneError(
            failure(fmt::format("\"{}\" is neither a preset, a GLSL file nor a block", name),
                    oneOf(name, ids))
                .value()));
    }
    return subjectOfBlock(catalog, *found);
}

Checked<ApproximateSubject> subjectOf(const std::string& name) {
    if (name.ends_with(".glsl")) {
        return subjectOfShader(name);
    }
    std::error_code ignored; // a path that cannot be examined is not a file
    const bool isFile = std::filesystem::is_regular_file(name, ignored) || name.ends_with(".json");
    return isFile ? subjectOfPreset(name) : subjectNamed(name);
}

/// Judges the levels that the block has on as many cases as the whole front that is found.
Checked<std::vector<DeclaredWay>> declaredOf(const ApproximateSubject& subject,
                                             const CheaperSearchOptions& options) {
    LongWork work;
    work.report("judging its own levels ");
    const std::size_t count = std::min(options.heldOut, casesOfFront);
    const CaseWish wish{count, 3, 4096, std::max<std::size_t>(count / 32, 1), options.ofValues,
                        true};
    return declaredWays(subject.subject, subject.catalog->roots.front().folder, *options.family,
                        wish, [&work] { return work.isStopped(); });
}

/// Says how a check on the graphics device ended.
enum class DeviceCheckEnd { Done, NoDevice, Stopped };

/// Draws the ways on the material that they are for, in the default scene. Returns nothing where
/// the search was stopped, and, with a note, where they cannot be drawn.
std::optional<WaysInFrame> drawn(const ApproximateRequest& request,
                                 const ApproximateSubject& subject, CheaperWays& ways,
                                 const CheaperSearchOptions& options,
                                 const std::function<bool()>& isStopped) {
    const Block& block = *subject.subject.block.block;
    if (block.kind != kinds::models || ways.ways.empty() || ways.isStopped) {
        return std::nullopt;
    }
    const std::function<bool()> isOver = [&] { return isStopped() || options.isDeviceLate(); };
    PictureOptions picture;
    picture.model = subject.ofValues ? std::string() : block.id;
    AssetClient files;
    const auto scene = prepared(subject.ofValues ? request.subject : std::string(), picture,
                                *subject.catalog, files);
    TextureLoader textures(files);
    auto made =
        !scene ? tl::unexpected(scene.error())
               : waysInFrame({scene->scene, 0, scene->scene.camera,
                              [&scene](const Object& object) { return scene->meshes.view(object); },
                              subject.catalog, textures.source(), scene->environment},
                             subject.subject, ways, subject.catalog->roots.front().folder,
                             shareOfTimes * request.seconds, isOver);
    report(textures.takeProblems());
    if (!made && !isStopped()) {
        ways.notes.push_back(
            {{},
             0,
             0,
             "not drawn: " + (options.isDeviceLate() ? std::string("the time was over")
                                                     : made.error().front().text()),
             {}});
    }
    return made ? std::optional(std::move(*made)) : std::nullopt;
}

/// Says what a graphics device, where there is one, told of the ways.
struct DeviceCheck {
    DeviceCheckEnd end = DeviceCheckEnd::Done;
    std::optional<WaysInFrame> inFrame{};
};

/// Tries the ways on the graphics device, where there is one, and draws them. It is an error where
/// their text does not compile there.
Checked<DeviceCheck> checkOnDevice(const ApproximateRequest& request,
                                   const ApproximateSubject& subject, CheaperWays& ways,
                                   const CheaperSearchOptions& options) {
    LongWork work; // a search that was stopped is checked, too
    const auto context = gl::HeadlessContext::create();
    if (!context) {
        ways.notes.push_back({{}, 0, 0, "not checked on the graphics device: there is none", {}});
        return DeviceCheck{DeviceCheckEnd::NoDevice};
    }
    const std::function<bool()> isStopped = [&work] {
        work.report("checking on the graphics device ");
        return work.isStopped();
    };
    const auto count = checkedOnDevice(subject.subject, ways, subject.catalog->roots.front().folder,
                                       options, isStopped);
    if (!count) {
        return tl::unexpected(count.error());
    }
    if (work.isStopped()) {
        return DeviceCheck{DeviceCheckEnd::Stopped};
    }
    return DeviceCheck{DeviceCheckEnd::Done, drawn(request, subject, ways, options, isStopped)};
}

/// Returns the folder that the block is written into: the one that is asked for, or one within it
/// that has the name of the block's kind, without which nothing would find it.
std::filesystem::path folderFor(const std::string& output, const Block& block) {
    const std::filesystem::path whole =
        std::filesystem::absolute(output + '/').lexically_normal().parent_path();
    const std::filesystem::path folder(output);
    return whole.filename() == block.kind ? folder : folder / block.kind;
}

/// Returns why the block could not be written with what is found; empty where it can.
Errors refusals(const ApproximateRequest& request, const Block& block) {
    if (Errors why = whyNotSearched(block); !why.empty()) {
        return why;
    }
    if (!request.output.empty() &&
        isSameFile(folderFor(request.output, block), block.shaderFile.parent_path())) {
        return oneError({request.output, 0, 0, "the block's own files are there, and would be lost",
                         "another folder"});
    }
    return {};
}

Checked<CheaperWays> searched(const ApproximateSubject& subject,
                              const CheaperSearchOptions& options) {
    LongWork work;
    const auto progress = [&work](double share, const CheaperWays& soFar) {
        work.report(fmt::format(
            "{:3.0f} %  {} changes, {} tried, {} cheaper ways{} ", 100.0 * share, soFar.moves,
            soFar.tried, soFar.ways.size(),
            soFar.heldOut > 0 ? fmt::format(", judged on {} cases", soFar.heldOut) : ""));
        return !work.isStopped();
    };
    return cheaperWays(subject.subject, subject.catalog->roots.front().folder, options, progress);
}

/// Writes the block with the ways, and says where.
Result<void> writeWays(const ApproximateSubject& subject, const CheaperWays& ways,
                       const std::filesystem::path& folder) {
    const Block& block = *subject.subject.block.block;
    const auto made = approximatedBlock(subject.subject, ways, usualNaming(block));
    if (!made) {
        return tl::unexpected(made.error());
    }
    if (auto done = writeApproximatedBlock(*made, folder); !done) {
        return done;
    }
    std::cerr << fmt::format("written: {}, {}\n", (folder / (made->id + ".glsl")).string(),
                             (folder / (made->id + ".json")).string());
    if (const std::string how = howToUseLevels(block); !how.empty()) {
        std::cerr << how << '\n';
    }
    const BlockRoot own = standardBlockRoots().back();
    if (!own.shipped && !isSameFile(folder, own.folder / block.kind)) {
        std::cerr << fmt::format("to use it, put both files into {}\n",
                                 (own.folder / block.kind).string());
    }
    return {};
}

/// Returns the exit status.
Checked<int> approximate(const ApproximateRequest& request) {
    const auto subject = subjectOf(request.subject);
    if (!subject) {
        return tl::unexpected(subject.error());
    }
    if (const Errors why = refusals(request, *subject->subject.block.block); !why.empty()) {
        return tl::unexpected(why);
    }
    if (request.families.size() > 1) {
        return tl::unexpected(oneError(
            failure("costs are predicted for one family of graphics cards", "one name after --gpu")
                .value()));
    }
    CheaperSearchOptions options;
    options.family = request.families.empty() ? &gpuFamilies().front() : request.families.front();
    options.seconds = secondsOfSearch(request.seconds);
    options.maxError = request.budgetError;
    options.ways = request.levels;
    options.heldOut = request.cases;
    options.ofValues = subject->ofValues;
    const auto began = std::chrono::steady_clock::now();
    options.isDeviceLate = isOverAfter(request.seconds);
    auto ways = searched(*subject, options);
    if (!ways) {
        return tl::unexpected(ways.error());
    }
    DeviceCheck device;
    if (!ways->ways.empty()) {
        auto checked = checkOnDevice(request, *subject, *ways, options);
        if (!checked) {
            report(ways->notes);
            return tl::unexpected(checked.error());
        }
        device = std::move(*checked);
    }
    const DeviceCheckEnd end = device.end;
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - began;
    const bool isStopped = ways->isStopped || end == DeviceCheckEnd::Stopped;
    std::vector<DeclaredWay> declared;
    if (request.declared && end != DeviceCheckEnd::Stopped) {
        auto judged = declaredOf(*subject, options);
        if (!judged) {
            return tl::unexpected(judged.error());
        }
        declared = std::move(*judged);
    }
    report(ways->notes);
    const WaysTable table{*subject->subject.block.block, *ways, end == DeviceCheckEnd::Done,
                          std::move(device.inFrame), gone.count()};
    if (request.json) {
        nlohmann::json json = waysJson(table);
        if (request.declared) {
            json["declared"] = declaredJson(declared);
        }
        std::cout << writeJson(json);
    } else {
        std::cout << waysText(table) << (request.declared ? declaredText(declared) : "");
    }
    if (!request.output.empty() && !ways->ways.empty()) {
        if (end == DeviceCheckEnd::Stopped) {
            report({{{}, 0, 0, "nothing is written: the check was stopped", {}}});
        } else if (auto done = writeWays(*subject, *ways,
                                         folderFor(request.output, *subject->subject.block.block));
                   !done) {
            return tl::unexpected(oneError(done.error()));
        }
    }
    return isStopped ? LongWork::stoppedStatus : 0;
}

} // namespace

void addApproximate(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "approximate",
        "Search for cheaper ways to compute a model or other block: terms left out, powers, roots\n"
        "and angles by something simpler, terms of one number by polynomials. Each is finite in "
        "the\n"
        "edge cases, with its largest error on cases that the search did not see. Ctrl-C ends the\n"
        "search, and what it has found is checked; a second one leaves that out, and nothing is "
        "written");
    auto options = std::make_shared<ApproximateRequest>();
    command
        ->add_option(
            "subject", options->subject,
            "The id of a model or other block, a preset, whose values then count as given,\n"
            "or a .glsl file with its descriptor beside it")
        ->required();
    addFamiliesOption(*command, options->families);
    command
        ->add_option("--seconds", options->seconds,
                     "How long all of it takes at most, about: what is not judged by then is left\n"
                     "out; 120 without this")
        ->check(CLI::Range(1.0, 600.0));
    command
        ->add_option("--budget-error", options->budgetError,
                     "Leave out what is farther off than this, where white is 1; 0.25 without this")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option("--levels", options->levels, "Keep at most so many ways; 5 without this")
        ->check(CLI::Range(1UL, 20UL));
    command
        ->add_option(
            "--cases", options->cases,
            "Judge the found ways on so many cases that the search did not see; 100000 without\n"
            "this")
        ->check(CLI::Range(1000UL, 10000000UL));
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--declared", options->declared,
                      "Also judge the levels that the block has already, in the same way");
    command->add_option(
        "-o,--output", options->output,
        "Write the block with the found ways as an accuracy choice into this folder, or\n"
        "into one in it that is named after the block's kind, as models/: its GLSL file\n"
        "and its descriptor, ready for your folder of shaders");
    command->callback([options, &status] {
        const Checked<int> ended = approximate(*options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
