// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/idle_release.h"

#include <utility>

#include <QApplication>

namespace patina {
namespace {

constexpr int idleMs = 300;

} // namespace

IdleRelease::IdleRelease(std::function<bool()> isBusy, std::function<void()> release)
    : isBusy_(std::move(isBusy)), release_(std::move(release)) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &IdleRelease::check);
}

void IdleRelease::noteUse() {
    sinceUse_.start();
    if (!timer_.isActive()) {
        timer_.start(idleMs);
    }
}

/// Waits while a mouse button is down, so that a drag that rests goes on as quickly as before.
void IdleRelease::check() {
    const bool busy = isBusy_() || QApplication::mouseButtons() != Qt::NoButton;
    const qint64 left = idleMs - sinceUse_.elapsed();
    if (busy || left > 0) {
        timer_.start(busy ? idleMs : static_cast<int>(left));
    } else {
        release_();
    }
}

} // namespace patina
