// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/kept_charts.h"

#include <utility>

#include "accuracy/chart_export.h"
#include "accuracy/cost_text.h"
#include "session/message_log.h"
#include "session/session.h"

namespace patina {

KeptCharts::KeptCharts(std::string page, MessageLog& messages)
    : page_(std::move(page)), messages_(messages), store_(stateFolder() / "measurements") {}

const PageResult& KeptCharts::keep(PageResult result) {
    const PageResult& kept = KeptResults::keep(std::move(result));
    store(kept);
    return kept;
}

/// Finds what was measured of this subject, else what was measured last of the document's object.
const PageResult* KeptCharts::find(const MeasuredSubject& subject, const std::string& file) {
    const PageResult* kept = KeptResults::find(subject, file);
    const bool isFresh = kept != nullptr && kept->subject == subject;
    if (!isFresh) {
        const PageResult* earlier = findEarlier(subject, file);
        return earlier != nullptr ? earlier : kept;
    }
    if (!stored_.contains(keyOf(file, subject.object))) { // the document has a new file name
        store(*kept);
    }
    return kept;
}

/// Finds what an earlier session measured. A result of another subject is shown as out of date, but
/// only for a document that has a file: other documents have nothing in common.
const PageResult* KeptCharts::findEarlier(const MeasuredSubject& subject, const std::string& file) {
    const ChartKey key = keyOf(file, subject.object);
    read(key);
    const auto found = earlier_.find(key);
    if (found == earlier_.end()) {
        return nullptr;
    }
    if (found->second.hash != hashOf(subject, device())) {
        return file.empty() ? nullptr : &found->second.result;
    }
    PageResult result = std::move(found->second.result);
    earlier_.erase(found);
    result.subject = subject;
    return &KeptResults::keep(std::move(result));
}

/// Reads a key only once, since what is measured later is written over it.
void KeptCharts::read(const ChartKey& key) {
    if (!stored_.insert(key).second) {
        return;
    }
    auto stored = store_.read(key);
    if (!stored) {
        messages_.add(stored.error());
        return;
    }
    if (!*stored) {
        return;
    }
    PageResult result;
    result.subject.object = key.object;
    result.file = key.file;
    result.method = methodText((*stored)->measured.chart);
    result.complete = (*stored)->complete;
    result.problem = QString::fromStdString((*stored)->problem);
    result.numbers = std::move((*stored)->measured);
    earlier_.insert_or_assign(key, Earlier{std::move(result), std::move((*stored)->hash)});
}

void KeptCharts::store(const PageResult& result) {
    const auto* measured = std::any_cast<MeasuredChart>(&result.numbers);
    if (measured == nullptr) {
        return;
    }
    const ChartKey key = keyOf(result.file, result.subject.object);
    stored_.insert(key);
    earlier_.erase(key);
    const auto written =
        store_.write(key, {*measured, result.complete, result.problem.toStdString(),
                           hashOf(result.subject, device())});
    if (!written) {
        messages_.add(written.error());
    }
}

const std::string& KeptCharts::device() {
    if (!device_) {
        device_ = driverLine().toStdString();
    }
    return *device_;
}

} // namespace patina
