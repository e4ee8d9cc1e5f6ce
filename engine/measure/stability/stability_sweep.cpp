// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/stability_sweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

#include "measure/error/parallel.h"
#include "measure/eval/eval_program.h"
#include "measure/stability/claim_sweep.h"
#include "measure/stability/edge_case_directions.h"
#include "measure/stability/edge_case_fields.h"
#include "measure/stability/error_bound.h"
#include "measure/stability/sweep_cases.h"
#include "measure/stability/value_checks.h"

namespace patina {
namespace {

std::vector<double> inFloat(std::vector<double> values) {
    for (double& x : values) {
        x = static_cast<double>(static_cast<float>(x));
    }
    return values;
}

std::vector<double> packedInFloat(const EvalBlock& block) {
    return block.block == nullptr ? std::vector<double>() : inFloat(block.packedValues());
}

/// Is the least value whose digits are compared. Devices flush results below 1.2e-38 to 0, and
/// products of smaller values may get there on the way to a result that is large again.
constexpr double minExact = 1e-30;

bool hasLostDigits(const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(),
                       [](double x) { return x != 0.0 && std::abs(x) < minExact; });
}

/// Is the least cosine for which digits are compared. Nearer to the horizon values need only be
/// finite and not negative, since squares of such cosines underflow in a float.
constexpr double minExactCosine = 1e-9;

bool hasLostDigits(const EvalPlace& place) {
    const auto isLost = [&place](const glm::dvec3& direction) {
        const double cosine = std::abs(glm::dot(place.n, direction));
        return cosine > 0.0 && cosine < minExactCosine;
    };
    const glm::dvec3 half = glm::normalize(place.l) + glm::normalize(place.v);
    return isLost(place.l) || isLost(place.v) || isLost(half);
}

std::vector<EvalPlace> edgeCasesOf(const EvalCase& variant) {
    return variant.subject == EvalCase::Subject::Fields ? edgeCaseFields(fieldsOf(variant))
                                                        : edgeCaseDirections(variant.subject);
}

/// Is the number of places between the edge cases, where a formula may break as well; an interval
/// of cosines that is 1/200 wide has several.
constexpr std::size_t ordinaryCount = 2048;

/// Returns ordinary places; a function of the block's values alone has only one.
std::vector<EvalPlace> ordinaryPlacesOf(const EvalCase& variant) {
    if (variant.subject != EvalCase::Subject::Fields) {
        return ordinaryPlaces(variant.subject, ordinaryCount);
    }
    const auto fields = fieldsOf(variant);
    return ordinaryFields(fields, fields.empty() ? 1 : ordinaryCount);
}

/// Says that one in so many of the places with a further set of values is an ordinary one.
constexpr std::size_t ordinaryEvery = 4;

/// Returns a step that reaches every place, since it is coprime to their number.
std::size_t strideFor(std::size_t places) {
    std::size_t stride = places / 3 + 1;
    while (std::gcd(stride, places) != 1) {
        ++stride;
    }
    return stride;
}

/// Returns so many evenly spread items; `phase` from 0 to 1 says where in the first step the first
/// one lies.
template <class Item>
std::vector<Item> thinned(std::vector<Item> all, std::size_t count, double phase) {
    if (count >= all.size()) {
        return all;
    }
    const double step = static_cast<double>(all.size()) / static_cast<double>(count);
    std::vector<Item> few;
    for (std::size_t i = 0; i < count; ++i) {
        const double place = (static_cast<double>(i) + phase) * step;
        few.push_back(std::move(all[static_cast<std::size_t>(place)]));
    }
    return few;
}

/// Is the number of places with each set of values where the sweep is whole.
constexpr std::size_t wholePlacesPerRow = 16;

} // namespace

/// Says what a program's share of a sweep is.
struct StabilitySweep::Share {
    std::size_t cases = 0;
    double phase = 0.0; ///< is that of thinned(), 0 .. 1
};

