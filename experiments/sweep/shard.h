#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/sweep/cases.h"

namespace trocar {

/// Part `number` (from 1) of `count` into which a sweep is cut, so that several machines can run it.
struct Shard {
    std::size_t number = 1;
    std::size_t count = 1;
};

/// Reads "2/3". Throws InputError for anything else.
Shard parse_shard(std::string_view text);

/// The cases of one shard, in their order. Cases of one scene stay together; otherwise all shards get as many
/// cases as can be. Every case is in exactly one shard. Throws InputError when there are fewer scenes than
/// shards and none is left for this one.
std::vector<CaseInputs> in_shard(std::vector<CaseInputs> cases, Shard shard);

}  // namespace trocar
