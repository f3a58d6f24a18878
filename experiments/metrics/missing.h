#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace trocar {

/// Why a value does not exist.
enum class Missing : std::uint8_t {
    nothing,              ///< it does exist
    no_vertex_collided,   ///< no organ vertex was inside the tool before handling
    no_vertex_inside,     ///< no organ vertex is inside the tool
    no_vertex_moved,      ///< handling moved no vertex that is outside the tool now
    no_edge_collided,     ///< no edge has the collided ends that the metric needs
    motion_along_normal,  ///< at no collided vertex does the tool move sideways: it is still, or on the
                          ///< normal
    no_direction,         ///< handling moves no collided vertex often enough for two directions
    keeps_state,          ///< the strategy keeps state, so that asking it again would change it
    open_organ,           ///< the organ encloses no volume
    empty_region,         ///< no vertex of the organ at rest is near the tool's sweep
    too_early,            ///< there are no two steps before this one
    no_answer,            ///< the strategy gave no answer that is one
    not_sampled,          ///< this step was not judged: steps come faster than the judge looks
};

/// The words that are stored: "no vertex collided".
std::string_view missing_reason(Missing missing);

/// A metric's value, or why there is none.
struct Measured {
    // NOLINTBEGIN(google-explicit-constructor): a metric returns one or the other.
    Measured(double the_value) : value(the_value) {}
    Measured(Missing why) : missing(why) {}
    // NOLINTEND(google-explicit-constructor)

    double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN exactly where something is missing
    Missing missing = Missing::nothing;
};

}  // namespace trocar
