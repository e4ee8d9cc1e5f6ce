// SPDX-License-Identifier: GPL-3.0-or-later
#include "heartbeat.h"

#include <algorithm>

namespace patina::benchmarks {
namespace {

constexpr int beatMs = 5;

} // namespace

Heartbeat::Heartbeat() {
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { beat(); });
    timer_.start(beatMs);
    start();
}

void Heartbeat::start() {
    longest_ = 0.0;
    last_.start();
}

double Heartbeat::longestGap() const {
    return std::max(longest_, sinceLast());
}

void Heartbeat::beat() {
    longest_ = std::max(longest_, sinceLast());
    last_.restart();
}

} // namespace patina::benchmarks