/// Numbers the cases of one program and evaluates them: every place with the variant's own values,
/// then a few places, edge cases and ordinary ones, with every other set of values.
class StabilitySweep::Variant {
  public:
    Variant(const EvalCase& variant, const SweepOptions& options, const Share& share)
        : options_(options), variant_(variant), rows_(sweepRows(variant)),
          places_(edgeCasesOf(variant)), ordinary_(ordinaryPlacesOf(variant)), checks_(variant) {
        placesPerRow_ = std::min(wholePlacesPerRow, places_.size());
        wholeCount_ = count();
        if (!options.isWhole && share.cases < wholeCount_) {
            thin(share);
        } else {
            placesPerRow_ = std::clamp(share.cases / rows_.size(), placesPerRow_, places_.size());
        }
        edgeCaseCount_ = places_.size();
        stride_ = strideFor(edgeCaseCount_);
        places_.insert(places_.end(), ordinary_.begin(), ordinary_.end());
        ordinary_.clear();
    }

    /// Finds the code and links the program, evaluates all cases, then tries the claims.
    Steps run(std::string& withoutReference, SweepReport& report) {
        ++report.programs;
        Result<void> done = open(withoutReference, report);
        while (done && done_ < count()) {
            co_yield Steps::Pause();
            done = evaluateSlice(report);
        }
        if (done && claims_) {
            co_await claims_->run(*program_, report, done);
        }
        if (!done) {
            report.errors.push_back(done.error());
        }
    }

    double progress() const {
        const double values = static_cast<double>(done_) / static_cast<double>(count());
        return claims_ ? 0.5 * (values + claims_->progress()) : values;
    }

    std::size_t count() const {
        return places_.size() + ordinary_.size() + (rows_.size() - 1) * placesPerRow_;
    }

    std::size_t leftOut() const { return wholeCount_ > count() ? wholeCount_ - count() : 0; }

  private:
    /// Thins the cases out: half of them keep the variant's own values, half have the other sets.
    void thin(const Share& share) {
        const std::size_t ownPlaces = std::max<std::size_t>(1, share.cases / 2);
        const std::size_t furtherCases = share.cases - std::min(share.cases, ownPlaces);
        const double ordinaryShare = static_cast<double>(ordinary_.size()) /
                                     static_cast<double>(places_.size() + ordinary_.size());
        const auto ordinaryOnes =
            static_cast<std::size_t>(ordinaryShare * static_cast<double>(ownPlaces));
        places_ = thinned(std::move(places_), ownPlaces - ordinaryOnes, share.phase);
        ordinary_ = thinned(std::move(ordinary_), ordinaryOnes, share.phase);
        const EvalCase own = rows_.front();
        rows_.erase(rows_.begin());
        rows_ = thinned(std::move(rows_), std::min(rows_.size(), furtherCases), share.phase);
        placesPerRow_ =
            rows_.empty() ? placesPerRow_
                          : std::clamp<std::size_t>(furtherCases / rows_.size(), 1, placesPerRow_);
        placesPerRow_ = std::min(placesPerRow_, places_.size());
        rows_.insert(rows_.begin(), own);
    }

    /// Finds the code and links the program. It is an error where the program cannot be linked, or
    /// neither the CPU nor the device can evaluate.
    Result<void> open(std::string& withoutReference, SweepReport& report) {
        if (options_.cpu) {
            const auto code = ReferenceCode::find(variant_);
            code_ = code ? std::optional(*code) : std::nullopt;
            withoutReference = code ? withoutReference : code.error().problem;
        }
        report.withoutDouble = report.withoutDouble || !code_;
        report.withoutDevice = report.withoutDevice || !options_.gpu;
        if (!options_.gpu) {
            return code_ ? Result<void>() : failure(withoutReference, "a graphics device");
        }
        auto program = EvalProgram::link(variant_, options_.shaders);
        if (!program) {
            return tl::unexpected(program.error());
        }
        program_.emplace(std::move(*program));
        EvalProgram::bindMeasured(measured_, variant_);
        if (!code_) {
            claims_.emplace(variant_);
        }
        return {};
    }

