// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "gl/name.h"

namespace patina::gl {

void deleteQuery(unsigned name);

/// Asks for the time that passes on the device between begin and end. Others may begin and end in
/// between.
class TimeQuery {
  public:
    static TimeQuery create();

    void begin();
    void end();

    /// True when the result can be had without waiting.
    bool ready() const;

    /// Returns nanoseconds; waits for the device when it is not ready.
    std::uint64_t nanoseconds() const;

  private:
    Name<deleteQuery> began_;
    Name<deleteQuery> ended_;
};

} // namespace patina::gl
