// SPDX-License-Identifier: GPL-3.0-or-later
// How a page finds the charts of documents again, also after Patina was started anew.
#include <utility>

#include "accuracy/accuracy_page.h"
#include "accuracy/chart_export.h"
#include "document/document.h"
#include "window/message_log.h"

namespace patina {

ChartKey AccuracyPage::keyOf(const std::string& file, int object) const {
    const bool isOfPicture = target_->scope() == Choice::Scope::Picture;
    return {isOfPicture ? "picture" : "material", file, object};
}

const std::string& AccuracyPage::device() {
    if (!device_) {
        device_ = driverLine().toStdString();
    }
    return *device_;
}

/// What was measured of this subject, else what was measured last of the document's object.
const KeptChart* AccuracyPage::keptFor(const MeasuredSubject& subject) {
    const KeptChart* kept = charts_.find(subject, file());
    const bool isFresh = kept != nullptr && kept->subject == subject;
    if (!isFresh) {
        const KeptChart* older = fromBefore(subject);
        return older != nullptr ? older : kept;
    }
    if (!stored_.contains(keyOf(file(), subject.object))) { // it has been saved under that name
        store(*kept);
    }
    return kept;
}

/// What an earlier session measured. What is of another subject is shown as out of date, but only
/// of a document that has a file: others have nothing to do with each other.
const KeptChart* AccuracyPage::fromBefore(const MeasuredSubject& subject) {
    const ChartKey key = keyOf(file(), subject.object);
    read(key);
    const auto found = before_.find(key);
    if (found == before_.end()) {
        return nullptr;
    }
    if (found->second.hash != hashOf(subject, device())) {
        return key.file.empty() ? nullptr : &found->second.chart;
    }
    KeptChart chart = std::move(found->second.chart);
    before_.erase(found);
    chart.subject = subject;
    return &charts_.keep(std::move(chart));
}

/// Once: what is measured later is written over it.
void AccuracyPage::read(const ChartKey& key) {
    if (!stored_.insert(key).second) {
        return;
    }
    auto chart = store_.read(key);
    if (!chart) {
        messages_.add(chart.error());
    } else if (*chart) {
        before_.insert_or_assign(key, std::move(**chart));
    }
}

void AccuracyPage::store(const KeptChart& chart) {
    const ChartKey key = keyOf(chart.file, chart.subject.object);
    if (chart.chart.points.empty()) {
        return;
    }
    stored_.insert(key);
    before_.erase(key);
    const auto written = store_.write(key, {chart, hashOf(chart.subject, device())});
    if (!written) {
        messages_.add(written.error());
    }
}

} // namespace patina
