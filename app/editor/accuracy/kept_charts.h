// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>

#include "accuracy/chart_store.h"
#include "accuracy/kept_results.h"

namespace patina {

class MessageLog;

/// Keeps charts of this session in memory and in files, and reads those of earlier sessions, so
/// that the chart of a document is found again after a restart.
class KeptCharts : public KeptResults {
  public:
    /// `page` is part of the key of each file. `messages` gets an error for each file that cannot
    /// be read or written.
    KeptCharts(std::string page, MessageLog& messages);

    const PageResult& keep(PageResult result) override;
    const PageResult* find(const MeasuredSubject& subject, const std::string& file) override;

  private:
    /// Holds a chart of a file whose subject is not the current one.
    struct Earlier {
        PageResult result; ///< has a subject of which only the object is known
        std::string hash;  ///< identifies the subject; see hashOf()
    };

    ChartKey keyOf(const std::string& file, int object) const { return {page_, file, object}; }
    const PageResult* findEarlier(const MeasuredSubject& subject, const std::string& file);
    void read(const ChartKey& key);
    void store(const PageResult& result);
    const std::string& device();

    std::string page_;
    MessageLog& messages_;
    ChartStore store_;
    std::set<ChartKey> stored_; ///< holds keys that were read from the store or written to it
    std::optional<std::string> device_; ///< is empty until it was asked for
    std::map<ChartKey, Earlier> earlier_;
};

} // namespace patina