    Result<void> evaluateSlice(SweepReport& report) {
        const std::size_t size = std::min(options_.slice, count() - done_);
        std::vector<float> drawn;
        if (program_) {
            Result<std::vector<float>> read = program_->draw(texels(done_, size), size);
            if (!read) {
                return tl::unexpected(read.error());
            }
            drawn = std::move(*read);
        }
        std::vector<SweepReport> parts(parallelParts());
        inParallel(size, [&](std::size_t part, std::size_t begin, std::size_t end) {
            examine(done_, begin, end, drawn, parts[part]);
        });
        for (const SweepReport& part : parts) {
            report.add(part);
        }
        report.cases += size;
        done_ += size;
        return {};
    }

    std::size_t rowOf(std::size_t i) const {
        return i < places_.size() ? 0 : 1 + (i - places_.size()) / placesPerRow_;
    }

    const EvalPlace& placeOf(std::size_t i) const {
        if (i < places_.size()) {
            return places_[i];
        }
        const std::size_t further = i - places_.size();
        const std::size_t ordinary = further / ordinaryEvery;
        return further % ordinaryEvery == 0 && places_.size() > edgeCaseCount_
                   ? places_[edgeCaseCount_ + ordinary % (places_.size() - edgeCaseCount_)]
                   : places_[(further - ordinary) * stride_ % edgeCaseCount_];
    }

    EvalCase caseOf(std::size_t i) const {
        EvalCase request = rows_[rowOf(i)];
        static_cast<EvalPlace&>(request) = placeOf(i);
        return request;
    }

    std::vector<float> texels(std::size_t from, std::size_t size) const {
        const auto numbers = static_cast<std::size_t>(program_->shape().caseTexels) * 4;
        std::vector<float> all;
        all.reserve(size * numbers);
        EvalCase request = rows_[rowOf(from)];
        std::vector<float> values = valueTexels(request);
        for (std::size_t i = from, row = rowOf(from); i < from + size; ++i) {
            if (rowOf(i) != row) {
                row = rowOf(i);
                values = valueTexels(rows_[row]);
            }
            static_cast<EvalPlace&>(request) = placeOf(i);
            const std::vector<float> place = placeTexels(request);
            all.insert(all.end(), place.begin(), place.end());
            all.insert(all.end(), values.begin(), values.end());
            all.resize((i - from + 1) * numbers);
        }
        return all;
    }

    /// Checks the cases from + begin .. from + end; `drawn` holds the device's numbers from case
    /// `from` on.
    void examine(std::size_t from, std::size_t begin, std::size_t end,
                 const std::vector<float>& drawn, SweepReport& report) const {
        std::unique_ptr<ReferenceCase> bound;
        std::size_t row = rows_.size();
        for (std::size_t i = begin; i < end; ++i) {
            if (code_ && rowOf(from + i) != row) {
                row = rowOf(from + i);
                bound = std::make_unique<ReferenceCase>(*code_, packedInFloat(rows_[row].block),
                                                        packedInFloat(rows_[row].slot));
            }
            ReferenceNumbers device{};
            if (!drawn.empty()) {
                std::copy_n(drawn.begin() + static_cast<std::ptrdiff_t>(i * checks_.numbers()),
                            checks_.numbers(), device.begin());
            }
            examineCase(from + i, bound.get(), drawn.empty() ? nullptr : &device, report);
        }
    }

    void examineCase(std::size_t i, const ReferenceCase* bound, const ReferenceNumbers* device,
                     SweepReport& report) const {
        bool clean = true;
        if (device != nullptr) {
            clean = examineNumbers(i, *device, true, report);
        }
        if (bound == nullptr) {
            return;
        }
        const ReferenceNumbers exact = bound->evaluate(placeOf(i));
        clean = examineNumbers(i, exact, false, report) && clean;
        if (clean && device != nullptr && options_.error) {
            examineError(i, *bound, exact, *device, report);
        }
    }

