// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/kept_results.h"

#include <algorithm>
#include <utility>

namespace patina {
namespace {

/// Is small since each result holds a scene, which may be large.
constexpr std::size_t maxResults = 8;

} // namespace

const PageResult& KeptResults::keep(PageResult result) {
    std::erase_if(results_,
                  [&result](const PageResult& each) { return each.subject == result.subject; });
    if (results_.size() >= maxResults) {
        results_.pop_front();
    }
    return results_.emplace_back(std::move(result));
}

const PageResult* KeptResults::find(const MeasuredSubject& subject, const std::string& file) {
    const auto same = std::find_if(results_.rbegin(), results_.rend(),
                                   [&](const PageResult& each) { return each.subject == subject; });
    if (same != results_.rend()) {
        same->file = file;
        return &*same;
    }
    const auto near = std::find_if(results_.rbegin(), results_.rend(), [&](const PageResult& each) {
        return each.file == file && each.subject.object == subject.object;
    });
    return near != results_.rend() ? &*near : nullptr;
}

} // namespace patina
