#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/tool/tool_shapes.h"
#include "experiments/turns/single_vertex.h"

namespace trocar {

inline constexpr double degree = std::numbers::pi / 180;

/// The vertex of that seed in the tool that measure_turns takes.
inline turns::SingleVertex vertex_of(std::uint64_t seed) {
    static const auto tool = std::make_shared<const Tool>(make_prism(12));
    return turns::draw_single_vertex(tool, seed);
}

/// 1, 2, … last.
inline std::vector<std::uint64_t> seeds_to(std::uint64_t last) {
    std::vector<std::uint64_t> seeds;
    for (std::uint64_t seed = 1; seed <= last; ++seed) seeds.push_back(seed);
    return seeds;
}

/// Between unit vectors, degrees.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) / degree;
}

/// The unit vector at that angle from x towards y.
inline Vec3 turned(double degrees) { return {std::cos(degrees * degree), std::sin(degrees * degree), 0}; }

}  // namespace trocar
