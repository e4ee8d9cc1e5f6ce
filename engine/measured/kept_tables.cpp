// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/kept_tables.h"

#include <algorithm>
#include <atomic>
#include <list>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/table_number.h"
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

TableForm formOf(bool isIsotropic) {
    return isIsotropic ? TableForm::WithoutGrain : TableForm::WithGrain;
}

/// Reads a file into a table of this form, or of that which its surface has.
Result<SharedTable> tableOf(const std::filesystem::path& file, std::optional<TableForm> form) {
    const auto measured = readMeasured(file);
    if (!measured) {
        return tl::unexpected(measured.error());
    }
    HalfDifferenceTable table =
        (*measured)->table(form.value_or(formOf((*measured)->isIsotropic())));
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
    /// Returns null for a file that was not read yet.
    SharedTable find(int number) {
        const std::lock_guard lock(guard_);
        if (SharedTable held = known_[number].table.lock()) {
            use(number, held);
            return held;
        }
        return failed_.contains(number) ? unreadable_ : nullptr;
    }

    SharedTable get(int number) {
        if (SharedTable there = find(number)) {
            return there;
        }
        const std::lock_guard one(reading_); // who waits finds what the other one read
        if (SharedTable there = find(number)) {
            return there;
        }
        const Result<SharedTable> table = read(fileOfTable(number), formOfTable(number));
        return table ? *table : unreadable_;
    }

    /// Returns the table that is kept where its file has not changed, else what is read now, and
    /// whether it was read. Without a form it is that which the surface has.
    std::pair<Result<SharedTable>, bool> renew(const std::string& file,
                                               std::optional<TableForm> form) {
        const std::lock_guard one(reading_);
        for (const TableForm each : {TableForm::WithoutGrain, TableForm::WithGrain}) {
            const SharedTable there = unchanged(tableNumber(file, each));
            if (there && each == form.value_or(formOf(there->isIsotropic))) {
                return {there, false};
            }
        }
        return {read(file, form), true};
    }

  private:
    using Use = std::pair<int, SharedTable>;

    /// Tells one content of a file from another.
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;

        friend bool operator==(const Stamp&, const Stamp&) = default;
    };

    struct Known {
        std::weak_ptr<const HalfDifferenceTable> table;
        std::optional<Stamp> stamp; ///< is of the file before it was read
    };

    static std::optional<Stamp> stampOf(const std::filesystem::path& file) {
        std::error_code missing;
        Stamp stamp;
        stamp.time = std::filesystem::last_write_time(file, missing);
        stamp.size = missing ? 0 : std::filesystem::file_size(file, missing);
        return missing ? std::nullopt : std::optional(stamp);
    }

    SharedTable unchanged(int number) {
        const std::lock_guard lock(guard_);
        const Known& known = known_[number];
        SharedTable held = known.table.lock();
        return held && known.stamp && known.stamp == stampOf(fileOfTable(number)) ? held : nullptr;
    }

    Result<SharedTable> read(const std::string& file, std::optional<TableForm> form) {
        const std::optional<Stamp> stamp = stampOf(file);
        Result<SharedTable> table = tableOf(file, form);
        const std::lock_guard lock(guard_);
        for (const TableForm each : {TableForm::WithoutGrain, TableForm::WithGrain}) {
            const int number = tableNumber(file, each);
            if (!table) {
                forget(number);
                failed_.insert(number);
            } else if (known_[number].stamp != stamp) {
                forget(number); // of what the file was before
            }
        }
        if (table) {
            const int number = tableNumber(file, (*table)->form);
            known_[number].stamp = stamp;
            use(number, *table);
        }
        return table;
    }

    void forget(int number) {
        std::erase_if(last_, [number](const Use& each) { return each.first == number; });
        failed_.erase(number);
        known_.erase(number);
    }

    void use(int number, SharedTable table) {
        std::erase_if(last_, [number](const Use& each) { return each.first == number; });
        known_[number].table = table;
        last_.emplace_front(number, std::move(table));
        std::size_t texels = 0;
        for (auto each = last_.begin(); each != last_.end();) {
            texels += each->second->texels.size();
            each = texels > maxKeptTexels && each != last_.begin() ? last_.erase(each)
                                                                   : std::next(each);
        }
    }

    std::mutex reading_;  ///< lets one file be read at a time
    std::mutex guard_;    ///< is never held while a file is read
    std::list<Use> last_; ///< begins with the one that was used last
    std::map<int, Known> known_;
    std::set<int> failed_;
    SharedTable unreadable_ = matteTable({0.5f, 0.0f, 0.5f});
};

/// Returns the table of no file.
const SharedTable& noTable() {
    static const SharedTable grey = matteTable(glm::vec3(0.5f));
    return grey;
}

KeptTables& keptTables() {
    static KeptTables all;
    return all;
}

std::atomic<unsigned> version{0};

} // namespace

Result<SharedTable> readTable(const std::filesystem::path& file) {
    auto [table, isNew] = keptTables().renew(
        std::filesystem::absolute(file).lexically_normal().string(), std::nullopt);
    version += isNew ? 1 : 0;
    return std::move(table);
}

Result<SharedTable> readTable(int number) {
    auto [table, isNew] = keptTables().renew(fileOfTable(number), formOfTable(number));
    version += isNew ? 1 : 0;
    return std::move(table);
}

SharedTable keptTable(int number) {
    return number == 0 ? noTable() : keptTables().get(number);
}

SharedTable tableAtHand(int number) {
    return number == 0 ? noTable() : keptTables().find(number);
}

unsigned keptTablesVersion() {
    return version;
}

} // namespace patina
