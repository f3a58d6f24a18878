#include "common/deformation/awake_patches.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace trocar {
namespace {

/// Adds `more`, ascending, to `all`, ascending.
template <typename Entry, typename Key = std::identity>
void merge_into(std::vector<Entry>& all, const std::vector<Entry>& more, std::vector<Entry>& merged,
                Key key = {}) {
    merged.clear();
    std::ranges::merge(all, more, std::back_inserter(merged), {}, key, key);
    std::swap(all, merged);
}

/// Level by level, and within one as memory lies: what the next level needs first is then done first.
std::uint64_t turn(const SpringLayout::Spring& spring) {
    return std::uint64_t{spring.level} << 32U | spring.a;
}

}  // namespace

AwakePatches::AwakePatches(const SpringLayout& layout) : layout_(layout), awake_(layout.patches(), false) {
    for (auto* list : {&patches_, &woken_, &merged_patches_}) list->reserve(layout.patches());
    // Of what is never used the system never gives any.
    for (auto* list : {&springs_, &late_springs_, &more_springs_, &merged_springs_}) {
        list->reserve(layout.springs.size());
    }
}

std::span<const std::uint32_t> AwakePatches::wake(std::span<const std::uint32_t> patches) {
    woken_.clear();
    more_springs_.clear();
    for (const std::uint32_t patch : patches) {
        if (awake_[patch]) continue;
        for (const std::uint32_t k : layout_.springs_at[patch]) {
            const auto& spring = layout_.springs[k];
            const bool listed = awake_[layout_.patch_of[spring.a]] || awake_[layout_.patch_of[spring.b]];
            if (!listed) more_springs_.push_back(spring);
        }
        awake_[patch] = true;
        woken_.push_back(patch);
    }
    if (woken_.empty()) return woken_;
    std::ranges::sort(woken_);
    std::ranges::sort(more_springs_, {}, turn);
    merge_into(patches_, woken_, merged_patches_);
    merge_into(late_springs_, more_springs_, merged_springs_, turn);
    return woken_;
}

void AwakePatches::settle() {
    if (late_springs_.empty()) return;
    merge_into(springs_, late_springs_, merged_springs_, turn);
    late_springs_.clear();
}

void AwakePatches::let_sleep(std::span<const std::uint32_t> patches) {
    if (patches.empty()) return;
    for (const std::uint32_t patch : patches) awake_[patch] = false;
    std::erase_if(patches_, [&](std::uint32_t patch) { return !awake_[patch]; });
    const auto asleep = [&](const Spring& spring) {
        return !awake_[layout_.patch_of[spring.a]] && !awake_[layout_.patch_of[spring.b]];
    };
    std::erase_if(springs_, asleep);
    std::erase_if(late_springs_, asleep);
}

}  // namespace trocar
