#pragma once

#include <optional>

#include "experiments/metrics/judge/judged_tool.h"

namespace trocar {

/// What is known of a point's way through a tool so far.
struct Passage {
    std::optional<Vec3> entry;  ///< where it last went in, if it is still inside: the outer normal there
    bool went_in = false;       ///< it came from outside to inside
    bool crossed = false;       ///< when it last came out, that was opposite to a known entry: the outer
                                ///< normals there were more than 135° apart
};

/// The point goes straight from `from` to `to`, in the tool's frame. Which facets it meets, and whether it is
/// inside at both ends, is decided exactly. Between two meetings it is inside or outside all the way: as it
/// is midway. There, going in for less than 1e-9 mm, or less deep, is touching, and meetings that are no
/// further apart are one (with an edge or a corner). Of several facets that it meets at once it goes through
/// that which it meets most squarely.
void follow(const JudgedTool& tool, const Vec3& from, const Vec3& to, Passage& passage);

}  // namespace trocar
