// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "catalog/descriptor.h"

namespace patina {

/// Collects the mistakes of one descriptor, each at its place.
class DescriptorChecker {
  protected:
    explicit DescriptorChecker(const Descriptor& descriptor)
        : block_(descriptor.block), document_(descriptor.document) {}
    ~DescriptorChecker() = default;

    void add(const std::string& pointer, std::string problem, std::string expected = {}) {
        errors_.push_back(document_.error(pointer, std::move(problem), std::move(expected)));
    }

    const Block& block_;
    const LocatedJson& document_;
    Errors errors_;
};

} // namespace patina
