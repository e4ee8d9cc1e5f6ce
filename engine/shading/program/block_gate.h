// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/error.h"
#include "shading/glsl/stranger_block.h"

namespace patina {

struct ProgramSource;

/// Decides which blocks that did not ship may be compiled in this process: those whose compilation
/// in another process did no harm to the compiler and the device. It is thread-safe.
class BlockGate {
  public:
    struct Answer {
        Errors mistakes;     ///< are about blocks that must not be compiled here
        bool isFinal = true; ///< false: some blocks were not tried yet, and `mistakes` says so
    };

    virtual ~BlockGate() = default;

    /// Asks about blocks. It needs the context in which they would be compiled, and waits for
    /// trials where `mayWait`.
    virtual Answer ask(std::span<const StrangerBlock> blocks, bool mayWait) = 0;

    /// Ends the current trial, and begins none until resume(), so that nobody waits for one any
    /// longer.
    virtual void stop() = 0;
    virtual void resume() = 0;
};

/// Sets the process' own gate; null: every block may be compiled. Call it before other threads
/// start.
void setBlockGate(std::shared_ptr<BlockGate> gate);
const std::shared_ptr<BlockGate>& blockGate();

/// Makes the calling thread get an answer that is not final rather than wait: it shows a window.
void neverWaitForTrialsHere();

/// Returns the gate's answer on everything in a program; needs the context that would compile it.
BlockGate::Answer gateAnswer(const ProgramSource& source);
BlockGate::Answer gateAnswer(std::span<const StrangerBlock> blocks);

} // namespace patina
