// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_terms.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "measure/error/parallel.h"
#include "shading/glsl/text_places.h"

namespace patina {
namespace {

constexpr std::size_t commonCount = 1024;
constexpr std::size_t edgeCount = 2048;
constexpr double endless = std::numeric_limits<double>::infinity();

std::string lineAround(std::string_view text, std::size_t offset) {
    const std::size_t before = text.rfind('\n', offset);
    const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
    std::string_view line = text.substr(first, text.find('\n', offset) - first);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) {
        line.remove_suffix(1);
    }
    return std::string(line);
}

/// Tells of each expression of a text whether it has 16 bits.
using Mask = std::vector<bool>;

class HalfSearch {
  public:
    HalfSearch(const EvalCase& subject, bool hasOwnValues, double limit,
               std::shared_ptr<const MeasuredText> text, const HalfProgress& progress)
        : text_(*text), masks_(report_.marks), progress_(progress) {
        report_.limit = limit;
        report_.common = std::make_shared<const JudgedCases>(text_.judged(texelsOfCases(
            commonCases(subject, {.count = commonCount, .hasOwnValues = hasOwnValues}))));
        report_.edge = std::make_shared<const JudgedCases>(
            text_.judged(texelsOfCases(edgeCases(subject, edgeCount, hasOwnValues))));
        report_.text = std::move(text);
    }

    /// Returns nothing where it is ended.
    std::optional<HalfReport> run() {
        findLines();
        report_.cases = report_.common->texels.size() + report_.edge->texels.size();
        judgeLines();
        std::vector<std::size_t> all(masks_.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = i;
        }
        if (!isEnded_) {
            report_.whole = report_.errorOf(report_.halvedBy(all));
            join();
        }
        return isEnded_ ? std::nullopt : std::optional(std::move(report_));
    }

  private:
    /// Tells how many lines are judged, out of all and those that join() tries to leave out.
    void tell(std::size_t judged) {
        const double share = double(judged) / double(masks_.size() + 2);
        isEnded_ = isEnded_ || !progress_(std::min(share, 1.0));
    }

    void judgeLines() {
        std::atomic<std::size_t> judged{0};
        inParallel(masks_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !isEnded_; ++i) {
                report_.lines[i].error = report_.errorOf(masks_[i]);
                ++judged;
                if (part == 0) {
                    tell(judged);
                }
            }
        });
    }

    void findLines() {
        const ShaderSyntax& syntax = text_.syntax();
        const TextPlaces places(syntax.text);
        const std::vector<ObservedValues> seen = text_.observed(report_.common->texels);
        const std::vector<ObservedValues> seenAtEdges = text_.observed(report_.edge->texels);
        const std::vector<bool> own = text_.ownFloats();
        std::map<TextPlace, std::size_t> known;
        for (std::size_t i = 0; i < syntax.expressions.size(); ++i) {
            const ShaderExpression& each = syntax.expressions[i];
            if (!own[i] || seen[i].count == 0) {
                continue;
            }
            const TextPlace place = places.at(each.first);
            const auto [line, isNew] = known.try_emplace(place, masks_.size());
            if (isNew) {
                masks_.emplace_back(syntax.expressions.size());
                report_.lines.push_back(
                    {nameOf(place.file), place.line, lineAround(syntax.text, each.first), {}, 0.0});
            }
            masks_[line->second][i] = true;
            double& largest = report_.lines[line->second].largest;
            largest = std::max(
                {largest, largestOf(seen[i], each.size), largestOf(seenAtEdges[i], each.size)});
        }
        sortLines();
    }

    static double largestOf(const ObservedValues& values, std::size_t size) {
        double largest = 0.0;
        for (std::size_t i = 0; i < std::min<std::size_t>(size, 4); ++i) {
            largest = std::max({largest, std::abs(values.min[i]), std::abs(values.max[i])});
        }
        return largest;
    }

    void sortLines() {
        std::vector<std::pair<HalfLine, Mask>> both;
        for (std::size_t i = 0; i < masks_.size(); ++i) {
            both.emplace_back(std::move(report_.lines[i]), std::move(masks_[i]));
        }
        std::ranges::stable_sort(both, [](const auto& a, const auto& b) {
            return std::tie(a.first.file, a.first.line) < std::tie(b.first.file, b.first.line);
        });
        for (std::size_t i = 0; i < both.size(); ++i) {
            report_.lines[i] = std::move(both[i].first);
            masks_[i] = std::move(both[i].second);
        }
    }

    std::string nameOf(std::size_t file) const {
        const auto& files = text_.source().files;
        if (file >= files.size()) {
            return {};
        }
        const std::filesystem::path path = files[file];
        return (path.parent_path().filename() / path.filename()).string();
    }

    /// Puts the lines together that hold by themselves, and leaves out the least exact ones until
    /// all that are left hold at once.
    void join() {
        std::vector<std::size_t> held;
        for (std::size_t i = 0; i < report_.lines.size(); ++i) {
            if (report_.lines[i].holds(report_.limit)) {
                held.push_back(i);
            }
        }
        std::ranges::stable_sort(
            held, {}, [this](std::size_t line) { return report_.lines[line].error.worst; });
        report_.mixed = report_.errorOf(report_.halvedBy(held));
        while (!held.empty() && !report_.mixed.isWithin(report_.limit) && !isEnded_) {
            tell(masks_.size() + 1);
            held.pop_back();
            report_.mixed = report_.errorOf(report_.halvedBy(held));
        }
        std::ranges::sort(held);
        report_.together = std::move(held);
    }

    HalfReport report_;
    const MeasuredText& text_;
    std::vector<Mask>& masks_; ///< are the report's
    const HalfProgress& progress_;
    std::atomic<bool> isEnded_{false};
};

} // namespace

std::vector<bool> HalfReport::halvedBy(const std::vector<std::size_t>& some) const {
    Mask halved(text->syntax().expressions.size());
    for (const std::size_t line : some) {
        for (std::size_t i = 0; i < halved.size(); ++i) {
            halved[i] = halved[i] || marks[line][i];
        }
    }
    return halved;
}

TextError HalfReport::errorOf(const std::vector<bool>& halved) const {
    TextError error = text->errorInHalf(halved, *common, endless);
    error.isSafe = error.isSafe && text->errorInHalf(halved, *edge, endless).isSafe;
    return error;
}

Checked<HalfReport> halfReport(const EvalCase& subject, const std::filesystem::path& shaders,
                               bool hasOwnValues, double limit, const HalfProgress& progress) {
    auto text = MeasuredText::of(subject, shaders);
    if (!text) {
        return tl::unexpected(text.error());
    }
    auto report = HalfSearch(subject, hasOwnValues, limit,
                             std::make_shared<const MeasuredText>(std::move(*text)), progress)
                      .run();
    return report ? Checked<HalfReport>(std::move(*report))
                  : tl::unexpected(oneError(Error{{}, 0, 0, "it was stopped", {}}));
}

} // namespace patina
