#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "common/deformation/spring_layout.h"

namespace trocar {

/// Which patches of a network are awake, and which springs have an end in one of them, in the order in which
/// they are done. Sleeping leaves springs out and never changes the order of the others. No call but the
/// constructor asks for memory.
class AwakePatches {
  public:
    /// A spring's place in the order and its number.
    struct Turn {
        std::uint32_t level, spring;

        friend auto operator<=>(const Turn&, const Turn&) = default;
    };

    /// All asleep. The layout must outlive it.
    explicit AwakePatches(const SpringLayout& layout);

    [[nodiscard]] bool awake(std::uint32_t patch) const { return awake_[patch]; }
    [[nodiscard]] std::span<const std::uint32_t> patches() const { return patches_; }
    [[nodiscard]] std::span<const Turn> springs() const { return springs_; }

    /// Wakes these patches; those that are awake already may be among them.
    /// @returns the ones that were asleep, until the next call
    std::span<const std::uint32_t> wake(std::span<const std::uint32_t> patches);

    /// Lets these patches, all awake, fall asleep.
    void let_sleep(std::span<const std::uint32_t> patches);

  private:
    const SpringLayout& layout_;
    std::vector<bool> awake_;
    std::vector<std::uint32_t> patches_;
    std::vector<Turn> springs_;
    std::vector<std::uint32_t> woken_, merged_patches_;  // scratch
    std::vector<Turn> more_springs_, merged_springs_;    // scratch
};

}  // namespace trocar
