// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <deque>
#include <string>

#include <QString>

#include "accuracy/measured_subject.h"

namespace patina {

/// Holds what a page measured, perhaps not to the end.
struct PageResult {
    MeasuredSubject subject;
    std::string file; ///< of the document; empty: it has none yet
    std::any numbers; ///< of the page's own type; empty: none yet
    QString method;   ///< how they were measured
    bool complete = false;
    QString problem; ///< why it ended before its time; else empty
};

/// Keeps what was measured in this session, so that who comes back to a document finds it.
class KeptResults {
  public:
    virtual ~KeptResults() = default;

    /// Keeps a result; one of the same subject goes, and the oldest where there are many.
    virtual const PageResult& keep(PageResult result);

    /// The newest of the same subject, which belongs to this file from now on, else of the same
    /// file and object; null where there is none.
    virtual const PageResult* find(const MeasuredSubject& subject, const std::string& file);

  private:
    std::deque<PageResult> results_; ///< the newest last
};

} // namespace patina
