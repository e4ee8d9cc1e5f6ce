// SPDX-License-Identifier: GPL-3.0-or-later
#include "background/long_tasks.h"

#include <utility>

#include <QCoreApplication>
#include <QPointer>

namespace patina {
namespace {

constexpr int quickMs = 300; ///< milliseconds; work that ends sooner is not shown
constexpr int lookMs = 100;

} // namespace

LongTasks& LongTasks::all() {
    static QPointer<LongTasks> tasks;
    if (!tasks) {
        tasks = new LongTasks(QCoreApplication::instance());
    }
    return *tasks;
}

LongTasks::LongTasks(QObject* parent) : QObject(parent) {
    timer_.setInterval(lookMs);
    connect(&timer_, &QTimer::timeout, this, &LongTasks::look);
}

quint64 LongTasks::begin(LongTask task) {
    Running& running = running_[++last_];
    running.task = std::move(task);
    running.since.start();
    timer_.start();
    return last_;
}

void LongTasks::end(quint64 number) {
    const auto found = running_.find(number);
    if (found == running_.end()) {
        return;
    }
    const bool wasShown = found->second.isShown;
    running_.erase(found);
    if (running_.empty()) {
        timer_.stop();
    }
    if (wasShown) {
        Q_EMIT changed();
    }
}

void LongTasks::look() {
    bool isAnyShown = false;
    for (auto& [number, running] : running_) {
        running.isShown = running.isShown || running.since.hasExpired(quickMs);
        isAnyShown |= running.isShown;
    }
    if (isAnyShown) {
        Q_EMIT changed();
    }
}

std::vector<LongTasks::Row> LongTasks::running() const {
    return rows(true);
}

std::vector<LongTasks::Row> LongTasks::shown() const {
    return rows(false);
}

std::vector<LongTasks::Row> LongTasks::rows(bool all) const {
    std::vector<Row> rows;
    for (const auto& [number, running] : running_) {
        if (all || running.isShown) {
            const LongTask& task = running.task;
            rows.push_back({number, task.name, task.state ? task.state() : TaskState(),
                            task.cancel != nullptr});
        }
    }
    return rows;
}

void LongTasks::cancel(quint64 number) {
    const auto found = running_.find(number);
    if (found != running_.end() && found->second.task.cancel) {
        const auto stop = found->second.task.cancel; // it may erase the entry
        stop();
    }
}

} // namespace patina
