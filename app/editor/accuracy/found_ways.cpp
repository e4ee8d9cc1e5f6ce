// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/found_ways.h"

#include <algorithm>

#include <QByteArrayView>
#include <QCoreApplication>
#include <QHashFunctions>

#include "catalog/json_text.h"
#include "core/ordinary_file.h"
#include "core/text.h"
#include "measure/approximation/level_check.h"
#include "measure/approximation/written_block.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

constexpr std::uintmax_t maxShaderBytes = 8u << 20;
constexpr double shareOfSearch = 0.9; ///< of the progress; the rest is the check on the device
constexpr double shareOfTimes = 0.1;  ///< of the search's time, for pairs of frames

class WaysText {
    Q_DECLARE_TR_FUNCTIONS(WaysText)
};

QString searchText(const CheaperWays& soFar) {
    return WaysText::tr("Searching: %1 changes, %2 tried, %3 cheaper ways so far")
        .arg(wholeText(soFar.moves), wholeText(soFar.tried), wholeText(soFar.ways.size()));
}

std::filesystem::path folderOfBlock(const FoundWays& found) {
    return found.wish.folder / found.wish.subject.block.block->kind;
}

/// Adds what would be saved; a block that cannot be read leaves it empty.
void writeBlockOf(FoundWays& found, const Catalog& catalog) {
    const BlockNaming naming =
        freeNaming(*found.wish.subject.block.block, catalog, folderOfBlock(found));
    found.block =
        approximatedBlock(found.wish.subject, found.ways, naming).value_or(ApproximatedBlock());
}

/// Tells whether two searches show the same ways.
bool areSame(const std::vector<CheaperWay>& a, const std::vector<CheaperWay>& b) {
    return std::ranges::equal(a, b, [](const CheaperWay& x, const CheaperWay& y) {
        return x.cost == y.cost && x.error == y.error;
    });
}

class WaySearch {
  public:
    WaySearch(const WaysWish& wish, const std::atomic<bool>& isEnough, Worker::Control& control,
              const std::function<void(const FoundWays&)>& take)
        : wish_(wish), isEnough_(isEnough), control_(control), take_(take),
          shader_(textHash(wish.subject.block.block->shaderFile)) {
        wish_.options.isAbandoned = [this] { return control_.isCancelled(); };
        wish_.options.isDeviceLate = isOverAfter(wish_.options.seconds);
        wish_.options.seconds = secondsOfSearch(wish_.options.seconds);
    }

    MeasureEnd run() {
        const auto progress = [this](double share, const CheaperWays& soFar) {
            control_.report(shareOfSearch * share, searchText(soFar));
            if (!areSame(shown_, soFar.ways)) {
                shown_ = soFar.ways;
                show(soFar, false, {});
            }
            return !isEnough_;
        };
        auto ways = cheaperWays(wish_.subject, shaders(), wish_.options, progress);
        if (control_.isCancelled()) {
            return endOf(false, {});
        }
        if (!ways) {
            return tl::unexpected(ways.error());
        }
        const bool isChecked = check(*ways);
        if (control_.isCancelled()) {
            return endOf(false, {});
        }
        show(*ways, isChecked, {});
        if (isChecked && !ways->ways.empty() && !ways->isStopped) {
            draw(*ways);
        }
        return endOf(!ways->isStopped, {});
    }

  private:
    const std::filesystem::path& shaders() const { return wish_.catalog->roots.front().folder; }

    /// Returns whether the ways could be checked: what does not compile there is not.
    bool check(CheaperWays& ways) {
        if (ways.ways.empty()) {
            return true;
        }
        control_.report(shareOfSearch, WaysText::tr("Checking on the graphics device"), true);
        const auto checked = checkedOnDevice(wish_.subject, ways, shaders(), wish_.options,
                                             [this] { return control_.isCancelled(); });
        if (!checked) {
            ways.notes.insert(ways.notes.end(), checked.error().begin(), checked.error().end());
        }
        return checked.has_value();
    }

