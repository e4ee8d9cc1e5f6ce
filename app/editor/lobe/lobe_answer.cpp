// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/lobe_answer.h"

#include <algorithm>

#include "measure/approximation/half_lines.h"

namespace patina {
namespace {

constexpr int sliceCells = 90;
constexpr int sketchCells = 30;
constexpr SolidFineness sketchFineness{12, 20}; // four of these are painted in a frame

bool hasLines(LobePage page) {
    return page != LobePage::Solid && page != LobePage::Slice;
}

bool isSameButFor(bool isSketch, LobeQuestion question, const LobeQuestion& other) {
    question.lines.isSketch = isSketch;
    return question == other;
}

decltype(LobeAnswer::plot) plotOf(const LobeMaterial& material, const LobeQuestion& question,
                                  const Catalog& catalog, const std::function<bool()>& isWanted,
                                  EvalGpu* device) {
    const auto& [page, request] = question;
    if (hasLines(page)) {
        auto lines =
            page == LobePage::Float16
                ? halfLines(catalog, material.material, request, catalog.roots.front().folder)
                : lobeLines(catalog, material.material, request, isWanted, device);
        if (!lines) {
            return tl::unexpected(lines.error());
        }
        return LobeSubject{material.name, std::move(*lines)};
    }
    const auto model = reflectanceModel(catalog, material.material, request.term);
    if (!model) {
        return tl::unexpected(model.error());
    }
    std::variant<LobeSubject, NamedSolid, NamedSlice> plot;
    if (page == LobePage::Solid) {
        plot = NamedSolid{material.name,
                          lobeSolid(*model, request.incoming,
                                    request.isSketch ? sketchFineness : SolidFineness())};
    } else {
        plot = NamedSlice{material.name,
                          halfDifferenceSlice(*model, request.isSketch ? sketchCells : sliceCells)};
    }
    if (const auto ended = model->ending(); !ended) {
        return tl::unexpected(ended.error());
    }
    return plot;
}

} // namespace

LobePlot linesOf(LobePage page) {
    switch (page) {
    case LobePage::Albedo:
        return LobePlot::Albedo;
    case LobePage::Fresnel:
        return LobePlot::Fresnel;
    case LobePage::Spectrum:
        return LobePlot::Spectrum;
    case LobePage::Float32:
        return LobePlot::Float32;
    case LobePage::Float16:
        return LobePlot::Float16;
    default:
        return LobePlot::Polar;
    }
}

SharedAnswer lobeAnswer(const LobeMaterial& material, const LobeQuestion& question,
                        const Catalog& catalog, const std::function<bool()>& isWanted,
                        EvalGpu* device) {
    LobeAnswer answer{
        material, question, plotOf(material, question, catalog, isWanted, device), {}};
    if (question.page == LobePage::Albedo && !question.lines.isSketch) {
        answer.turned = turnedAlbedos(catalog, material.material, question.lines, isWanted);
    }
    return std::make_shared<const LobeAnswer>(std::move(answer));
}

std::vector<SharedAnswer> LobeAnswers::known(const std::vector<LobeMaterial>& materials,
                                             const LobeQuestion& question) const {
    std::vector<SharedAnswer> answers;
    for (const LobeMaterial& material : materials) {
        const auto find = [&](bool isSketch) {
            return std::ranges::find_if(all_, [&](const SharedAnswer& each) {
                return isSameButFor(isSketch, question, each->question) &&
                       each->material == material;
            });
        };
        auto found = find(question.lines.isSketch);
        if (found == all_.end() && hasLines(question.page)) {
            found = find(false);
        }
        answers.push_back(found != all_.end() ? *found : nullptr);
    }
    return answers;
}

void LobeAnswers::keep(const std::vector<SharedAnswer>& answers) {
    const auto isOld = [&answers](const SharedAnswer& known) {
        return std::ranges::none_of(answers, [&known](const SharedAnswer& each) {
            return each->material == known->material &&
                   isSameButFor(known->question.lines.isSketch, each->question, known->question);
        });
    };
    std::erase_if(all_, isOld);
    for (const SharedAnswer& each : answers) {
        if (std::ranges::find(all_, each) == all_.end()) {
            all_.push_back(each);
        }
    }
}

} // namespace patina
