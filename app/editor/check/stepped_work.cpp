// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/stepped_work.h"

#include <utility>

#include "gl/headless_context.h"

namespace patina {
namespace {

constexpr qint64 tellEveryMs = 50;

} // namespace

SteppedWork::SteppedWork(QObject* parent) : QObject(parent) {
    worker_.setMaxThreadCount(1);
    worker_.setExpiryTimeout(100);
}

SteppedWork::~SteppedWork() {
    cancelled_ = true;
    worker_.waitForDone();
}

void SteppedWork::start(Maker make) {
    if (std::exchange(running_, true)) {
        return;
    }
    cancelled_ = false;
    worker_.start([this, make = std::move(make)] {
        const End end = work(make);
        QMetaObject::invokeMethod(this, [this, end] {
            running_ = false;
            Q_EMIT finished(end.complete, end.problem);
        });
    });
}

void SteppedWork::cancel() {
    cancelled_ = true;
}

/// In the worker's thread, as what follows.
SteppedWork::End SteppedWork::work(const Maker& make) {
    const auto context = gl::HeadlessContext::create();
    if (!context) {
        return {false, QString::fromStdString(context.error().text())};
    }
    const auto job = make();
    if (!job) {
        return {false, QString::fromStdString(job.error().text())};
    }
    QElapsedTimer sinceTold;
    sinceTold.start();
    while (!(*job)->finished() && !cancelled_) {
        (*job)->step();
        tell(**job, sinceTold);
    }
    return {(*job)->finished() && (*job)->problems().empty(),
            QString::fromStdString(text((*job)->problems())).trimmed()};
}

void SteppedWork::tell(Job& job, QElapsedTimer& sinceTold) {
    if (const std::function<void()> news = job.news()) {
        QMetaObject::invokeMethod(this, news);
    }
    if (sinceTold.elapsed() >= tellEveryMs) {
        sinceTold.restart();
        Q_EMIT progressed(job.progress(), job.doing());
    }
}

} // namespace patina
