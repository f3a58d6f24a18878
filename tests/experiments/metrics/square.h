#pragma once

#include "common/tool/tool_shapes.h"
#include "judged_steps.h"

namespace trocar {

/// A square of two facets in the plane z = 0, its first edge from (−0.5, 0, 0) to (0.5, 0, 0), inside a tool
/// that holds all of it: every vertex is collided.
class Square {
  public:
    static constexpr Index a = 0, b = 1;  ///< the ends of the first edge

    /// The vertices a and b are put somewhere, the others stay.
    [[nodiscard]] Judged put(const Vec3& a_to, const Vec3& b_to) const {
        std::vector<Vec3> handled = steps_.rest();
        handled[a] = a_to;
        handled[b] = b_to;
        return steps_.step(tip_at(-20), steps_.rest(), handled, handled);
    }
    [[nodiscard]] Judged handled(const std::vector<Vec3>& positions) const {
        return steps_.step(tip_at(-20), steps_.rest(), positions, positions);
    }
    [[nodiscard]] const JudgedSteps& steps() const& { return steps_; }
    [[nodiscard]] JudgedSteps& steps() & { return steps_; }

  private:
    JudgedSteps steps_{
        make_organ("square", {.positions = {{-0.5, 0, 0}, {0.5, 0, 0}, {0.5, 1, 0}, {-0.5, 1, 0}},
                              .facets = {{0, 1, 2}, {0, 2, 3}}}),
        make_prism(4, 10, 40)};
};

}  // namespace trocar
