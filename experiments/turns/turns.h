#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/sweep/sweep.h"
#include "experiments/turns/single_vertex.h"
#include "strategies/strategy.h"

namespace trocar {

/// How far the displacement of one vertex turns while what it depends on hardly changes; README.md of this
/// folder says how it is measured. Angles are in degrees; NaN where no two inputs could be compared.
struct Turns {
    std::string label;              ///< of the strategy
    std::uint64_t seed;             ///< of the vertex
    double largest_turn;            ///< for two motions at most 1° apart, without weak inputs
    double at;                      ///< where on the walk of motions, midway between the two
    double largest_turn_with_weak;  ///< the same with them
    std::int64_t weak;              ///< inputs left out, for their |d_i| was too short
    double largest_turn_at_switch;  ///< for two places between which the nearest tool face changes
    std::int64_t inputs;            ///< motions that were compared: answered, and not weak
};

/// |d_i| / |N(i)| of a strategy that has a d_i, for the vertex that collided.
using Strength = std::function<double(const Contact&)>;

/// |d_i| / |N(i)| below which an input is weak (claim C11).
inline constexpr double weak_strength = 0.1;

/// The turns of every strategy at the vertex of every seed, by strategy, then seed. The same input gives the
/// same bits. One instance of a strategy is asked everything of a seed, one input after another: of a
/// strategy that keeps state this measures what it remembers, too. Throws what make_strategy and the
/// strategies throw.
std::vector<Turns> measure_turns(std::span<const StrategyChoice> strategies,
                                 std::span<const std::uint64_t> seeds);

/// The turns of one strategy at one vertex; label and seed are left empty.
/// @param strength none for a strategy without d_i, of which no input is weak
Turns measure_turns_at(const turns::SingleVertex& vertex, Strategy& strategy, const Strength& strength);

/// Writes them as CSV, a column per member of Turns, in their order; numbers have 17 significant digits,
/// labels stand in quotes. The file appears when it is whole. Throws StoreError where it cannot be written.
void write_turns(const std::filesystem::path& file, const std::vector<Turns>& rows);

/// Where `trocar reproduce` leaves them: beside its result file.
std::filesystem::path turns_beside(const std::filesystem::path& results);

}  // namespace trocar
