#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "strategies/strategy.h"

namespace trocar {

/// A strategy that can be made: its description and how to make one from resolved options.
struct StrategyEntry {
    Description description;
    /// Makes an instance from options that resolve_options has checked and completed.
    std::unique_ptr<Strategy> (*make)(const Options& resolved);
};

/// Every strategy of this build, in the order in which they are listed to users.
const std::vector<StrategyEntry>& all_strategies();

/// The entry of that name. Throws std::invalid_argument, naming the nearest right name, when there is none.
const StrategyEntry& find_strategy(std::string_view name);

/// A strategy of that name; options not given have their defaults. Throws what find_strategy and
/// resolve_options throw.
std::unique_ptr<Strategy> make_strategy(std::string_view name, const Options& given = {});

}  // namespace trocar
