// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "gl/name.h"

namespace patina::gl {

void deleteQuery(unsigned name);

/// Measures the time that passes on the device between begin() and end(). Queries may overlap.
class TimeQuery {
  public:
    static TimeQuery create();

    void begin();
    void end();

    /// Returns true when nanoseconds() would not wait.
    bool ready() const;

    /// Returns the time, in nanoseconds; waits for the device when it is not ready.
    std::uint64_t nanoseconds() const;

  private:
    Name<deleteQuery> began_;
    Name<deleteQuery> ended_;
};

} // namespace patina::gl
