#include "common/deformation/awake_patches.h"

#include <algorithm>
#include <iterator>

namespace trocar {
namespace {

/// Adds `more`, ascending, to `all`, ascending.
template <typename Entry>
void merge_into(std::vector<Entry>& all, const std::vector<Entry>& more, std::vector<Entry>& merged) {
    merged.clear();
    std::ranges::merge(all, more, std::back_inserter(merged));
    std::swap(all, merged);
}

}  // namespace

AwakePatches::AwakePatches(const SpringLayout& layout) : layout_(layout), awake_(layout.patches(), false) {
    for (auto* list : {&patches_, &woken_, &merged_patches_}) list->reserve(layout.patches());
    // Of what is never used the system never gives any.
    for (auto* list : {&springs_, &more_springs_, &merged_springs_}) list->reserve(layout.springs.size());
}

std::span<const std::uint32_t> AwakePatches::wake(std::span<const std::uint32_t> patches) {
    woken_.clear();
    more_springs_.clear();
    for (const std::uint32_t patch : patches) {
        if (awake_[patch]) continue;
        for (const std::uint32_t k : layout_.springs_at[patch]) {
            const auto& spring = layout_.springs[k];
            const bool listed = awake_[layout_.patch_of[spring.a]] || awake_[layout_.patch_of[spring.b]];
            if (!listed) more_springs_.push_back({spring.level, k});
        }
        awake_[patch] = true;
        woken_.push_back(patch);
    }
    if (woken_.empty()) return woken_;
    std::ranges::sort(woken_);
    std::ranges::sort(more_springs_);
    merge_into(patches_, woken_, merged_patches_);
    merge_into(springs_, more_springs_, merged_springs_);
    return woken_;
}

void AwakePatches::let_sleep(std::span<const std::uint32_t> patches) {
    if (patches.empty()) return;
    for (const std::uint32_t patch : patches) awake_[patch] = false;
    std::erase_if(patches_, [&](std::uint32_t patch) { return !awake_[patch]; });
    std::erase_if(springs_, [&](const Turn& turn) {
        const auto& spring = layout_.springs[turn.spring];
        return !awake_[layout_.patch_of[spring.a]] && !awake_[layout_.patch_of[spring.b]];
    });
}

}  // namespace trocar
