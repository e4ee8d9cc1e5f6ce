// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/cheaper_ways.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "measure/approximation/approximated_block.h"
#include "measure/approximation/cheap_moves.h"
#include "measure/approximation/direction_tables.h"
#include "measure/approximation/error_climb.h"
#include "measure/approximation/fitted_terms.h"
#include "measure/approximation/geometry_moves.h"
#include "measure/approximation/shader_price.h"
#include "measure/approximation/tabled_terms.h"
#include "measure/error/parallel.h"
#include "shading/glsl/text_places.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t quickCases = 96;    ///< tell most of what is too far off
constexpr std::size_t minQuickCases = 16; ///< are those of a block that takes long
/// Is how long the search may judge one way. Where the exact one takes longer, cases are fewer.
constexpr double secondsOfWay = 0.25;
constexpr std::size_t edgeCaseCount = 3000;
constexpr std::size_t lastEdgeCases = 20000;
constexpr std::size_t statedEdgeCount = 1000;
constexpr std::size_t lastStatedEdges = 10000;
/// Is what floats of the exact way may always lose in edge cases whose errors count.
constexpr double edgeLoss = 1e-6;
constexpr std::size_t rowsOfSearch = 48;
constexpr std::uint32_t searchSeed = 1;
constexpr std::uint32_t heldOutSeed = 2;
constexpr std::uint32_t firstLastSeed = 4; ///< 3 is that of the cases on the device
constexpr double secondsOfTexts = 2.0;     ///< are how long texts are compiled at once
constexpr std::size_t maxTextsAtOnce = 64;
constexpr std::size_t beamWidth = 10;
constexpr std::size_t triedPerRound = 48;
constexpr std::size_t roundsOfKnown = 2; ///< put known moves together before the many others
constexpr double worthwhile = 0.995;     ///< is the cost, over another one, that is a gain
/// Is the cost, over that without it, that is expected of a move that gains only beside others.
constexpr double gainHopedFor = 0.9;
constexpr double secondsOfSollya = 60.0;
/// Are the largest and the smallest share of the time that trials may take; the rest is for the
/// judgement of what was found.
constexpr double maxShareOfTrials = 0.9;
constexpr double minShareOfTrials = 0.4;
/// Is the largest share of the time that is left in which ways of the front are judged.
constexpr double shareOfFront = 0.7;
constexpr double longerForOne = 1.2; ///< is the time, over the search's, for the first of them
constexpr std::size_t casesOfClimbRound = 3000; ///< are judged for each round of a climb
constexpr std::size_t maxClimbRounds = 30;
constexpr std::size_t casesOfClimb = 15000; ///< are about as many as one climb judges
constexpr double slowerThanExact = 1.5; ///< is the evaluation of ways, whose tables are computed

/// Is a set of moves with what is known of it.
struct TriedWay {
    std::vector<std::size_t> moves; ///< are sorted
    TextError error;
    std::optional<double> cost;
    double guess = 0.0;            ///< is the cost as the single moves let expect
    bool isJudged = false;         ///< its error is that on unseen cases
    bool isProven = false;         ///< and in the worst cases
    std::size_t heldOut = 0;       ///< counts the unseen cases
    std::vector<EvalCase> worst{}; ///< are the worst ones
};

bool isBetter(const TriedWay& a, const TriedWay& b) {
    return a.error.worst <= b.error.worst && *a.cost <= *b.cost &&
           (a.error.worst < b.error.worst || *a.cost < *b.cost);
}

class CheaperSearch {
  public:
    CheaperSearch(const EvalCase& subject, const CheaperSearchOptions& options,
                  const CheaperProgress& progress, std::shared_ptr<const MeasuredText> text)
        : subject_(subject), options_(options), progress_(progress), text_(std::move(text)),
          choices_(text_->syntax(), *subject.block.block),
          price_(subject, text_->source(), text_->syntax(), *options.family),
          limit_(greatestErrorStatedAs(options.maxError)) {
        found_.text = text_;
        found_.places = placesInWords(subject);
        found_.sliders = slidersInWords(subject);
        found_.isOfValues = options.ofValues;
    }

