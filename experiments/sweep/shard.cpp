#include "experiments/sweep/shard.h"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>

#include "experiments/input_error.h"

namespace trocar {
namespace {

/// How many cases each scene has, in the order of their first case.
std::vector<std::pair<std::string, std::size_t>> scene_sizes(const std::vector<CaseInputs>& cases) {
    std::map<std::string, std::size_t> rank;
    std::vector<std::pair<std::string, std::size_t>> sizes;
    for (const CaseInputs& inputs : cases) {
        const auto [known, is_new] = rank.try_emplace(inputs.scene_id, sizes.size());
        if (is_new) sizes.emplace_back(inputs.scene_id, 0);
        ++sizes[known->second].second;
    }
    return sizes;
}

/// Reads a whole number at the start of `text` and drops it there; 0 when there is none.
std::size_t take_number(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc() ? number : 0;
}

}  // namespace

Shard parse_shard(std::string_view text) {
    std::string_view rest = text;
    Shard shard;
    shard.number = take_number(rest);
    const bool slash = rest.starts_with('/');
    if (slash) rest.remove_prefix(1);
    shard.count = take_number(rest);
    if (!slash || !rest.empty() || shard.number < 1 || shard.number > shard.count) {
        throw InputError(fmt::format(
            "--shard {}: expected i/n with 1 ≤ i ≤ n, such as 2/3 for the second of three parts", text));
    }
    return shard;
}

std::vector<CaseInputs> in_shard(std::vector<CaseInputs> cases, Shard shard) {
    auto scenes = scene_sizes(cases);
    // The largest scenes first, each to the shard that has least so far.
    std::ranges::stable_sort(scenes, std::ranges::greater(), &std::pair<std::string, std::size_t>::second);
    std::map<std::string, std::size_t> shard_of;
    std::vector<std::size_t> load(std::min(shard.count, scenes.size()));
    for (const auto& [scene, size] : scenes) {
        const auto least = std::ranges::min_element(load);
        shard_of[scene] = static_cast<std::size_t>(least - load.begin()) + 1;
        *least += size;
    }
    std::erase_if(cases,
                  [&](const CaseInputs& inputs) { return shard_of.at(inputs.scene_id) != shard.number; });
    if (cases.empty()) {
        throw InputError(fmt::format(
            "--shard {}/{}: nothing is left for it: there are {} scenes, whose cases stay together; "
            "cut the sweep into at most {} shards",
            shard.number, shard.count, scenes.size(), scenes.size()));
    }
    return cases;
}

}  // namespace trocar
