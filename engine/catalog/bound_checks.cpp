// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/bound_checks.h"

#include <fmt/format.h>

#include "catalog/descriptor_checker.h"
#include "catalog/suggestion.h"

namespace patina {
namespace {

class BoundChecker : DescriptorChecker {
  public:
    explicit BoundChecker(const Descriptor& descriptor) : DescriptorChecker(descriptor) {}

    Errors run() {
        if (block_.hides) {
            checkHiding(*block_.hides);
        }
        if (block_.reach) {
            checkReach(*block_.reach);
        }
        return std::move(errors_);
    }

  private:
    void checkHiding(const Hiding& hiding) {
        const bool isRate = !hiding.rate.empty();
        if (isRate == !hiding.from.empty() || isRate == !hiding.to.empty()) {
            add("/hides", "this does not say how much is hidden",
                "either \"rate\", or \"from\" and \"to\"");
            return;
        }
        for (const auto& [key, id] :
             {std::pair{"rate", &hiding.rate}, std::pair{"from", &hiding.from},
              std::pair{"to", &hiding.to}}) {
            checkType(fmt::format("/hides/{}", key), *id, ParameterType::Float, Space::None);
        }
        if (hiding.base.empty() != hiding.thickness.empty() || (!isRate && !hiding.base.empty())) {
            add("/hides", "a rate that falls with height has a base and a thickness",
                "\"rate\", \"base\" and \"thickness\"");
        }
        checkType("/hides/base", hiding.base, ParameterType::Float, Space::None);
        checkType("/hides/thickness", hiding.thickness, ParameterType::Float, Space::None);
        if (hiding.center.empty() != hiding.size.empty() || (!isRate && !hiding.size.empty())) {
            add("/hides", "a box of fog has a rate, a center and a size",
                "\"rate\", \"center\" and \"size\"");
        }
        checkType("/hides/center", hiding.center, ParameterType::Vec3, Space::WorldPoint);
        checkType("/hides/size", hiding.size, ParameterType::Vec3, Space::None);
    }

    void checkReach(const Reach& reach) {
        checkType("/reach/from", reach.from, ParameterType::Vec3, Space::WorldPoint);
        checkType("/reach/range", reach.range, ParameterType::Float, Space::None);
        checkType("/reach/axis", reach.axis, ParameterType::Vec3, Space::WorldDirection);
        checkType("/reach/angle", reach.angle, ParameterType::Angle, Space::None);
        if (reach.axis.empty() != reach.angle.empty()) {
            add("/reach", "a cone has an axis and an angle", "both of them or neither");
        }
    }

    void checkType(const std::string& pointer, const std::string& id, ParameterType type,
                   Space space) {
        if (id.empty()) {
            return;
        }
        std::vector<std::string> known;
        for (const Parameter& parameter : block_.parameters) {
            if (parameter.type == type && parameter.space == space) {
                known.push_back(parameter.id);
            }
        }
        const Parameter* parameter = block_.parameter(id);
        if (parameter == nullptr || parameter->type != type || parameter->space != space) {
            add(pointer, fmt::format("\"{}\" is not the parameter that is needed here", id),
                known.empty() ? "a parameter of the right type and space" : oneOf(id, known));
        }
    }
};

} // namespace

Errors boundMistakes(const Descriptor& descriptor) {
    return BoundChecker(descriptor).run();
}

} // namespace patina
