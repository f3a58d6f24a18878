#include "experiments/turns/walks.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace trocar::turns {
namespace {

constexpr std::size_t steps_a_half_turn = 180 * steps_a_degree;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

std::vector<Vec3> shifted(const std::vector<Vec3>& positions, const Vec3& by) {
    std::vector<Vec3> result;
    result.reserve(positions.size());
    for (const Vec3& position : positions) result.emplace_back(position + by);
    return result;
}

}  // namespace

std::vector<Vec3> walk_of_motions(const SingleVertex& vertex) {
    const Vec3& first = vertex.first_motion;
    const Vec3 side = vertex.first_side, other_side = first.cross(side);
    std::vector<Vec3> motions;
    motions.reserve(half_turns * steps_a_half_turn + 1);
    for (std::size_t k = 0; k <= half_turns * steps_a_half_turn; ++k) {
        const std::size_t half_turn = k / steps_a_half_turn;
        const double gone = step * static_cast<double>(k % steps_a_half_turn);
        const double angle = radians(half_turn % 2 == 0 ? gone : 180 - gone);  // there, and back
        const double around = radians(360.0 / half_turns * static_cast<double>(half_turn));
        const Vec3 across = std::cos(around) * side + std::sin(around) * other_side;
        motions.emplace_back(std::cos(angle) * first + std::sin(angle) * across);
    }
    return motions;
}

std::vector<Switch> find_switches(const SingleVertex& vertex) {
    const std::vector<Vec3>& rest = vertex.organ.rest.positions;
    const PlacedTool tool(*vertex.tool, Pose{});
    const auto by = [&](int shifts) -> Vec3 { return shift * shifts * vertex.line; };
    int at = 0;
    while (tool.contains(rest[0] + by(at - 1))) --at;
    std::vector<Switch> switches;
    for (; tool.contains(rest[0] + by(at + 1)); ++at) {
        const Index here = tool.nearest_face(rest[0] + by(at)).face;
        const Index next = tool.nearest_face(rest[0] + by(at + 1)).face;
        if (here != next) switches.push_back({{shifted(rest, by(at)), shifted(rest, by(at + 1))}});
    }
    return switches;
}

}  // namespace trocar::turns
