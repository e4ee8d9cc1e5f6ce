// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <deque>
#include <string>

#include <QString>

#include "accuracy/measured_subject.h"

namespace patina {

/// Holds what a page measured; a cancelled measurement leaves a part.
struct PageResult {
    MeasuredSubject subject;
    std::string file; ///< is the document's; empty while it has none
    std::any numbers; ///< has the page's own type; empty while there are no numbers
    QString method;   ///< says how they were measured
    bool complete = false;
    QString problem; ///< says why the measurement ended early; empty if it did not
};

/// Keeps what was measured in this session, so that a document that is opened again has its
/// numbers.
class KeptResults {
  public:
    virtual ~KeptResults() = default;

    /// Replaces the result of the same subject, and drops the oldest where there are too many. The
    /// reference is valid until the next call.
    virtual const PageResult& keep(PageResult result);

    /// Returns the newest result of the same subject, which is of this file from now on, else the
    /// newest one of the same file and object; null if there is none. It is valid until the next
    /// keep().
    virtual const PageResult* find(const MeasuredSubject& subject, const std::string& file);

  private:
    std::deque<PageResult> results_; ///< has the newest at the end
};

} // namespace patina