    Checked<CheaperWays> run() {
        prepareCases();
        if (!priceExact()) {
            return tl::unexpected(oneError(
                Error{{}, 0, 0, "the block's program does not compile", "one that draws"}));
        }
        statedEdges_ = judgedEdges(fitting(statedEdgeCount, quickCases)).judged;
        findKnownMoves();
        trySingles(0);
        tryTogether(roundsOfKnown);
        const std::size_t known = moves_.size();
        addMoves(droppedTerms(shader()));
        trySingles(known);
        addPolynomials();
        tryTogether(std::numeric_limits<std::size_t>::max());
        finish();
        if (options_.isAbandoned()) {
            return tl::unexpected(oneError(Error{{}, 0, 0, "it was stopped", {}}));
        }
        return std::move(found_);
    }

  private:
    double secondsGone() const {
        return std::chrono::duration<double>(Clock::now() - began_).count();
    }

    /// Tells whether the search is over, and what it has found is to be judged.
    bool isOver() const {
        return found_.isStopped || options_.isAbandoned() ||
               secondsGone() > std::clamp(options_.seconds - secondsOfJudging(),
                                          minShareOfTrials * options_.seconds,
                                          maxShareOfTrials * options_.seconds);
    }

    /// Tells whether all is over: what is not judged by now is left out. Before one way is, it may
    /// take some of the time of the check on the device.
    bool isLate() const {
        const double max = hasProven_ ? options_.seconds : longerForOne * options_.seconds;
        return options_.isAbandoned() || secondsGone() > max;
    }

    /// Returns how long the ways of a front take on the first cases that the search has not seen,
    /// and in edge cases.
    double secondsOfFirst(std::size_t ways) const {
        return secondsOfCase_ * slowerThanExact * static_cast<double>(ways) *
               static_cast<double>(casesOfFront + lastEdgeCases);
    }

    /// Returns how long so many ways of the front take until those that stay are judged, about.
    double secondsOfJudging(std::size_t ways) const {
        const std::size_t kept = std::min(ways, options_.ways);
        return secondsOfFirst(ways) +
               secondsOfCase_ * slowerThanExact * static_cast<double>(kept) *
                   static_cast<double>(options_.heldOut + casesOfClimb + lastStatedEdges);
    }

    /// Returns the same of the front as it is, and of the exact way.
    double secondsOfJudging() const {
        const auto cases =
            static_cast<double>(options_.heldOut + casesOfClimb + lastEdgeCases + lastStatedEdges);
        return secondsOfCase_ * cases +
               secondsOfJudging(std::min(front_.size(), 2 * options_.ways));
    }

    /// Reports, and keeps the wish to stop.
    void report() {
        const double share = std::min(secondsGone() / options_.seconds, 1.0);
        if (!found_.isStopped && !progress_(share, found_)) {
            found_.isStopped = true;
        }
    }

    /// Returns how many of so many cases the search judges a way by, `few` at least.
    std::size_t fitting(std::size_t count, std::size_t few) const {
        return std::max(static_cast<std::size_t>(share_ * static_cast<double>(count)), few);
    }

    void prepareCases() {
        const CaseWish wish{options_.cases, searchSeed, 0, rowsOfSearch, options_.ofValues};
        CaseTexels texels = texelsOfCases(commonCases(subject_, wish));
        const double before = secondsGone();
        judgeBy(texels, quickCases, quick_);
        const double each = (secondsGone() - before) / static_cast<double>(quick_.texels.size());
        share_ = std::min(1.0, secondsOfWay / (each * static_cast<double>(options_.cases)));
        judgeBy(texels, fitting(quickCases, minQuickCases), quick_);
        judgeBy(texels, fitting(options_.cases, quickCases), cases_);
        edgeCases_ = text_->judged(texelsOfCases(
            edgeCases(subject_, fitting(edgeCaseCount, quickCases), options_.ofValues)));
        secondsOfCase_ = each;
        observed_ = text_->observed(cases_.texels);
    }

    /// Is edge cases whose errors count.
    struct StatedEdges {
        std::vector<EvalCase> cases;
        JudgedCases judged;
    };

