// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/name.h"
#include "gl/query.h"

namespace patina::gl {

/// Asks whether any sample drawn between begin() and end() passes the depth and stencil tests.
/// Drawing can depend on the answer on the device, so that the CPU does not wait for it.
class SampleQuery {
  public:
    static SampleQuery create();

    void begin() const;
    static void end();

    /// Makes the device skip what follows, up to endCondition(), if no sample had passed.
    void beginCondition() const;
    static void endCondition();

  private:
    Name<deleteQuery> name_;
};

} // namespace patina::gl
