// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_turntable.h"

#include <utility>

namespace patina {
namespace {

constexpr int tickMs = 33;
constexpr double degreesPerSecond = 30.0;

} // namespace

ViewTurntable::ViewTurntable(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    tick_.setInterval(tickMs);
    connect(&tick_, &QTimer::timeout, this, &ViewTurntable::moved);
}

Result<void> ViewTurntable::setTurning(std::optional<TurntableOf> what) {
    if (what) {
        const auto possible = onTurntable(document_.scene(), document_.catalog(), *what, 0.0);
        if (!possible) {
            return tl::unexpected(possible.error());
        }
    }
    if (what != std::exchange(what_, what)) {
        since_.start();
        what_ ? tick_.start() : tick_.stop();
        Q_EMIT changed();
        Q_EMIT moved();
    }
    return {};
}

const Scene& ViewTurntable::turned(const Scene& scene, Side side) {
    if (!what_) {
        return scene;
    }
    auto turned = onTurntable(scene, document_.catalog(), *what_,
                              1e-3 * double(since_.elapsed()) * degreesPerSecond);
    if (!turned) {
        return scene; // the object or light that turned was removed
    }
    return shown_[indexOf(side)] = std::move(*turned);
}

} // namespace patina