    /// Returns edge cases in which floats of the exact way lose no more than in common ones: how
    /// far off a way is there is its own doing.
    StatedEdges judgedEdges(std::size_t count) const {
        const EvaluationEnd isEnded = [this] { return isLate(); };
        const std::vector<EvalCase> all = statedEdgeCases(subject_, count, options_.ofValues);
        const JudgedCases judged = text_->judged(texelsOfCases(all), isEnded);
        const std::vector<double> errors = text_->errors({}, judged, isEnded);
        StatedEdges kept;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            if (errors[i] <= std::max(found_.exact.error, edgeLoss)) {
                const auto exact =
                    std::span(judged.exact).subspan(i * text_->results(), text_->results());
                kept.cases.push_back(all[i]);
                kept.judged.texels.push_back(judged.texels[i]);
                kept.judged.exact.insert(kept.judged.exact.end(), exact.begin(), exact.end());
            }
        }
        return kept;
    }

    /// Judges by the first of the cases.
    void judgeBy(const CaseTexels& texels, std::size_t count, JudgedCases& cases) const {
        cases = text_->judged(
            {texels.begin(),
             texels.begin() + static_cast<std::ptrdiff_t>(std::min(count, texels.size()))});
    }

    bool priceExact() {
        const double before = secondsGone();
        const auto prices = price_.of({{}}, [this] { return isLate(); });
        compiledIn(secondsGone() - before, 1);
        if (!price_.note().empty()) {
            found_.notes.push_back({{},
                                    0,
                                    0,
                                    "costs are instructions: " + price_.note(),
                                    "apt-get install mesa-vulkan-drivers"});
        }
        found_.unit = price_.unit();
        if (!prices.front()) {
            return false;
        }
        const TextError own = text_->error({}, cases_, std::numeric_limits<double>::infinity());
        found_.exact = {{}, {}, own.worst, own.mean, *prices.front(), false};
        if (!own.isSafe || !text_->isSafe({}, edgeCases_)) {
            found_.notes.push_back({{},
                                    0,
                                    0,
                                    "the block itself is negative or not finite in edge cases, so "
                                    "only ways that are not are kept",
                                    "`patina check` to say where"});
        }
        return true;
    }

    ObservedShader shader() const {
        return {text_->syntax(), observed_, text_->ownFunctions(), &choices_};
    }

    void addMoves(std::vector<CheapMove> moves) {
        for (CheapMove& move : moves) {
            if (!words_.insert(move.words).second) {
                move.words += placeOf(move);
                words_.insert(move.words);
            }
            moves_.push_back(std::move(move));
        }
        found_.moves = moves_.size();
    }

    /// Says where a move is, for one that is told by the words of another.
    std::string placeOf(const CheapMove& move) const {
        const Error at = errorAt(text_->source(), move.edits.front().first, {});
        return fmt::format(", in line {} of {}, column {}", at.line,
                           std::filesystem::path(at.file).filename().string(), at.column);
    }

    void findKnownMoves() {
        addMoves(knownSwaps(shader()));
        addMoves(geometryMoves(shader()));
        if (options_.ofValues) {
            addMoves(foldedValues(shader()));
        }
        std::vector<CheapMove> tables = tabledTerms(shader(), *subject_.block.block);
        const std::size_t count = tables.size();
        addMoves(std::move(tables));
        addMoves(directionTables(shader(), *subject_.block.block, count + 1));
    }

    void addPolynomials() {
        if (isOver()) {
            return;
        }
        const auto terms = oneVariableTerms(text_->source(), shader());
        if (terms.empty()) {
            return;
        }
        auto moves =
            polynomialMoves(shader(), terms, std::min(secondsOfSollya, 0.3 * options_.seconds),
                            [this] { return stopsNow(); });
        if (!moves) {
            found_.notes.push_back(moves.error());
            return;
        }
        const std::size_t first = moves_.size();
        addMoves(std::move(*moves));
        trySingles(first);
    }

    std::vector<ShaderEdit> editsFor(const std::vector<std::size_t>& moves) const {
        std::vector<const CheapMove*> chosen;
        for (const std::size_t move : moves) {
            chosen.push_back(&moves_[move]);
        }
        return editsOf(chosen);
    }

    /// Returns those of the ways that are ahead of the front, or useful by themselves, with their
    /// errors and costs, and puts them into the front. What takes long comes last, for few ways.
    std::vector<TriedWay> tried(std::vector<TriedWay> ways) {
        judge(ways, quick_);
        price(ways);
        judge(ways, cases_);
        leaveOutBroken(ways);
        std::ranges::for_each(ways, [this](const TriedWay& way) { enter(way); });
        tried_.insert(tried_.end(), ways.begin(), ways.end());
        report();
        return ways;
    }

    /// Judges ways on all cores, and leaves out those that are too far off, or behind the front.
    void judge(std::vector<TriedWay>& ways, const JudgedCases& cases) const {
        inParallel(ways.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                ways[i].error = isOver() ? TextError{.isSafe = false}
                                         : text_->error(editsFor(ways[i].moves), cases, limit_);
            }
        });
        std::erase_if(ways, [this](const TriedWay& way) {
            return !way.error.isWithin(limit_) || (way.cost ? isBehind(way) : isHopeless(way));
        });
    }

    /// Compiles ways, a few at once where that takes long, and leaves out those that gain nothing.
    void price(std::vector<TriedWay>& ways) {
        for (std::size_t first = 0; first < ways.size() && !isOver();) {
            std::vector<std::vector<ShaderEdit>> edits;
            for (std::size_t i = first; i < std::min(first + textsAtOnce_, ways.size()); ++i) {
                edits.push_back(editsFor(ways[i].moves));
            }
            const double before = secondsGone();
            for (const auto& cost : price_.of(edits, [this] { return stopsNow(); })) {
                found_.tried += cost ? 1 : 0;
                ways[first++].cost = cost;
            }
            compiledIn(secondsGone() - before, edits.size());
        }
        std::erase_if(ways, [this](const TriedWay& way) { return !way.cost || isBehind(way); });
    }

    /// Keeps how many texts are compiled at once, between two looks at the clock.
    void compiledIn(double seconds, std::size_t texts) {
        const double fitting = secondsOfTexts * static_cast<double>(texts) / seconds;
        textsAtOnce_ =
            static_cast<std::size_t>(std::clamp(fitting, 2.0, static_cast<double>(maxTextsAtOnce)));
    }

    /// Leaves out those of a few ways that break in an edge case, or are too far off there.
    void leaveOutBroken(std::vector<TriedWay>& ways) const {
        inParallel(ways.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::vector<ShaderEdit> edits = editsFor(ways[i].moves);
                TextError& error = ways[i].error;
                error.isSafe = !isOver() && text_->isSafe(edits, edgeCases_);
                error.worst =
                    std::max(error.worst, text_->error(edits, statedEdges_, limit_).worst);
            }
        });
        std::erase_if(ways, [this](const TriedWay& way) {
            return !way.error.isWithin(limit_) || isBehind(way);
        });
    }

    bool stopsNow() {
        report();
        return isOver();
    }

    /// Tells whether a way is a gain that nothing in the front is as good as.
    bool isAhead(const TriedWay& way) const {
        return *way.cost < worthwhile * found_.exact.cost &&
               std::ranges::none_of(front_, [&way](const TriedWay& other) {
                   return other.error.worst <= way.error.worst && *other.cost <= *way.cost;
               });
    }

    /// Tells whether a way is of no use: not ahead, and no single move that gains something or may
    /// beside others.
    bool isBehind(const TriedWay& way) const {
        const bool isUseful =
            way.moves.size() == 1 &&
            (*way.cost < worthwhile * found_.exact.cost || moves_[way.moves.front()].gainsBeside);
        return !isUseful && !isAhead(way);
    }

    /// Puts a way into the front where none is better.
    void enter(const TriedWay& way) {
        if (!isAhead(way)) {
            return;
        }
        std::erase_if(front_, [&way](const TriedWay& other) { return isBetter(way, other); });
        front_.push_back(way);
        std::ranges::sort(front_, {}, [](const TriedWay& each) { return each.error.worst; });
        publish(front_);
    }

    void publish(const std::vector<TriedWay>& front) {
        found_.ways.clear();
        for (const TriedWay& way : front) {
            CheaperWay shown{
                editsFor(way.moves), {}, way.error.worst, way.error.mean, *way.cost, false, {}};
            for (const std::size_t move : way.moves) {
                shown.table = moves_[move].table ? moves_[move].table : shown.table;
                shown.isForValues = shown.isForValues || moves_[move].isForValues;
                if (std::ranges::find(shown.words, moves_[move].words) == shown.words.end()) {
                    shown.words.push_back(moves_[move].words);
                }
            }
            found_.ways.push_back(std::move(shown));
        }
    }

    void trySingles(std::size_t firstMove) {
        constexpr std::size_t judgedAtOnce = 64;
        std::size_t first = firstMove;
        for (; first < moves_.size() && !isOver(); first += judgedAtOnce) {
            std::vector<TriedWay> ways;
            for (std::size_t i = first; i < std::min(first + judgedAtOnce, moves_.size()); ++i) {
                ways.push_back({{i}, {}, {}});
            }
            const std::vector<TriedWay> useful = tried(std::move(ways));
            useful_.insert(useful_.end(), useful.begin(), useful.end());
        }
        untried_ += moves_.size() - std::min(first, moves_.size());
    }

    /// Returns the way with one more move; nothing where the moves change the same text, or it was
    /// tried.
    std::optional<TriedWay> extended(const TriedWay& way, const TriedWay& single) {
        const std::size_t move = single.moves.front();
        TriedWay more{way.moves, {}, {}, *way.cost - (found_.exact.cost - *single.cost)};
        for (const std::size_t other : way.moves) {
            if (other == move || !areCompatible(moves_[other], moves_[move])) {
                return std::nullopt;
            }
        }
        if (moves_[move].gainsBeside) {
            more.guess = std::min(more.guess, gainHopedFor * *way.cost);
        }
        more.moves.push_back(move);
        std::ranges::sort(more.moves);
        more.error.worst = way.error.worst + single.error.worst;
        return known_.insert(more.moves).second ? std::optional(more) : std::nullopt;
    }

    /// Tells whether the front has what is as cheap as a way is expected to be, and more exact.
    bool isHopeless(const TriedWay& way) const {
        return std::ranges::any_of(front_, [&way](const TriedWay& other) {
            return other.error.worst <= way.error.worst && *other.cost <= way.guess;
        });
    }

    void tryTogether(std::size_t rounds) {
        std::ranges::sort(useful_, {}, [](const TriedWay& way) { return *way.cost; });
        for (std::size_t round = 0; round < rounds && !isOver(); ++round) {
            std::vector<TriedWay> next;
            for (const TriedWay& way : beam()) {
                for (const TriedWay& single : useful_) {
                    if (auto more = extended(way, single)) {
                        next.push_back(std::move(*more));
                    }
                }
            }
            if (next.empty()) {
                return;
            }
            std::ranges::sort(next, {}, &TriedWay::guess);
            for (std::size_t first = 0; first < next.size() && !isOver(); first += triedPerRound) {
                std::vector<TriedWay> some(next.begin() + static_cast<std::ptrdiff_t>(first),
                                           next.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                              first + triedPerRound, next.size())));
                tried(std::move(some));
            }
        }
    }

    /// Returns the ways that are extended: the front, thinned out evenly.
    std::vector<TriedWay> beam() const {
        std::vector<TriedWay> some;
        const std::size_t count = std::min(beamWidth, front_.size());
        for (std::size_t i = 0; i < count; ++i) {
            some.push_back(front_[i * front_.size() / count]);
        }
        return some;
    }

    /// Keeps few ways of the front, with their errors on cases that the search has not seen.
    void finish() {
        if (options_.isAbandoned()) {
            return;
        }
        const EvaluationEnd isEnded = [this] { return isLate(); };
        const std::size_t first = std::min(options_.heldOut, casesOfFront);
        const CaseWish wish{first,          heldOutSeed,       rowsOfSearch,
                            rowsFor(first), options_.ofValues, true};
        unseen_ = commonCases(subject_, wish);
        const double before = secondsGone();
        const JudgedCases unseen = text_->judged(texelsOfCases(unseen_), isEnded);
        secondsOfCase_ = (secondsGone() - before) / static_cast<double>(first);
        const JudgedCases edge = text_->judged(
            texelsOfCases(edgeCases(subject_, lastEdgeCases, options_.ofValues)), isEnded);
        judgeExact(unseen);
        lastEdges_ = judgedEdges(std::min(options_.heldOut, lastStatedEdges));
        do {
            do {
                renewFront();
                leaveOutForTime();
            } while (judgeFront(unseen, edge));
            thin();
        } while (judgeStaying());
        leaveOutUnjudged();
        publish(front_);
        noteTime();
        for (const TriedWay& way : front_) {
            found_.worst.insert(found_.worst.end(), way.worst.begin(), way.worst.end());
        }
        if (statedError(found_.exact) > options_.maxError) {
            found_.notes.push_back(
                {{},
                 0,
                 0,
                 fmt::format("floats of 32 bits alone are up to {:.2g} off in the exact way, where "
                             "its formula loses digits",
                             found_.exact.error),
                 fmt::format("a greatest error of more than {:.2g}", statedError(found_.exact))});
        }
    }

    void renewFront() {
        front_.clear();
        std::ranges::for_each(tried_, [this](const TriedWay& way) { enter(way); });
    }

    void judgeExact(const JudgedCases& unseen) {
        const TextError own = text_->error({}, unseen, std::numeric_limits<double>::infinity(),
                                           [this] { return isLate(); });
        const WorstCases worst = climbed({});
        found_.exact.error = std::max({found_.exact.error, own.worst, worst.error});
        found_.exact.meanError = own.mean;
        found_.worst = worst.cases;
    }

    /// Leaves out ways that are not judged, as many as there is no time for, but not all: what is
    /// judged then makes room for others.
    void leaveOutForTime() {
        const double left = shareOfFront * (options_.seconds - secondsGone());
        const auto open = [](const TriedWay& way) { return !way.isJudged; };
        for (auto count = static_cast<std::size_t>(std::ranges::count_if(front_, open));
             count > 1 && secondsOfJudging(count) > left && dropWeakest(open); --count) {
        }
    }

    /// Leaves out what the time was over for.
    void leaveOutUnjudged() {
        const auto unproven = std::ranges::count(front_, false, &TriedWay::isProven);
        std::erase_if(tried_, [](const TriedWay& way) { return !way.isProven; });
        renewFront();
        thin();
        if (unproven > 0) {
            found_.notes.push_back(
                {{},
                 0,
                 0,
                 fmt::format("the time was over before {} of the ways could be judged: left out",
                             unproven),
                 "a longer search, or fewer cases"});
        }
        found_.heldOut = options_.heldOut;
        for (const TriedWay& way : front_) {
            found_.heldOut = std::min(found_.heldOut, way.heldOut);
        }
    }

    /// Says what there was no time for.
    void noteTime() {
        if (untried_ > 0 && !found_.isStopped) {
            found_.notes.push_back({{},
                                    0,
                                    0,
                                    fmt::format("the time was over before {} of {} changes were "
                                                "tried",
                                                untried_, moves_.size()),
                                    "a longer search"});
        }
        if (found_.heldOut < options_.heldOut) {
            found_.notes.push_back({{},
                                    0,
                                    0,
                                    fmt::format("the time was over after {} of {} unseen cases",
                                                found_.heldOut, options_.heldOut),
                                    "a longer search"});
        }
    }

    /// Looks for where a way is farthest off.
    WorstCases climbed(std::span<const ShaderEdit> edits) {
        ErrorClimb how;
        how.rounds = std::min(options_.heldOut / casesOfClimbRound + 1, maxClimbRounds);
        how.hasOwnValues = options_.ofValues;
        const EvaluationEnd isEnded = [this] { return isLate(); };
        const CaseErrors errorsOf = [&](const std::vector<EvalCase>& cases) {
            const JudgedCases judged = text_->judged(texelsOfCases(cases), isEnded);
            auto errors = text_->errors(edits, judged, isEnded);
            errors.resize(cases.size()); // what was not evaluated is no error
            return isLate() ? std::vector<double>(cases.size()) : errors;
        };
        return worstCases(errorsOf, unseen_, how, [this] {
            report();
            return isLate();
        });
    }

    /// Judges those of the front on cases that the search has not seen, and forgets what is too far
    /// off or breaks there; what it was better than may then come back. Returns whether there was
    /// one to judge.
    bool judgeFront(const JudgedCases& unseen, const JudgedCases& edge) {
        std::vector<TriedWay*> open;
        for (TriedWay& way : tried_) {
            const bool isShown =
                std::ranges::find(front_, way.moves, &TriedWay::moves) != front_.end();
            if (isShown && !way.isJudged) {
                open.push_back(&way);
            }
        }
        inParallel(open.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !isLate(); ++i) {
                const std::vector<ShaderEdit> edits = editsFor(open[i]->moves);
                const EvaluationEnd isEnded = [this] { return isLate(); };
                const TextError last = text_->error(edits, unseen, limit_, isEnded);
                TextError& error = open[i]->error;
                error.isSafe = last.isSafe && text_->isSafe(edits, edge, isEnded);
                error.worst = std::max(error.worst, last.worst);
                error.mean = last.mean;
                open[i]->heldOut = unseen.texels.size();
                open[i]->isJudged = !isLate();
            }
        });
        std::erase_if(tried_, [this](const TriedWay& way) { return !way.error.isWithin(limit_); });
        return !open.empty() && !isLate();
    }

    static std::size_t rowsFor(std::size_t cases) { return std::max<std::size_t>(cases / 32, 1); }

    /// Returns as many parts as there are cores of cases that neither the search nor the judgement
    /// of the front has seen.
    std::vector<JudgedCases> lastCases(std::size_t first, std::size_t count) const {
        const std::size_t seen = std::min(options_.heldOut, casesOfFront);
        const CaseWish wish{count,
                            firstLastSeed + static_cast<std::uint32_t>(first / casesOfFront),
                            rowsOfSearch + rowsFor(seen) + rowsFor(first),
                            rowsFor(count),
                            options_.ofValues,
                            true};
        const std::vector<EvalCase> cases = commonCases(subject_, wish);
        const std::size_t parts = parallelParts();
        std::vector<JudgedCases> judged;
        for (std::size_t i = 0; i < parts; ++i) {
            judged.push_back(text_->judged(
                texelsOfCases(
                    {cases.begin() + static_cast<std::ptrdiff_t>(i * cases.size() / parts),
                     cases.begin() + static_cast<std::ptrdiff_t>((i + 1) * cases.size() / parts)}),
                [this] { return isLate(); }));
        }
        return judged;
    }

    /// Judges what stays in its worst cases, then on the rest of the cases, on all cores, and
    /// forgets what is too far off or breaks there, so that others come back. Returns whether there
    /// was one to judge, and there is time for another.
    bool judgeStaying() {
        std::vector<TriedWay*> open;
        for (TriedWay& way : tried_) {
            const bool isShown =
                std::ranges::find(front_, way.moves, &TriedWay::moves) != front_.end();
            if (isShown && way.isJudged && !way.isProven) {
                open.push_back(&way);
            }
        }
        for (TriedWay* way : open) {
            WorstCases worst = climbed(editsFor(way->moves));
            way->error.worst = std::max(way->error.worst, worst.error);
            way->worst = std::move(worst.cases);
            judgeAtEdges(*way);
            way->isProven = !isLate();
            hasProven_ = hasProven_ || (way->isProven && way->error.isWithin(limit_));
        }
        const std::size_t seen = std::min(options_.heldOut, casesOfFront);
        for (std::size_t first = 0; first < options_.heldOut - seen && !open.empty() && !isLate();
             first += casesOfFront) {
            report();
            const std::size_t count = std::min(options_.heldOut - seen - first, casesOfFront);
            judgeOn(open, lastCases(first, count));
            if (!isLate()) {
                found_.heldOut = seen + first + count;
                std::ranges::for_each(open, [&](TriedWay* way) { way->heldOut = found_.heldOut; });
            }
        }
        std::erase_if(tried_, [this](const TriedWay& way) { return !way.error.isWithin(limit_); });
        renewFront();
        thin();
        return !open.empty() && !isLate();
    }

    /// Enlarges the error of a way by what it is in edge cases, of which it keeps the worst.
    void judgeAtEdges(TriedWay& way) const {
        const std::vector<double> errors =
            text_->errors(editsFor(way.moves), lastEdges_.judged, [this] { return isLate(); });
        const auto worst = std::ranges::max_element(errors);
        if (worst != errors.end() && !isLate()) {
            way.error.worst = std::max(way.error.worst, *worst);
            way.worst.push_back(lastEdges_.cases[static_cast<std::size_t>(worst - errors.begin())]);
        }
    }

    /// Enlarges the errors of ways by what they are in parts of cases.
    void judgeOn(const std::vector<TriedWay*>& ways, const std::vector<JudgedCases>& parts) const {
        std::vector<TextError> errors(parts.size() * ways.size());
        inParallel(errors.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end && !isLate(); ++i) {
                const TriedWay& way = *ways[i % ways.size()];
                if (way.error.isWithin(limit_)) {
                    errors[i] = text_->error(editsFor(way.moves), parts[i / ways.size()], limit_,
                                             [this] { return isLate(); });
                }
            }
        });
        for (std::size_t i = 0; i < errors.size(); ++i) {
            TextError& error = ways[i % ways.size()]->error;
            error.worst = std::max(error.worst, errors[i].worst);
            error.isSafe = error.isSafe && errors[i].isSafe;
        }
    }

    /// Leaves out, one after the other, the way that its neighbours replace best.
    void thin() {
        while (front_.size() > options_.ways && dropWeakest([](const TriedWay&) { return true; })) {
        }
    }

    /// Leaves out the way that its neighbours replace best, of those that may go. Returns whether
    /// there was one.
    bool dropWeakest(const std::function<bool(const TriedWay&)>& mayGo) {
        std::size_t weakest = front_.size();
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < front_.size(); ++i) {
            const double before = i == 0 ? found_.exact.cost : *front_[i - 1].cost;
            const double gain = std::log(before / *front_[i].cost) *
                                std::log(std::max(front_[i + 1].error.worst, 1e-9) /
                                         std::max(front_[i].error.worst, 1e-9));
            if (gain < smallest && mayGo(front_[i])) {
                smallest = gain;
                weakest = i;
            }
        }
        if (weakest == front_.size()) {
            return false;
        }
        front_.erase(front_.begin() + static_cast<std::ptrdiff_t>(weakest));
        return true;
    }

    const EvalCase& subject_;
    const CheaperSearchOptions& options_;
    const CheaperProgress& progress_;
    std::shared_ptr<const MeasuredText> text_;
    CompiledChoices choices_;
    ShaderPrice price_;
    double limit_; ///< is the largest error that may be stated
    Clock::time_point began_ = Clock::now();
    double secondsOfCase_ = 0.0;  ///< is how long the exact text takes on all cores, about
    std::size_t textsAtOnce_ = 2; ///< are compiled together
    JudgedCases cases_;
    JudgedCases quick_;
    JudgedCases edgeCases_;
    JudgedCases statedEdges_;
    StatedEdges lastEdges_;        ///< judge those that stay
    double share_ = 1.0;           ///< is that of cases which there is time for
    std::vector<EvalCase> unseen_; ///< are those that judge all of the front
    std::vector<ObservedValues> observed_;
    std::vector<CheapMove> moves_;
    std::set<std::string> words_;  ///< are those of the moves, no two of which are the same
    std::vector<TriedWay> useful_; ///< are single moves that gain something
    bool hasProven_ = false;       ///< says that there is a way that is judged
    std::size_t untried_ = 0;      ///< counts single moves for which there was no time
    std::vector<TriedWay> tried_;  ///< are all that have a cost
    std::vector<TriedWay> front_;  ///< is sorted by error
    std::set<std::vector<std::size_t>> known_;
    CheaperWays found_;
};

} // namespace

Checked<CheaperWays> cheaperWays(const EvalCase& subject, const std::filesystem::path& shaders,
                                 const CheaperSearchOptions& options,
                                 const CheaperProgress& progress) {
    if (Errors why = whyNotSearched(*subject.block.block); !why.empty()) {
        return tl::unexpected(std::move(why));
    }
    auto text = MeasuredText::of(subject, shaders);
    if (!text) {
        return tl::unexpected(text.error());
    }
    return CheaperSearch(subject, options, progress,
                         std::make_shared<const MeasuredText>(std::move(*text)))
        .run();
}

} // namespace patina
