#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/deformation/spring_layout.h"

namespace trocar {

/// Which patches of a network are awake, and the springs with an end in one of them, level by level. Sleeping
/// leaves springs out and never changes the order of the others. No call but the constructor asks for memory.
class AwakePatches {
  public:
    using Spring = SpringLayout::Spring;

    /// All asleep. The layout must outlive it.
    explicit AwakePatches(const SpringLayout& layout);

    [[nodiscard]] bool awake(std::uint32_t patch) const { return awake_[patch]; }
    [[nodiscard]] std::span<const std::uint32_t> patches() const { return patches_; }

    /// Calls `act` with spans of springs of awake patches, level by level: springs of one span share no
    /// vertex.
    template <typename Act>
    void for_each_level(const Act& act) const {
        std::span<const Spring> most = springs_, late = late_springs_;
        while (!most.empty() || !late.empty()) {
            const bool late_is_next =
                most.empty() || (!late.empty() && late.front().level < most.front().level);
            std::span<const Spring>& next = late_is_next ? late : most;
            std::size_t count = 1;
            while (count < next.size() && next[count].level == next.front().level) ++count;
            act(next.first(count));
            next = next.subspan(count);
        }
    }

    /// Wakes these patches; those that are awake already may be among them.
    /// @returns the ones that were asleep, until the next call
    std::span<const std::uint32_t> wake(std::span<const std::uint32_t> patches);

    /// Takes the springs of what woke lately among the others: dear, and going through them is cheaper then.
    void settle();

    /// Lets these patches, all awake, fall asleep.
    void let_sleep(std::span<const std::uint32_t> patches);

  private:
    const SpringLayout& layout_;
    std::vector<bool> awake_;
    std::vector<std::uint32_t> patches_;
    std::vector<Spring> springs_, late_springs_;         // level by level
    std::vector<std::uint32_t> woken_, merged_patches_;  // scratch
    std::vector<Spring> more_springs_, merged_springs_;  // scratch
};

}  // namespace trocar
