// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string>
#include <utility>

#include "accuracy/measured_subject.h"

namespace patina {

/// What was measured in this session, so that who comes back to a document finds it. A `Result` has
/// a `subject` and the `file` of its document, empty where it has none yet.
template <class Result>
class KeptResults {
  public:
    /// Keeps a result; one of the same subject goes, and the oldest where there are many.
    const Result& keep(Result result) {
        std::erase_if(results_, [&result](const Result& each) {
            return each.subject == result.subject;
        });
        if (results_.size() >= most) {
            results_.pop_front();
        }
        return results_.emplace_back(std::move(result));
    }

    /// The newest of the same subject, which belongs to this file from now on, else of the same
    /// file and object; null where there is none.
    const Result* find(const MeasuredSubject& subject, const std::string& file) {
        const auto same =
            std::find_if(results_.rbegin(), results_.rend(),
                         [&](const Result& each) { return each.subject == subject; });
        if (same != results_.rend()) {
            same->file = file;
            return &*same;
        }
        const auto near =
            std::find_if(results_.rbegin(), results_.rend(), [&](const Result& each) {
                return each.file == file && each.subject.object == subject.object;
            });
        return near != results_.rend() ? &*near : nullptr;
    }

  private:
    /// Numbers are few, but the scene that they are of may be large.
    static constexpr std::size_t most = 8;

    std::deque<Result> results_; ///< the newest last
};

} // namespace patina
