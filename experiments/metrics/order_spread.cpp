#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/judge/summary.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

using Directions = std::vector<Vec3>;

/// Between two unit vectors, degrees. Unlike the arc cosine of their product it is exact near 0 and 180.
double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// The largest angle between any two of them, degrees.
double widest_angle(const Directions& directions) {
    double widest = 0;
    for (std::size_t one = 0; one < directions.size(); ++one) {
        for (std::size_t other = 0; other < one; ++other) {
            widest = std::max(widest, angle_between(directions[one], directions[other]));
        }
    }
    return widest;
}

/// Where each vertex is sent, one unit vector for every facet at which its ring begins and which sends it
/// anywhere.
std::map<Index, Directions> directions_by_vertex(const Judged& step) {
    const Adjacency& around = step.organ().organ().adjacency;
    const auto& by_shift = step.shifted.displacements;
    std::map<Index, Directions> directions;
    for (std::size_t shift = 0; shift < by_shift.size(); ++shift) {
        for (const auto& [vertex, displacement] : by_shift[shift]) {
            // A shorter ring has been all around by now.
            if (shift >= around.ring(vertex).size() || displacement.isZero(0)) continue;
            directions[vertex].push_back(displacement.stableNormalized());
        }
    }
    return directions;
}

/// The order spread of each collided vertex that has one, degrees.
std::vector<double> spreads(const Judged& step) {
    std::map<Index, Directions> directions = directions_by_vertex(step);
    std::vector<double> spreads;
    for (const Index vertex : step.collided()) {
        const bool one_order_only = step.organ().organ().adjacency.ring(vertex).size() == 1;
        if (one_order_only || directions[vertex].size() > 1)
            spreads.push_back(widest_angle(directions[vertex]));
    }
    return spreads;
}

Measured summary_of_spreads(const Judged& step, Measured (*summary)(std::span<const double>, Missing)) {
    if (step.collided().empty()) return Missing::no_vertex_collided;
    if (step.shifted.missing != Missing::nothing) return step.shifted.missing;
    return summary(spreads(step), Missing::no_direction);
}

}  // namespace

Metric order_spread() {
    return {.name = "order_spread",
            .units = "degree",
            .definition =
                "largest angle, over the collided vertices, between any two directions in which the strategy "
                "sends a vertex when the ring of facets around it begins at each of them in turn",
            .better = "low",
            .moments = {Moment::handled},
            .cost = Cost::high,
            .of_shifts = true,
            .value = [](const Judged& step, Moment) { return summary_of_spreads(step, largest_of); }};
}

Metric order_spread_mean() {
    return {
        .name = "order_spread_mean",
        .units = "degree",
        .definition =
            "mean, over the collided vertices, of the largest angle between any two directions in which "
            "the strategy sends a vertex when the ring of facets around it begins at each of them in turn",
        .better = "low",
        .moments = {Moment::handled},
        .cost = Cost::high,
        .of_shifts = true,
        .value = [](const Judged& step, Moment) { return summary_of_spreads(step, mean_of); }};
}

}  // namespace trocar::metrics
