// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <tuple>

#include "measure/eval/reference_case.h"

namespace patina::physics {

/// Finds the double-precision code of cases. It looks up that of a block once, which takes as long
/// as evaluating it.
class ReferenceCodes {
  public:
    const ReferenceCode& of(const EvalCase& request) {
        const Key key{request.block.block, &calledFunction(request), request.slot.block};
        auto found = known_.find(key);
        if (found == known_.end()) {
            found = known_.emplace(key, ReferenceCode::find(request).value()).first;
        }
        return found->second;
    }

  private:
    using Key = std::tuple<const Block*, const BlockFunction*, const Block*>;

    std::map<Key, ReferenceCode> known_;
};

} // namespace patina::physics
