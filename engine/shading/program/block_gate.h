// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/error.h"
#include "shading/glsl/stranger_block.h"

namespace patina {

struct ProgramSource;

/// Says which blocks that did not ship may be compiled in this process: those that did their
/// compiler and their device no harm elsewhere. Thread-safe.
class BlockGate {
  public:
    struct Answer {
        Errors mistakes;     ///< of blocks that must not be compiled here
        bool isFinal = true; ///< false: some were not tried yet, and `mistakes` says so
    };

    virtual ~BlockGate() = default;

    /// Needs the context in which they would be compiled. Waits for trials where `mayWait`.
    virtual Answer ask(std::span<const StrangerBlock> blocks, bool mayWait) = 0;

    /// Ends the trial that runs, and begins none until resume(): who waits is not to wait any more.
    virtual void stop() = 0;
    virtual void resume() = 0;
};

/// The process' own gate; null: every block may be compiled. Set it before other threads start.
void setBlockGate(std::shared_ptr<BlockGate> gate);
const std::shared_ptr<BlockGate>& blockGate();

/// For a thread that shows a window: it gets an answer that is not final rather than wait.
void neverWaitForTrialsHere();

/// The gate's answer on everything in a program; needs the context that would compile it.
BlockGate::Answer gateAnswer(const ProgramSource& source);
BlockGate::Answer gateAnswer(std::span<const StrangerBlock> blocks);

} // namespace patina
