// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/block_gate.h"

#include <utility>
#include <vector>

#include "shading/program/program_source.h"

namespace patina {
namespace {

std::shared_ptr<BlockGate>& gateOfProcess() {
    static std::shared_ptr<BlockGate> gate;
    return gate;
}

thread_local bool mayWait = true;

} // namespace

void setBlockGate(std::shared_ptr<BlockGate> gate) {
    gateOfProcess() = std::move(gate);
}

const std::shared_ptr<BlockGate>& blockGate() {
    return gateOfProcess();
}

void neverWaitForTrialsHere() {
    mayWait = false;
}

BlockGate::Answer gateAnswer(const ProgramSource& source) {
    std::vector<StrangerBlock> blocks;
    for (const ShaderSource* stage : {&source.vertex, &source.fragment}) {
        blocks.insert(blocks.end(), stage->strangers.begin(), stage->strangers.end());
    }
    if (source.geometry) {
        blocks.insert(blocks.end(), source.geometry->strangers.begin(),
                      source.geometry->strangers.end());
    }
    return gateAnswer(blocks);
}

BlockGate::Answer gateAnswer(std::span<const StrangerBlock> blocks) {
    const std::shared_ptr<BlockGate>& gate = blockGate();
    return gate == nullptr || blocks.empty() ? BlockGate::Answer() : gate->ask(blocks, mayWait);
}

} // namespace patina
