#pragma once

#include <rapidcheck.h>

#include "common/geometry/vector.h"

namespace trocar::testing_support {

/// A number of RapidCheck's, uniform over [low, high] from the first case on (its own ranges grow with the
/// case).
inline double random_number(double low, double high) {
    constexpr int steps = 1'000'000;
    const int k = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, steps + 1));
    return low + (high - low) * k / steps;
}

inline Vec3 random_point(const Box& box) {
    Vec3 point;
    for (int k = 0; k < 3; ++k) point[k] = random_number(box.low[k], box.high[k]);
    return point;
}

/// Unit vector.
inline Vec3 random_direction() {
    Vec3 direction;
    do {
        direction = random_point({Vec3::Constant(-1), Vec3::Constant(1)});
    } while (direction.norm() < 0.1 || direction.norm() > 1);
    return direction.normalized();
}

}  // namespace trocar::testing_support
