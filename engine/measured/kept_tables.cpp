// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/kept_tables.h"

#include <algorithm>
#include <atomic>
#include <list>
#include <map>
#include <mutex>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/numbered_texts.h"
#include "measured/measured_reflectance.h"

namespace patina {
namespace {

constexpr std::size_t maxKeptTexels = (std::size_t(256) << 20) / sizeof(glm::vec3);

/// Returns the table of a matte surface with this albedo.
SharedTable matteTable(const glm::vec3& albedo) {
    auto table = std::make_shared<HalfDifferenceTable>();
    table->texels.front() = albedo / std::numbers::pi_v<float>;
    return table;
}

Result<SharedTable> tableOf(const std::filesystem::path& file) {
    const auto measured = readMeasured(file);
    if (!measured) {
        return tl::unexpected(measured.error());
    }
    HalfDifferenceTable table = (*measured)->table();
    const glm::ivec3& bins = table.bins;
    if (std::max({bins.x, bins.y, bins.z}) > HalfDifferenceTable::maxBins ||
        table.texels.size() > HalfDifferenceTable::maxTexels) {
        auto wrong = failure(
            fmt::format("has {} x {} x {} bins", bins.z, bins.y, bins.x),
            fmt::format("at most {} along an axis and {} in all, for a graphics card's memory",
                        HalfDifferenceTable::maxBins, HalfDifferenceTable::maxTexels));
        wrong.value().file = file.string();
        return wrong;
    }
    return std::make_shared<const HalfDifferenceTable>(std::move(table));
}

/// Keeps the tables that were used last, and knows all that somebody holds.
class KeptTables {
  public:
    SharedTable get(int number) {
        const std::lock_guard lock(guard_);
        if (SharedTable held = known_[number].lock()) {
            use(number, held);
            return held;
        }
        if (failed_.contains(number)) {
            return unreadable_;
        }
        const Result<SharedTable> read = tableOf(numberedText(number));
        if (!read) {
            failed_.insert(number);
            return unreadable_;
        }
        use(number, *read);
        return *read;
    }

    void put(int number, const Result<SharedTable>& table) {
        const std::lock_guard lock(guard_);
        std::erase_if(last_, [number](const Use& each) { return each.first == number; });
        failed_.erase(number);
        if (table) {
            use(number, *table);
        } else {
            known_.erase(number);
            failed_.insert(number);
        }
    }

  private:
    using Use = std::pair<int, SharedTable>;

    void use(int number, SharedTable table) {
        std::erase_if(last_, [number](const Use& each) { return each.first == number; });
        known_[number] = table;
        last_.emplace_front(number, std::move(table));
        std::size_t texels = 0;
        for (auto each = last_.begin(); each != last_.end();) {
            texels += each->second->texels.size();
            each = texels > maxKeptTexels && each != last_.begin() ? last_.erase(each)
                                                                   : std::next(each);
        }
    }

    std::mutex guard_;
    std::list<Use> last_; ///< begins with the one that was used last
    std::map<int, std::weak_ptr<const HalfDifferenceTable>> known_;
    std::set<int> failed_;
    SharedTable unreadable_ = matteTable({0.5f, 0.0f, 0.5f});
};

KeptTables& keptTables() {
    static KeptTables all;
    return all;
}

std::atomic<unsigned> version{0};

} // namespace

Result<SharedTable> readTable(const std::filesystem::path& file) {
    Result<SharedTable> table = tableOf(file);
    keptTables().put(numberOfText(std::filesystem::absolute(file).lexically_normal().string()),
                     table);
    ++version;
    return table;
}

SharedTable keptTable(int number) {
    static const SharedTable grey = matteTable(glm::vec3(0.5f));
    return number == 0 ? grey : keptTables().get(number);
}

unsigned keptTablesVersion() {
    return version;
}

} // namespace patina
