// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/table_checks.h"

#include <set>

#include <fmt/format.h>

#include "catalog/descriptor_checker.h"
#include "catalog/fills.h"
#include "catalog/suggestion.h"
#include "catalog/table_source.h"

namespace patina {
namespace {

class TableChecker : DescriptorChecker {
  public:
    explicit TableChecker(const Descriptor& descriptor) : DescriptorChecker(descriptor) {}

    Errors run() {
        const BlockKind* kind = findKind(block_.kind);
        if (!block_.tables.empty() && (kind == nullptr || !kind->hasTables)) {
            add("/tables", fmt::format("a block of the kind {} has no tables", block_.kind),
                "no such key");
        }
        for (std::size_t i = 0; i < block_.tables.size(); ++i) {
            checkTable(block_.tables[i], fmt::format("/tables/{}", i));
        }
        for (std::size_t i = 0; i < block_.accuracy.size(); ++i) {
            checkLevels(block_.accuracy[i].values, fmt::format("/accuracy/{}/values", i));
        }
        checkUse();
        return std::move(errors_);
    }

  private:
    void checkTable(const BlockTable& table, const std::string& pointer) {
        if (table.id.empty() || block_.id.empty()) {
            return;
        }
        if (!names_.insert(tableFunction(block_, table)).second) {
            add(pointer + "/id",
                fmt::format("there are two functions {}", tableFunction(block_, table)),
                "each id once");
        }
        for (std::size_t i = 0; i < table.of.size(); ++i) {
            checkInput(table.of[i], fmt::format("{}/of/{}", pointer, i));
        }
    }

    void checkInput(const std::string& id, const std::string& pointer) {
        const Parameter* parameter = block_.parameter(id);
        if (parameter == nullptr) {
            std::vector<std::string> ids;
            for (const Parameter& each : block_.parameters) {
                ids.push_back(each.id);
            }
            add(pointer, fmt::format("'{}' is no parameter of this block", id), oneOf(id, ids));
        } else if (isShorthand(*parameter)) {
            add(pointer, fmt::format("'{}' is in no shader", id), "the parameters that it sets");
        }
    }

    void checkLevels(const std::vector<EnumValue>& levels, const std::string& pointer) {
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const std::string place = fmt::format("{}/{}/table", pointer, i);
            if (levels[i].table.empty()) {
                continue;
            }
            read_.insert(levels[i].table);
            if (levels[i].exact) {
                add(place, "the exact level reads no table", "no such key");
            } else if (block_.table(levels[i].table) == nullptr) {
                std::vector<std::string> ids;
                for (const BlockTable& table : block_.tables) {
                    ids.push_back(table.id);
                }
                add(place, fmt::format("there is no table \"{}\"", levels[i].table),
                    oneOf(levels[i].table, ids));
            }
        }
    }

    void checkUse() {
        for (std::size_t i = 0; i < block_.tables.size(); ++i) {
            if (!block_.tables[i].id.empty() && !read_.contains(block_.tables[i].id)) {
                add(fmt::format("/tables/{}", i), "no level reads this table",
                    fmt::format("\"table\": \"{}\" at a level", block_.tables[i].id));
            }
        }
    }

    std::set<std::string> names_;
    std::set<std::string> read_;
};

} // namespace

Errors tableMistakes(const Descriptor& descriptor) {
    return TableChecker(descriptor).run();
}

} // namespace patina
