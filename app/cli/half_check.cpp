// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/half_check.h"

#include <cmath>

#include <fmt/format.h>

#include "measure/approximation/half_text.h"
#include "measure/approximation/shader_price.h"

namespace patina {
namespace {

constexpr double largestHalf = 65504.0;

/// Says why a line breaks; empty where it holds.
std::string whyNot(const HalfLine& line, double limit) {
    if (line.holds(limit)) {
        return {};
    }
    if (line.largest > largestHalf) {
        return fmt::format("it reaches {:.2g}, more than 65504", line.largest);
    }
    return line.error.isSafe ? "its digits are too few"
                             : "the value is not finite or negative in edge cases";
}

std::string offText(const TextError& error) {
    return std::isfinite(error.worst) ? fmt::format("{:.2g}", error.worst) : "-";
}

std::string verdictText(const TextError& error, double limit) {
    return fmt::format("at most {} off, {}", offText(error),
                       !error.isSafe           ? "not finite or negative in edge cases"
                       : error.isWithin(limit) ? "which holds"
                                               : "which is too far");
}

nlohmann::json errorJson(const TextError& error, double limit) {
    return {{"atMost", error.worst},
            {"mean", error.mean},
            {"finite", error.isSafe},
            {"holds", error.isWithin(limit)}};
}

std::string changeText(double cost, double inFloat) {
    return fmt::format("{:.0f} cycles ({:+.1f} %)", cost, 100.0 * (cost / inFloat - 1.0));
}

/// Returns "models/phong.glsl:5, models/phong.glsl:7".
std::string placesText(const HalfReport& report, const std::vector<std::size_t>& lines) {
    std::string text;
    for (const std::size_t line : lines) {
        text += fmt::format("{}{}:{}", text.empty() ? "" : ", ", report.lines[line].file,
                            report.lines[line].line);
    }
    return text;
}

std::string priceText(const HalfPrice& price, const HalfReport& report) {
    const std::string family = price.family->label;
    if (!price.note.empty()) {
        return fmt::format("{}: not predicted: {}\n", family, price.note);
    }
    if (!price.inFloat || !price.together) {
        return fmt::format("{}: its compiler has no floats of 16 bits\n", family);
    }
    const std::string best =
        price.lines.empty()
            ? std::string("no part of them is cheaper than floats")
            : fmt::format("the cheapest part {}, {}: {}",
                          changeText(*price.cheapest, *price.inFloat),
                          verdictText(price.error, report.limit), placesText(report, price.lines));
    return fmt::format(
        "{}, predicted: in floats {:.0f} cycles for 64 pixels, these lines in 16 bits "
        "{}; {}\n",
        family, *price.inFloat, changeText(*price.together, *price.inFloat), best);
}

std::string timingText(const Result<HalfTiming>& timing) {
    if (!timing) {
        return timing.error().text() + '\n';
    }
    return fmt::format("here: {:.3f} of the time in floats ({:.3f} .. {:.3f}), {:.3f} ms of {:.3f} "
                       "ms, {} pairs, {}, by {}{}\n",
                       timing->ratio.median, timing->ratio.lower, timing->ratio.upper,
                       timing->halfMilliseconds, timing->milliseconds.median, timing->pairs,
                       timing->method, timing->extension,
                       timing->hasFunctions ? "" : " (functions such as pow() in floats)");
}

std::string mixedText(const MixedForm& mixed, const HalfReport& report) {
    std::string text;
    for (const HalfPrice& price : mixed.prices) {
        text += priceText(price, report);
    }
    if (mixed.timing) {
        text += timingText(*mixed.timing);
    }
    return text + mixed.text;
}

nlohmann::json timingJson(const Result<HalfTiming>& timing) {
    if (!timing) {
        return {{"problem", timing.error().text()}};
    }
    return {{"ratio",
             {{"median", timing->ratio.median},
              {"lower", timing->ratio.lower},
              {"upper", timing->ratio.upper}}},
            {"milliseconds", timing->milliseconds.median},
            {"halfMilliseconds", timing->halfMilliseconds},
            {"pairs", timing->pairs},
            {"method", timing->method},
            {"extension", timing->extension},
            {"functionsInHalf", timing->hasFunctions}};
}

void addTo(nlohmann::json& json, const MixedForm& mixed) {
    for (const HalfPrice& price : mixed.prices) {
        if (price.inFloat && price.together) {
            json["cycles"][price.family->id] = {{"float", *price.inFloat},
                                                {"mixed", *price.together},
                                                {"cheapest", *price.cheapest},
                                                {"lines", price.lines}};
        } else if (!price.note.empty()) {
            json["cycles"][price.family->id] = {{"problem", price.note}};
        }
    }
    if (mixed.timing) {
        json["timing"] = timingJson(*mixed.timing);
    }
    if (!mixed.text.empty()) {
        json["mixedText"] = mixed.text;
    }
}

} // namespace

MixedForm mixedForm(const EvalCase& subject, const HalfReport& report, const HalfCheckWish& wish,
                    LongWork& work) {
    MixedForm form;
    for (const GpuFamily* family : wish.families) {
        const auto progress = [&](double share) {
            work.report(fmt::format("{:3.0f} %  for {} ", 100.0 * share, family->label));
            return !work.isStopped();
        };
        HalfPrice price = halfPrice(subject, report, *family, progress);
        if (work.isStopped()) {
            break;
        }
        form.prices.push_back(std::move(price));
    }
    work.report({});
    if (wish.isTimed && !work.isStopped()) {
        form.timing = halfTiming(subject, report, report.together);
    }
    if (wish.hasText) {
        const ShaderPrice program(subject, report.text->source(), report.text->syntax(),
                                  gpuFamilies().front());
        form.text =
            program.programOf(halfEdits(*report.text, report.halvedBy(report.together), vulkanHalf))
                .fragment;
    }
    return form;
}

std::string halfText(const HalfReport& report, const std::string& name, const MixedForm& mixed) {
    std::string text = fmt::format("{}: floats of 16 bits, each line by itself\n"
                                   "         at most off  line\n",
                                   name);
    std::string file;
    for (const HalfLine& line : report.lines) {
        if (line.file != file) {
            file = line.file;
            text += file + '\n';
        }
        const std::string why = whyNot(line, report.limit);
        text += fmt::format("{:<7}  {:>11}  {}: {}\n", why.empty() ? "holds" : "breaks",
                            offText(line.error), line.line, line.code);
        if (!why.empty()) {
            text += fmt::format("{:22}{}\n", "", why);
        }
    }
    return text +
           fmt::format("all lines: {}\n{} of {} lines, together: {}\n"
                       "where white is 1, {:.2g} holds; {} cases\n",
                       verdictText(report.whole, report.limit), report.together.size(),
                       report.lines.size(), verdictText(report.mixed, report.limit), report.limit,
                       report.cases) +
           mixedText(mixed, report);
}

nlohmann::json halfJson(const HalfReport& report, const std::string& name, const MixedForm& mixed) {
    nlohmann::json lines = nlohmann::json::array();
    for (const HalfLine& line : report.lines) {
        nlohmann::json each = errorJson(line.error, report.limit);
        each["file"] = line.file;
        each["line"] = line.line;
        each["code"] = line.code;
        each["largest"] = line.largest;
        each["why"] = whyNot(line, report.limit);
        lines.push_back(std::move(each));
    }
    nlohmann::json json{{"subject", name},
                        {"precision", "half"},
                        {"lines", lines},
                        {"whole", errorJson(report.whole, report.limit)},
                        {"mixed", errorJson(report.mixed, report.limit)},
                        {"together", report.together},
                        {"limit", report.limit},
                        {"cases", report.cases}};
    addTo(json, mixed);
    return json;
}

} // namespace patina
