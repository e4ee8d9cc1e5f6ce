// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/message_log.h"

#include <algorithm>

namespace patina {
namespace {

/// The oldest events go when there are more than anybody reads.
constexpr std::size_t maxEvents = 500;

bool holds(const Errors& messages, const Error& message) {
    return std::find(messages.begin(), messages.end(), message) != messages.end();
}

} // namespace

Errors MessageLog::messages() const {
    Errors all;
    for (const auto& [group, messages] : groups_) {
        for (const Error& message : messages) {
            if (!holds(all, message)) { // both views say the same
                all.push_back(message);
            }
        }
    }
    all.insert(all.end(), events_.begin(), events_.end());
    return all;
}

int MessageLog::count() const {
    return static_cast<int>(messages().size());
}

void MessageLog::add(const Error& event) {
    if (events_.size() == maxEvents) {
        events_.erase(events_.begin());
    }
    events_.push_back(event);
    Q_EMIT changed();
    Q_EMIT arrived(event);
}

void MessageLog::setGroup(const QString& group, const Errors& messages) {
    const Errors before = groups_[group];
    if (before == messages) {
        return;
    }
    const Errors known = this->messages();
    groups_[group] = messages;
    Q_EMIT changed();
    for (const Error& message : messages) {
        if (!holds(known, message)) {
            Q_EMIT arrived(message);
        }
    }
}

void MessageLog::clearEvents() {
    events_.clear();
    Q_EMIT changed();
}

} // namespace patina
