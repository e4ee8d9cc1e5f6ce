// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cost_prediction.h"

#include <iostream>
#include <memory>
#include <thread>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/prediction_table.h"
#include "cli/prepared_subject.h"

namespace patina {
namespace {

/// Refers to what was prepared, which must outlive it.
PredictedSubject subjectOf(const Prepared& subject, std::shared_ptr<const Catalog> catalog) {
    return {subject.scene, 0,
            [&subject](const Object& object) { return subject.meshes.view(object); },
            std::move(catalog)};
}

FamilyCompilerOptions compilerFor(const LongWork& work) {
    FamilyCompilerOptions options;
    options.isStopped = [&work] { return work.isStopped(); };
    options.processes = std::thread::hardware_concurrency();
    return options;
}

PredictedLevels levelsOf(const CostRequest& options) {
    return options.asItIs ? PredictedLevels::Present : PredictedLevels::Each;
}

Checked<void> predictModels(const Prepared& subject, const CostRequest& options,
                            const std::shared_ptr<const Catalog>& catalog, const LongWork& work) {
    const auto predicted =
        predictedModels(subjectOf(subject, catalog), options.families, compilerFor(work));
    if (!predicted) {
        return tl::unexpected(predicted.error());
    }
    if (options.json) {
        nlohmann::json json = predictionNotes(predicted->driver, options.families);
        json["models"] = predictionJson(predicted->models, options.families);
        std::cout << writeJson(json);
    } else if (options.csv) {
        std::cout << predictionCsv(predicted->models, options.families);
    } else {
        std::cout << predictionText(predicted->models, options.families)
                  << predictionLegend(predicted->driver, options.families);
    }
    return {};
}

Checked<void> predictWays(const std::vector<Prepared>& subjects, const CostRequest& options,
                          const std::shared_ptr<const Catalog>& catalog, const LongWork& work) {
    std::vector<PredictedSubject> shown;
    for (const Prepared& subject : subjects) {
        shown.push_back(subjectOf(subject, catalog));
    }
    const auto predicted =
        predictedWays(shown, levelsOf(options), options.families, compilerFor(work));
    if (!predicted) {
        return tl::unexpected(predicted.error());
    }
    nlohmann::json json = predictionNotes(predicted->driver, options.families);
    std::string text;
    std::vector<NamedWays> named;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const std::string name = nameOf(subjects[i], options);
        const std::vector<PredictedWay>& ways = predicted->subjects[i];
        named.push_back({name, ways});
        text += name + '\n' + predictionText(ways, options.families);
        json["presets"].push_back(
            {{"preset", name}, {"ways", predictionJson(ways, options.families)}});
    }
    std::cout << (options.json  ? writeJson(json)
                  : options.csv ? predictionCsv(named, options.families)
                                : text + predictionLegend(predicted->driver, options.families));
    return {};
}

Error noObject() {
    return failure("there is no object to predict for", "a scene with one").value();
}

/// Predicts the ways of a job's presets. Presets of one model often have the same program, which is
/// compiled once.
class PredictionWork : public JobWork {
  public:
    PredictionWork(const CostRequest& options, std::shared_ptr<const Catalog> catalog,
                   AssetClient& files, const LongWork& work)
        : options_(options), catalog_(std::move(catalog)), files_(files),
          compiler_(compilerFor(work)) {
        compiler_.before = &before_;
    }

    Checked<nlohmann::json> resultOf(const std::string& preset) override {
        const auto subject = prepared(preset, options_.picture, *catalog_, files_);
        if (!subject) {
            return tl::unexpected(subject.error());
        }
        if (subject->scene.objects.empty()) {
            return tl::unexpected(oneError(noObject()));
        }
        const PredictedSubject shown = subjectOf(*subject, catalog_);
        const auto predicted =
            predictedWays(std::span(&shown, 1), levelsOf(options_), options_.families, compiler_);
        if (!predicted) {
            return tl::unexpected(predicted.error());
        }
        return nlohmann::json{
            {"driver", predicted->driver},
            {"predicted", true},
            {"ways", predictionJson(predicted->subjects.front(), options_.families)}};
    }

  private:
    const CostRequest& options_;
    std::shared_ptr<const Catalog> catalog_;
    AssetClient& files_;
    CompiledBefore before_;
    FamilyCompilerOptions compiler_;
};

} // namespace

Checked<bool> predictCosts(const CLI::App& command, const CostRequest& options, LongWork& work) {
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    AssetClient files;
    if (options.job.isWanted()) {
        PredictionWork each(options, catalog, files, work);
        return runJob(
                   {command, options.job, options.presets, *catalog, options.picture.allowsOutside},
                   each, work)
            .map([](int status) { return status == 0; });
    }
    const auto subjects =
        allPrepared(options.presets.empty() ? std::vector<std::string>(1) : options.presets,
                    options, *catalog, files);
    if (!subjects) {
        return tl::unexpected(subjects.error());
    }
    for (const Prepared& subject : *subjects) {
        if (subject.scene.objects.empty()) {
            return tl::unexpected(oneError(noObject()));
        }
    }
    const auto done = options.allModels ? predictModels(subjects->front(), options, catalog, work)
                                        : predictWays(*subjects, options, catalog, work);
    return done ? Checked<bool>(true) : tl::unexpected(done.error());
}

} // namespace patina
