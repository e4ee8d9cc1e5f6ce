// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/match/model_matches.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "core/progress.h"
#include "material/measured_preset.h"
#include "material/model_swap.h"
#include "material/preset_file.h"
#include "measure/error/parallel.h"
#include "measure/eval/model_values.h"
#include "measure/lobe/lobe_model.h"
#include "measure/match/free_numbers.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

/// Writes the fitted values of a block into those of a material.
void takeValues(BlockValues& values, const EvalBlock& fitted) {
    for (const auto& [id, value] : fitted.values) {
        values.parameters[id] = roundedToFloat(value);
    }
}

Result<ModelMatch> fittedMaterial(const Material& material, const MatchTarget& target,
                                  const FitOptions& options, const Catalog& catalog,
                                  const Progress& progress) {
    const Result<EvalCase> model = sweepVariant(catalog, material);
    if (!model) {
        return tl::unexpected(model.error());
    }
    if (const std::string why = whyNoReflectance(*model->block.block); !why.empty()) {
        return failure(why);
    }
    const Result<ModelFit> fit = fittedModel(*model, target, options, catalog, progress);
    if (!fit) {
        return tl::unexpected(fit.error());
    }
    const Block& block = *model->block.block;
    ModelMatch match{material, block.label, fit->error, fit->relative, {}};
    match.isStopped = progress.cancelled;
    match.material.description = target.name.empty()
                                     ? fmt::format("{}, fitted", block.label)
                                     : fmt::format("{}, fitted to {}", block.label, target.name);
    takeValues(match.material.model, fit->model.block);
    if (const Block* filler = fit->model.slot.block) {
        BlockValues part;
        part.id = filler->id;
        part.version = filler->version;
        takeValues(part, fit->model.slot);
        setPart(match.material.parts, filler->kind, part);
    }
    return match;
}

/// Returns about how long a fit takes, in any unit: the time of some values, for each of the
/// numbers that change.
double effortOf(const Material& material, const MatchTarget& target, const Catalog& catalog) {
    constexpr std::size_t timedValues = 64;
    const Result<EvalCase> model = sweepVariant(catalog, material);
    const Result<ModelValues> values =
        model ? ModelValues::of(*model, catalog) : tl::unexpected(model.error());
    if (!values) {
        return 0.0;
    }
    const auto began = std::chrono::steady_clock::now();
    volatile double sum = 0.0; // what is not used is not computed
    for (std::size_t i = 0; i < std::min(timedValues, target.pairs.size()); ++i) {
        sum = sum + values->at(target.pairs[i]).x;
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
    return spent.count() * double(FreeNumbers(*model).size() + 1);
}

/// Returns pointers to the materials, beginning with the slowest, so that no core waits long for
/// the last one.
std::vector<const Material*> slowestFirst(const std::vector<Material>& materials,
                                          const MatchTarget& target, const Catalog& catalog) {
    std::vector<std::pair<double, const Material*>> efforts;
    for (const Material& material : materials) {
        efforts.emplace_back(effortOf(material, target, catalog), &material);
    }
    std::ranges::stable_sort(efforts, std::greater(), &std::pair<double, const Material*>::first);
    std::vector<const Material*> ordered;
    for (const auto& [effort, material] : efforts) {
        ordered.push_back(material);
    }
    return ordered;
}

} // namespace

std::vector<const Block*> matchedModels(const Catalog& catalog) {
    std::vector<const Block*> models = catalog.ofKind(kinds::models);
    std::erase_if(models, [](const Block* model) {
        return !whyNoReflectance(*model).empty() || tableParameter(*model) != nullptr;
    });
    return models;
}

Material matchStart(const Material& own, const MatchAim& aim, const Block& model,
                    const Catalog& catalog) {
    Material start = swappedModel(own, model, catalog);
    if (aim.material) {
        const Material swapped = swappedModel(*aim.material, model, catalog);
        start.model = swapped.model;
        start.parts = swapped.parts;
    }
    return start;
}

