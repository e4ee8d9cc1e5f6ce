// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "gl/name.h"

namespace patina::gl {

void deleteQuery(unsigned name);

/// A query for the time the device spends between begin and end.
class TimeQuery {
  public:
    static TimeQuery create();

    void begin();
    void end();

    /// True when the result can be had without waiting.
    bool ready() const;

    /// Nanoseconds; waits for the device when it is not ready.
    std::uint64_t nanoseconds() const;

  private:
    Name<deleteQuery> name_;
};

} // namespace patina::gl