    bool examineNumbers(std::size_t i, const ReferenceNumbers& numbers, bool gpu,
                        SweepReport& report) const {
        double excess = 0.0;
        const std::span<const double> own(numbers.data(), checks_.numbers());
        const auto defect = checks_.check(placeOf(i), own, excess);
        if (defect) {
            report.add({*defect, requestOf(i, gpu), numbers, checks_.numbers(), {}, excess});
        }
        return !defect;
    }

    void examineError(std::size_t i, const ReferenceCase& bound, const ReferenceNumbers& exact,
                      const ReferenceNumbers& device, SweepReport& report) const {
        const bool isModel = variant_.subject == EvalCase::Subject::Model;
        if (hasLostDigits(bound.values()) || hasLostDigits(bound.slotValues()) ||
            (isModel && hasLostDigits(placeOf(i)))) {
            return;
        }
        double excess = 0.0;
        for (std::size_t k = 0; k < checks_.numbers(); ++k) {
            excess = std::max(excess, std::abs(device[k] - exact[k]) / ErrorBound::floor(exact[k]));
        }
        if (excess > 1.0) {
            excess = ErrorBound(*code_, rows_[rowOf(i)]).excess(bound, placeOf(i), exact, device);
        }
        report.largestError = std::max(report.largestError, excess);
        if (excess > 1.0) {
            report.add(
                {Defect::Inaccurate, requestOf(i, true), device, checks_.numbers(), exact, excess});
        }
    }

    EvalCase requestOf(std::size_t i, bool gpu) const {
        EvalCase request = caseOf(i);
        request.gpu = gpu;
        return request;
    }

    SweepOptions options_;
    EvalCase variant_;
    std::vector<EvalCase> rows_;
    std::vector<EvalPlace> places_;   ///< are the edge cases, then ordinary ones
    std::vector<EvalPlace> ordinary_; ///< is empty once they are in places_
    std::size_t edgeCaseCount_ = 0;
    std::size_t placesPerRow_ = 0;
    std::size_t wholeCount_ = 0; ///< counts cases where nothing is left out
    std::size_t stride_ = 1;
    ValueChecks checks_;
    std::optional<ReferenceCode> code_;
    std::optional<EvalProgram> program_;
    MeasuredStore measured_;
    std::optional<ClaimSweep> claims_; ///< exist where there is no double-precision code
    std::size_t done_ = 0;
};

StabilitySweep::StabilitySweep(std::vector<EvalCase> variants, SweepOptions options)
    : variants_(std::move(variants)), options_(std::move(options)) {
    if (!variants_.empty()) {
        run_ = run();
    }
}

StabilitySweep::~StabilitySweep() = default;

double StabilitySweep::progress() const {
    if (variants_.empty()) {
        return 1.0;
    }
    const double within = current_ != nullptr ? current_->progress() : 0.0;
    return (static_cast<double>(done_) + within) / static_cast<double>(variants_.size());
}

std::size_t StabilitySweep::plannedCases() const {
    std::size_t cases = 0;
    for (std::size_t i = 0; i < variants_.size(); ++i) {
        cases += Variant(variants_[i], options_, shareOf(i)).count();
    }
    return cases;
}

std::size_t StabilitySweep::leftOut() const {
    std::size_t cases = 0;
    for (std::size_t i = 0; i < variants_.size(); ++i) {
        cases += Variant(variants_[i], options_, shareOf(i)).leftOut();
    }
    return cases;
}

StabilitySweep::Share StabilitySweep::shareOf(std::size_t index) const {
    const std::size_t count = variants_.size();
    return {options_.cases / count, static_cast<double>(index) / static_cast<double>(count)};
}

/// Goes through the programs. A step makes one, or evaluates a slice of its cases.
Steps StabilitySweep::run() {
    for (; done_ < variants_.size(); ++done_) {
        if (done_ > 0) {
            co_yield Steps::Pause();
        }
        current_ = std::make_unique<Variant>(variants_[done_], options_, shareOf(done_));
        co_await current_->run(withoutReference_, report_);
        current_.reset();
    }
}

} // namespace patina
