// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>

#include "core/error.h"
#include "vulkan/spirv_program.h"

namespace patina {

/// Is a device with one of AMD's chips without the hardware: Mesa's RADV compiles for it and can
/// do nothing else. Make it in a process of its own, since the driver may end that.
class NullDevice {
  public:
    /// Holds the driver's numbers about one compiled stage by the driver's own names, such as
    /// "Instructions", "Subgroup size", and by ours "Loops", those that are left, and "Look-ups" of
    /// texels.
    using Statistics = std::map<std::string, double>;

    /// Holds the statistics of each stage: "vertex", "fragment".
    using StageStatistics = std::map<std::string, Statistics>;

    /// Makes a device of the first of these chips, such as "navi21", that RADV knows. It changes
    /// this process' environment. It is an error where the driver is missing or knows none.
    static Result<NullDevice> create(std::span<const std::string> chips);

    NullDevice(NullDevice&&) noexcept;
    NullDevice& operator=(NullDevice&&) noexcept;
    ~NullDevice();

    /// Returns the driver's version, such as "Mesa 22.3.6".
    const std::string& driver() const;

    /// Compiles a program for drawing triangles with a depth test into images of half floats. Where
    /// loops are not counted, which takes the driver long, "Loops" is 0.
    Result<StageStatistics> compile(const SpirvProgram& program, bool countsLoops = true) const;

  private:
    class Implementation;
    explicit NullDevice(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
