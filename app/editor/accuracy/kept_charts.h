// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>

#include "accuracy/chart_store.h"
#include "accuracy/kept_results.h"

namespace patina {

class MessageLog;

/// Charts that were measured in this session, or in an earlier one, from which files are there: who
/// starts Patina again finds that of the document.
class KeptCharts : public KeptResults {
  public:
    /// `page` tells the files of one page from those of another; `messages` hears of those that
    /// cannot be read or written.
    KeptCharts(std::string page, MessageLog& messages);

    const PageResult& keep(PageResult result) override;
    const PageResult* find(const MeasuredSubject& subject, const std::string& file) override;

  private:
    /// Holds what was read, while it is of another subject.
    struct Earlier {
        PageResult result; ///< of a subject of which no more than the object is known
        std::string hash;  ///< of the subject; see hashOf()
    };

    ChartKey keyOf(const std::string& file, int object) const { return {page_, file, object}; }
    const PageResult* findEarlier(const MeasuredSubject& subject, const std::string& file);
    void read(const ChartKey& key);
    void store(const PageResult& result);
    const std::string& device();

    std::string page_;
    MessageLog& messages_;
    ChartStore store_;
    std::set<ChartKey> stored_;         ///< what was read of the store or written to it
    std::optional<std::string> device_; ///< its name, once it was asked for
    std::map<ChartKey, Earlier> earlier_;
};

} // namespace patina
