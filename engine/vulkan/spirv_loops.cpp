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
        std::vector<std::size_t> counted; // are the merges of these loops
        for (const std::size_t merge : merges_) {
            if (auto loop = holdsOthers(merge) ? std::nullopt : loopAt(merge)) {
                for (const std::size_t other : merges_) {
                    const auto place = std::ranges::find(counted, other);
                    if (other >= merge || merge >= endOf(other)) {
                        continue;
                    }
                    if (place != counted.end()) {
                        loop->around.push_back(static_cast<std::size_t>(place - counted.begin()));
                    } else {
                        ++loop->othersAround;
                    }
                }
                loop->instructions = endOf(merge) - merge;
                counted.push_back(merge);
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

    /// Tells whether there is a loop in it whose rounds are no constant.
    bool holdsOthers(std::size_t merge) const {
        return std::ranges::any_of(merges_, [&](std::size_t other) {
            return merge < other && other < endOf(merge) && !loopAt(other);
        });
    }

    /// Says where a counter begins, and by how much it is higher in each round.
    struct Count {
        std::int64_t begin = 0;
        std::int64_t step = 1;
    };

    /// Returns how a counter goes up; nothing for another value.
    std::optional<Count> countOf(std::uint32_t counter) const {
        const Instruction* phi = find(counter, spv::OpPhi);
        if (phi == nullptr || phi->words.size() != 7) {
            return std::nullopt;
        }
        for (const auto& [first, next] :
             {std::pair(phi->words[3], phi->words[5]), std::pair(phi->words[5], phi->words[3])}) {
            const Instruction* sum = find(next, spv::OpIAdd);
            if (const auto begin = constant(first); begin && sum != nullptr) {
                const auto step = sum->words[3] == counter   ? constant(sum->words[4])
                                  : sum->words[4] == counter ? constant(sum->words[3])
                                                             : std::nullopt;
                return step && *step > 0 ? std::optional(Count{*begin, *step}) : std::nullopt;
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
        const auto count = countOf(comparison.words[3]);
        const auto bound = constant(comparison.words[4]);
        if (!count || !bound || *bound + inclusive <= count->begin) {
            return std::nullopt;
        }
        const Instruction& constant = *find(comparison.words[4], spv::OpConstant);
        CountedLoop loop;
        loop.rounds =
            static_cast<int>((*bound + inclusive - count->begin + count->step - 1) / count->step);
        loop.bound = comparison.at + 4;
        loop.constantEnd = constant.at + constant.words.size();
        loop.type = constant.words[1];
        loop.onceBound = count->begin + 1 - inclusive;
        return loop;
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
