#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/geometry/vector.h"

namespace trocar {

/// A tree of boxes, by FCL, that can be moved one by one: moving or finding some costs those, not all. FCL's
/// own manager of such a tree walks all of it after each change to see whether it is still balanced, which at
/// 8,000 boxes takes three times as long as everything else that detection does. An organ's patches stay
/// beside each other, so the tree that suits them at rest goes on suiting them.
class PatchTree {
  public:
    /// Of boxes that are not empty.
    explicit PatchTree(std::span<const Box> boxes);
    ~PatchTree();
    PatchTree(const PatchTree&) = delete;
    PatchTree& operator=(const PatchTree&) = delete;

    void set(std::uint32_t number, const Box& box);

    /// Adds to `found` the numbers of the boxes that meet `box`, touching included.
    void find(const Box& box, std::vector<std::uint32_t>& found) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace trocar
