// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/frame_stopwatch.h"

#include <QObject>

namespace patina {

QString FrameStopwatch::text() {
    if (!timer_) {
        return {};
    }
    {
        const ViewContext::Current current(context_);
        timer_->collect();
    }
    if (timer_->milliseconds() > 0.0) {
        const std::string_view method = timer_->methodText();
        const double taken = timer_->milliseconds();
        const int decimals = taken < 10.0 ? 2 : taken < 100.0 ? 1 : 0;
        text_ = QObject::tr("%1 ms (%2)")
                    .arg(taken, 0, 'f', decimals)
                    .arg(QString::fromUtf8(method.data(), qsizetype(method.size())));
    }
    return text_;
}

void FrameStopwatch::choose(bool isOpen) {
    if (!timer_) {
        return;
    }
    text(); // of the frames so far
    const ViewContext::Current current(context_);
    const FrameTimer::Method method = trustedMethod();
    if (method != timer_->method() && !isOpen) {
        timer_.emplace(method);
    }
}

} // namespace patina
