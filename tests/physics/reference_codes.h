// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

#include "measure/eval/reference_case.h"

namespace patina::physics {

/// The double-precision code of cases. That of a block is looked up once, which takes as long as
/// evaluating it.
class ReferenceCodes {
  public:
    const ReferenceCode& of(const EvalCase& request) {
        const Blocks blocks{request.block.block, request.slot.block};
        auto found = known_.find(blocks);
        if (found == known_.end()) {
            found = known_.emplace(blocks, ReferenceCode::find(request).value()).first;
        }
        return found->second;
    }

  private:
    using Blocks = std::pair<const Block*, const Block*>;

    std::map<Blocks, ReferenceCode> known_;
};

} // namespace patina::physics
