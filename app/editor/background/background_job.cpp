// SPDX-License-Identifier: GPL-3.0-or-later
#include "background/background_job.h"

#include <utility>

#include "gl/headless_context.h"

namespace patina {
namespace {

constexpr qint64 tellEveryMs = 50;

} // namespace

void BackgroundJob::Control::tell(double share, const QString& doing, bool isAnother) {
    if (isAnother || sinceTold_.elapsed() >= tellEveryMs) {
        sinceTold_.restart();
        Q_EMIT job_.progressed(share, doing);
    }
}

void BackgroundJob::Control::show(std::function<void()> news) {
    QMetaObject::invokeMethod(&job_, std::move(news));
}

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {}

BackgroundJob::~BackgroundJob() {
    cancelled_ = true;
    worker_.waitForDone();
}

void BackgroundJob::start(Work work) {
    if (std::exchange(running_, true)) {
        return;
    }
    cancelled_ = false;
    worker_.start([this, work = std::move(work)] {
        Control control(*this);
        const End end = work(control);
        QMetaObject::invokeMethod(this, [this, end] {
            running_ = false;
            Q_EMIT finished(end.complete, end.problem);
        });
    });
}

void BackgroundJob::cancel() {
    cancelled_ = true;
}

BackgroundJob::Work withContext(BackgroundJob::Work work) {
    return [work = std::move(work)](BackgroundJob::Control& control) -> BackgroundJob::End {
        const auto context = gl::HeadlessContext::create();
        return context ? work(control) : endOf(false, {context.error()});
    };
}

BackgroundJob::End endOf(bool finished, const Errors& problems) {
    return {finished && problems.empty(), QString::fromStdString(text(problems)).trimmed()};
}

} // namespace patina
