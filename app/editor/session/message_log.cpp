// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/message_log.h"

#include <algorithm>

namespace patina {
namespace {

/// At most this many events are kept, more than anybody reads; the oldest are dropped.
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
    for (const Event& event : events_) {
        all.push_back(event.message);
    }
    return all;
}

int MessageLog::count() const {
    return static_cast<int>(messages().size());
}

int MessageLog::noteCount() const {
    return static_cast<int>(
        std::ranges::count_if(events_, [](const Event& event) { return event.isNote; }));
}

void MessageLog::append(const Event& event) {
    if (events_.size() == maxEvents) {
        events_.erase(events_.begin());
    }
    events_.push_back(event);
    Q_EMIT changed();
}

void MessageLog::add(const Error& event) {
    append({event, false});
    Q_EMIT arrived(event);
}

void MessageLog::addNote(const Error& event) {
    append({event, true});
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