    /// Draws what is on screen with each of the ways, as far as it can be drawn.
    void draw(CheaperWays& ways) {
        control_.report(shareOfSearch, WaysText::tr("Drawing what is on screen"), true);
        auto drawn = waysInFrame(
            wish_.shown, wish_.subject, ways, shaders(), shareOfTimes * wish_.options.seconds,
            [this] { return control_.isCancelled() || wish_.options.isDeviceLate(); });
        if (!drawn && wish_.options.isDeviceLate() && !control_.isCancelled()) {
            ways.notes.push_back({{}, 0, 0, "not drawn: the time was over", {}});
        } else if (!drawn && !control_.isCancelled()) {
            ways.notes.insert(ways.notes.end(), drawn.error().begin(), drawn.error().end());
        }
        show(ways, true, drawn ? std::optional(std::move(*drawn)) : std::nullopt);
    }

    void show(const CheaperWays& ways, bool isChecked, std::optional<WaysInFrame> inFrame) {
        FoundWays found{wish_, ways, {}, isChecked, std::move(inFrame), shader_};
        found.wish.options.isAbandoned = [] { return false; };
        found.wish.options.isDeviceLate = [] { return false; };
        writeBlockOf(found, *wish_.catalog);
        control_.show([take = take_, found = std::move(found)] { take(found); });
    }

    WaysWish wish_;
    const std::atomic<bool>& isEnough_;
    Worker::Control& control_;
    const std::function<void(const FoundWays&)>& take_;
    std::uint64_t shader_;
    std::vector<CheaperWay> shown_;
};

} // namespace

std::uint64_t textHash(const std::filesystem::path& file) {
    const Result<std::string> text = readFile(file, maxShaderBytes);
    return text ? qHash(QByteArrayView(*text)) : 0;
}

MeasureEnd findWays(const WaysWish& wish, const std::atomic<bool>& isEnough,
                    Worker::Control& control, const std::function<void(const FoundWays&)>& take) {
    return WaySearch(wish, isEnough, control, take).run();
}

Result<std::string> savedWays(const FoundWays& found, const Catalog& catalog) {
    const Block& block = *found.wish.subject.block.block;
    if (!found.isChecked) {
        return failure("the ways are not checked yet", "a search that has ended");
    }
    if (found.wish.folder.empty()) {
        return failure("there is no folder for blocks of yours", "a start with your blocks");
    }
    if (textHash(block.shaderFile) != found.shader) {
        return tl::unexpected(Error{block.shaderFile.string(), 0, 0,
                                    "it has changed since cheaper ways were searched for",
                                    "another search"});
    }
    const BlockNaming naming = freeNaming(block, catalog, folderOfBlock(found));
    auto made = approximatedBlock(found.wish.subject, found.ways, naming);
    if (!made) {
        return tl::unexpected(made.error());
    }
    if (auto written = writeApproximatedBlock(*made, folderOfBlock(found)); !written) {
        return tl::unexpected(written.error());
    }
    return made->id;
}

QString methodText(const FoundWays& found) {
    return WaysText::tr("%1 of %2, predicted. Errors where white is 1, light and viewer 3° or more "
                        "above the surface; the largest of %3 cases that the search did not see.")
               .arg(asText(capitalised(found.ways.unit)),
                    asText(found.wish.subject.block.block->label), wholeText(found.ways.heldOut)) +
           (found.inFrame
                ? WaysText::tr(" On screen: against %1; %2.")
                      .arg(asText(found.inFrame->groundTruth), asText(found.inFrame->timer))
                : QString());
}

QString entryText(const FoundWays& found) {
    const auto choices = found.block.descriptor.find("accuracy");
    if (choices == found.block.descriptor.end() || choices->empty()) {
        return {};
    }
    nlohmann::json tables = nlohmann::json::array();
    for (const auto& table : found.block.descriptor.value("tables", nlohmann::json::array())) {
        const bool isRead = std::ranges::any_of(found.ways.ways, [&table](const CheaperWay& way) {
            return way.table && way.table->id == table.value("id", std::string());
        });
        if (isRead) {
            tables.push_back(table);
        }
    }
    return tables.empty()
               ? asText(writeJson(choices->back()))
               : asText(writeJson(
                     {{"accuracy", nlohmann::json::array({choices->back()})}, {"tables", tables}}));
}

} // namespace patina
