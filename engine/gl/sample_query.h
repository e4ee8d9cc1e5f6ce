// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/name.h"
#include "gl/query.h"

namespace patina::gl {

/// A query whether anything that is drawn between begin and end passes the tests, and drawing that
/// depends on the answer without waiting for it.
class SampleQuery {
  public:
    static SampleQuery create();

    void begin() const;
    static void end();

    /// What is drawn from here on is only drawn if something had passed; ends with endCondition().
    void beginCondition() const;
    static void endCondition();

  private:
    Name<deleteQuery> name_;
};

} // namespace patina::gl