ModelMatches fittedMaterials(const std::vector<Material>& materials, const MatchTarget& target,
                             const FitOptions& options, const Catalog& catalog,
                             const GoesOn& goesOn) {
    const std::vector<const Material*> ordered = slowestFirst(materials, target, catalog);
    ModelMatches matches;
    Progress progress;
    std::mutex guard;
    std::condition_variable changed;
    std::size_t next = 0;
    std::size_t done = 0;
    const auto work = [&] {
        std::unique_lock lock(guard);
        while (next < materials.size() && !progress.cancelled) {
            const Material& material = *ordered[next++];
            lock.unlock();
            auto match = fittedMaterial(material, target, options, catalog, progress);
            lock.lock();
            if (match) {
                matches.rows.push_back(std::move(*match));
            } else {
                matches.problems.push_back(match.error());
            }
            ++done;
            changed.notify_one();
        }
    };
    {
        std::vector<std::jthread> threads(parallelParts());
        for (std::jthread& thread : threads) {
            thread = std::jthread(work);
        }
        std::unique_lock lock(guard);
        while (done < materials.size() && !progress.cancelled) {
            progress.cancelled = !goesOn(double(done) / double(materials.size()), matches);
            changed.wait_for(lock, std::chrono::milliseconds(100));
        }
    }
    std::ranges::sort(matches.rows, {}, [](const ModelMatch& match) {
        return std::pair(match.error, match.material.model.id);
    });
    return matches;
}

void addTimes(ModelMatches& matches, const std::map<std::string, double>& nanoseconds) {
    for (ModelMatch& row : matches.rows) {
        const auto found = nanoseconds.find(row.material.model.id);
        row.nanoseconds = found != nanoseconds.end() ? std::optional(found->second) : std::nullopt;
    }
    for (ModelMatch& row : matches.rows) {
        row.isOnFront = std::ranges::none_of(matches.rows, [&row](const ModelMatch& other) {
            return row.nanoseconds && other.nanoseconds && other.error < row.error &&
                   *other.nanoseconds < *row.nanoseconds;
        });
    }
}

const ModelMatch* quickestWithin(const ModelMatches& matches, double within) {
    const ModelMatch* quickest = nullptr;
    for (const ModelMatch& row : matches.rows) {
        if (row.nanoseconds && row.relative <= within &&
            (quickest == nullptr || *row.nanoseconds < *quickest->nanoseconds)) {
            quickest = &row;
        }
    }
    return quickest;
}

std::string matchesText(const ModelMatches& matches, double within) {
    std::string text =
        fmt::format("{:<28} {:>10} {:>10} {:>10}\n", "model", "error", "relative", "ns/pixel");
    bool hasTimes = false;
    for (const ModelMatch& row : matches.rows) {
        const std::string time = row.nanoseconds ? fmt::format("{:.1f}", *row.nanoseconds) : "-";
        hasTimes = hasTimes || row.nanoseconds.has_value();
        text += fmt::format("{:<28} {:>10.5f} {:>8.2f} % {:>10}{}{}\n", row.label, row.error,
                            100.0 * row.relative, time,
                            row.nanoseconds && row.isOnFront ? "  front" : "",
                            row.isStopped ? "  stopped before its end" : "");
    }
    if (!hasTimes) {
        return text;
    }
    const ModelMatch* quickest = quickestWithin(matches, within);
    return text + (quickest != nullptr ? fmt::format("the quickest within {:g} %: {}\n",
                                                     100.0 * within, quickest->label)
                                       : fmt::format("none is within {:g} %\n", 100.0 * within));
}

std::string matchesCsv(const ModelMatches& matches) {
    std::string text = "model,error,relative,ns_per_pixel,front,stopped\n";
    for (const ModelMatch& row : matches.rows) {
        text += fmt::format("{},{},{},{},{},{}\n", row.material.model.id, row.error, row.relative,
                            row.nanoseconds ? fmt::format("{}", *row.nanoseconds) : "-",
                            row.nanoseconds && row.isOnFront ? 1 : 0, row.isStopped ? 1 : 0);
    }
    return text;
}

nlohmann::json matchesJson(const ModelMatches& matches) {
    nlohmann::json rows = nlohmann::json::array();
    for (const ModelMatch& row : matches.rows) {
        rows.push_back({{"model", row.material.model.id},
                        {"label", row.label},
                        {"error", row.error},
                        {"relative", row.relative},
                        {"nanosecondsPerPixel",
                         row.nanoseconds ? nlohmann::json(*row.nanoseconds) : nlohmann::json()},
                        {"front", row.nanoseconds.has_value() && row.isOnFront},
                        {"stopped", row.isStopped},
                        {"preset", toJson(row.material)}});
    }
    return rows;
}

} // namespace patina
