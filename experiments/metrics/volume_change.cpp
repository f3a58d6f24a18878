#include <Eigen/Geometry>

#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {
namespace {

/// The volume that the organ's facets enclose, mm³, seen from one of its vertices: far from the origin of
/// the world the cones to it would be large and their sum small.
double volume(const JudgedOrgan& organ, const std::vector<Vec3>& positions) {
    const Vec3& origin = positions.front();
    double sixfold = 0;
    for (const auto& [a, b, c] : organ.facets()) {
        sixfold += (positions[a] - origin).dot((positions[b] - origin).cross(positions[c] - origin));
    }
    return sixfold / 6;
}

}  // namespace

Metric volume_change() {
    return {.name = "volume_change",
            .units = "1",
            .definition = "volume of the organ over its volume at rest - 1; closed organs",
            .better = "neither",
            .moments = {Moment::deformed},
            .value = [](const Judged& step, Moment moment) -> Measured {
                if (!step.organ().organ().adjacency.closed()) return Missing::open_organ;
                return volume(step.organ(), step.at(moment).positions()) /
                           volume(step.organ(), step.organ().rest().positions) -
                       1;
            }};
}

}  // namespace trocar::metrics
