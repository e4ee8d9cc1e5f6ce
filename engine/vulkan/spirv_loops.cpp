// SPDX-License-Identifier: GPL-3.0-or-later
#include "vulkan/spirv_loops.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <unordered_map>

#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/spirv.hpp>

namespace patina {
namespace {

using Words = std::span<const std::uint32_t>;

constexpr std::size_t headerWords = 5;
constexpr std::size_t idsOfHeader = 3; ///< is the header's word that holds one more than every id

struct Instruction {
    spv::Op op = spv::OpNop;
    std::size_t at = 0; ///< is the index of its first word
    Words words;
};

std::vector<Instruction> instructionsIn(Words module) {
    std::vector<Instruction> all;
    for (std::size_t at = headerWords; at < module.size();) {
        const std::size_t count = module[at] >> 16;
        if (count == 0 || at + count > module.size()) {
            break;
        }
        all.push_back({static_cast<spv::Op>(module[at] & 0xffffu), at, module.subspan(at, count)});
        at += count;
    }
    return all;
}

/// Finds the loops of a module. Blocks of a loop stand between its header and its merge block.
class LoopFinder {
  public:
    explicit LoopFinder(Words module) : all_(instructionsIn(module)) {
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const Words words = all_[i].words;
            switch (all_[i].op) {
            case spv::OpConstant:
            case spv::OpPhi:
            case spv::OpIAdd:
            case spv::OpSLessThan:
            case spv::OpSLessThanEqual:
            case spv::OpULessThan:
            case spv::OpULessThanEqual:
                byId_[words[2]] = i;
                break;
            case spv::OpLabel:
                byId_[words[1]] = i;
                break;
            case spv::OpLoopMerge:
                merges_.push_back(i);
                break;
            default:
                break;
            }
        }
    }

    std::vector<CountedLoop> loops() const {
        std::vector<CountedLoop> loops;
        for (const std::size_t merge : merges_) {
            if (auto loop = isNested(merge) ? std::nullopt : loopAt(merge)) {
                loops.push_back(std::move(*loop));
            }
        }
        return loops;
    }

  private:
    const Instruction* find(std::uint32_t id, spv::Op op) const {
        const auto found = byId_.find(id);
        return found != byId_.end() && all_[found->second].op == op ? &all_[found->second]
                                                                    : nullptr;
    }

    std::optional<std::int64_t> constant(std::uint32_t id) const {
        const Instruction* found = find(id, spv::OpConstant);
        return found != nullptr && found->words.size() == 4
                   ? std::optional<std::int64_t>(static_cast<std::int32_t>(found->words[3]))
                   : std::nullopt;
    }

    /// Returns the index of the block behind a loop.
    std::size_t endOf(std::size_t merge) const {
        const auto found = byId_.find(all_[merge].words[1]);
        return found == byId_.end() ? all_.size() : found->second;
    }

    bool isNested(std::size_t merge) const {
        return std::ranges::any_of(merges_, [&](std::size_t other) {
            const bool holdsOther = merge < other && other < endOf(merge);
            const bool isWithin = other < merge && merge < endOf(other);
            return holdsOther || isWithin;
        });
    }

    /// Returns where a counter begins that is one higher in each round; nothing for another value.
    std::optional<std::int64_t> beginOf(std::uint32_t counter) const {
        const Instruction* phi = find(counter, spv::OpPhi);
        if (phi == nullptr || phi->words.size() != 7) {
            return std::nullopt;
        }
        for (const auto& [first, next] :
             {std::pair(phi->words[3], phi->words[5]), std::pair(phi->words[5], phi->words[3])}) {
            const Instruction* sum = find(next, spv::OpIAdd);
            if (const auto begin = constant(first); begin && sum != nullptr) {
                const bool isByOne = (sum->words[3] == counter && constant(sum->words[4]) == 1) ||
                                     (sum->words[4] == counter && constant(sum->words[3]) == 1);
                return isByOne ? begin : std::nullopt;
            }
        }
        return std::nullopt;
    }

    std::optional<CountedLoop> loopAt(std::size_t merge) const {
        if (merge + 1 >= all_.size() || all_[merge + 1].op != spv::OpBranchConditional) {
            return std::nullopt;
        }
        const std::uint32_t condition = all_[merge + 1].words[1];
        for (const spv::Op op :
             {spv::OpSLessThan, spv::OpULessThan, spv::OpSLessThanEqual, spv::OpULessThanEqual}) {
            if (const Instruction* comparison = find(condition, op)) {
                const bool isBelow = op == spv::OpSLessThan || op == spv::OpULessThan;
                return counted(*comparison, isBelow ? 0 : 1);
            }
        }
        return std::nullopt;
    }

    /// `inclusive` is 1 where the loop's last number is the bound itself, else 0.
    std::optional<CountedLoop> counted(const Instruction& comparison,
                                       std::int64_t inclusive) const {
        const auto begin = beginOf(comparison.words[3]);
        const auto bound = constant(comparison.words[4]);
        if (!begin || !bound || *bound + inclusive <= *begin) {
            return std::nullopt;
        }
        const Instruction& constant = *find(comparison.words[4], spv::OpConstant);
        return CountedLoop{static_cast<int>(*bound + inclusive - *begin), comparison.at + 4,
                           constant.at + constant.words.size(), constant.words[1],
                           *begin + 1 - inclusive};
    }

    std::vector<Instruction> all_;
    std::vector<std::size_t> merges_; ///< are indices of OpLoopMerge
    std::unordered_map<std::uint32_t, std::size_t> byId_;
};

} // namespace

bool hasLoops(std::span<const std::uint32_t> module) {
    return std::ranges::any_of(instructionsIn(module), [](const Instruction& instruction) {
        return instruction.op == spv::OpLoopMerge;
    });
}

bool readsTexels(std::span<const std::uint32_t> module) {
    return std::ranges::any_of(instructionsIn(module), [](const Instruction& instruction) {
        return instruction.op >= spv::OpImageSampleImplicitLod &&
               instruction.op <= spv::OpImageDrefGather;
    });
}

Result<std::vector<std::uint32_t>> optimisedSpirv(std::span<const std::uint32_t> module) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    optimizer.RegisterPerformancePasses();
    std::vector<std::uint32_t> optimised;
    if (!optimizer.Run(module.data(), module.size(), &optimised)) {
        return failure("the shader's code cannot be optimised");
    }
    return optimised;
}

std::vector<CountedLoop> countedLoops(std::span<const std::uint32_t> module) {
    return LoopFinder(module).loops();
}

std::vector<std::uint32_t> withOneRound(std::span<const std::uint32_t> module,
                                        std::span<const CountedLoop> loops) {
    std::vector<std::uint32_t> changed(module.begin(), module.end());
    std::vector<CountedLoop> backwards(loops.begin(), loops.end());
    std::ranges::sort(backwards, std::ranges::greater(), &CountedLoop::constantEnd);
    std::vector<std::uint32_t> ids;
    for (const CountedLoop& loop : backwards) {
        ids.push_back(changed[idsOfHeader]++);
        changed[loop.bound] = ids.back();
    }
    // Each bound is a constant of its own, which is defined behind the old one.
    for (std::size_t i = 0; i < backwards.size(); ++i) {
        const std::uint32_t constant[] = {(4u << 16) | spv::OpConstant, backwards[i].type, ids[i],
                                          static_cast<std::uint32_t>(backwards[i].onceBound)};
        changed.insert(changed.begin() + std::ptrdiff_t(backwards[i].constantEnd),
                       std::begin(constant), std::end(constant));
    }
    return changed;
}

} // namespace patina
