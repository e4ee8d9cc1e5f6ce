// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_terms.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "measure/error/parallel.h"

namespace patina {
namespace {

constexpr std::size_t commonCount = 1024;
constexpr std::size_t edgeCount = 2048;
constexpr double endless = std::numeric_limits<double>::infinity();

/// Is where a piece of a shader's text came from.
struct TextPlace {
    std::size_t file = 0; ///< is an index of ShaderSource::files
    int line = 0;

    friend auto operator<=>(const TextPlace&, const TextPlace&) = default;
};

/// Finds the places of a text by its lines "#line N S".
class TextPlaces {
  public:
    explicit TextPlaces(std::string_view text) {
        TextPlace place{0, 1};
        for (std::size_t first = 0; first < text.size();) {
            const std::size_t end = std::min(text.find('\n', first), text.size());
            const std::string_view line = text.substr(first, end - first);
            starts_.push_back(first);
            places_.push_back(place);
            ++place.line;
            if (line.starts_with("#line ")) {
                place = placeIn(line.substr(6)).value_or(place);
            }
            first = end + 1;
        }
    }

    TextPlace at(std::size_t offset) const {
        const auto next = std::ranges::upper_bound(starts_, offset);
        return places_[static_cast<std::size_t>(next - starts_.begin()) - 1];
    }

  private:
    static std::optional<TextPlace> placeIn(std::string_view numbers) {
        int line = 0;
        const auto read = std::from_chars(numbers.data(), numbers.data() + numbers.size(), line);
        if (read.ec != std::errc() || line < 0) {
            return std::nullopt;
        }
        return TextPlace{static_cast<std::size_t>(line / ShaderSource::linesPerFile),
                         line % ShaderSource::linesPerFile};
    }

    std::vector<std::size_t> starts_;
    std::vector<TextPlace> places_;
};

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
    HalfSearch(const EvalCase& subject, bool hasOwnValues, double limit, const MeasuredText& text)
        : limit_(limit), text_(text),
          common_(text.judged(texelsOfCases(
              commonCases(subject, {.count = commonCount, .hasOwnValues = hasOwnValues})))),
          edge_(text.judged(texelsOfCases(edgeCases(subject, edgeCount, hasOwnValues)))) {}

    HalfReport run() {
        findLines();
        report_.limit = limit_;
        report_.cases = common_.texels.size() + edge_.texels.size();
        inParallel(masks_.size(), [this](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                report_.lines[i].error = errorOf(masks_[i]);
            }
        });
        std::vector<std::size_t> all(masks_.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = i;
        }
        report_.whole = errorOf(together(all));
        join();
        return std::move(report_);
    }

  private:
    /// Judges common cases, and looks whether the edge cases stay finite.
    TextError errorOf(const Mask& mask) const {
        TextError error = text_.errorInHalf(mask, common_, endless);
        error.isSafe = error.isSafe && text_.errorInHalf(mask, edge_, endless).isSafe;
        return error;
    }

    Mask together(const std::vector<std::size_t>& lines) const {
        Mask mask(text_.syntax().expressions.size());
        for (const std::size_t line : lines) {
            for (std::size_t i = 0; i < mask.size(); ++i) {
                mask[i] = mask[i] || masks_[line][i];
            }
        }
        return mask;
    }

    void findLines() {
        const ShaderSyntax& syntax = text_.syntax();
        const TextPlaces places(syntax.text);
        const std::vector<ObservedValues> seen = text_.observed(common_.texels);
        const std::vector<ObservedValues> seenAtEdges = text_.observed(edge_.texels);
        std::map<TextPlace, std::size_t> known;
        for (std::size_t i = 0; i < syntax.expressions.size(); ++i) {
            const ShaderExpression& each = syntax.expressions[i];
            const bool isOwn = text_.ownFunctions().contains(each.owner);
            if (!isOwn || !each.type.isFloat() || each.first == each.last || seen[i].count == 0) {
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
            if (report_.lines[i].holds(limit_)) {
                held.push_back(i);
            }
        }
        std::ranges::stable_sort(
            held, {}, [this](std::size_t line) { return report_.lines[line].error.worst; });
        report_.mixed = errorOf(together(held));
        while (!held.empty() && !report_.mixed.isWithin(limit_)) {
            held.pop_back();
            report_.mixed = errorOf(together(held));
        }
        std::ranges::sort(held);
        report_.together = std::move(held);
    }

    double limit_;
    const MeasuredText& text_;
    JudgedCases common_;
    JudgedCases edge_;
    std::vector<Mask> masks_; ///< tell which expressions stand on each line of the report
    HalfReport report_;
};

} // namespace

Checked<HalfReport> halfReport(const EvalCase& subject, const std::filesystem::path& shaders,
                               bool hasOwnValues, double limit) {
    const auto text = MeasuredText::of(subject, shaders);
    if (!text) {
        return tl::unexpected(text.error());
    }
    return HalfSearch(subject, hasOwnValues, limit, *text).run();
}

} // namespace patina
