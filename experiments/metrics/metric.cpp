#include "experiments/metrics/metric.h"

#include <algorithm>

#include "experiments/metrics/metric_list.h"

namespace trocar {

const std::vector<Metric>& all_metrics() {
    static const std::vector<Metric> metrics = {
        metrics::collided_vertices(), metrics::vertices_inside(), metrics::depth_max(),
        metrics::depth_mean(),        metrics::facets_crossing(), metrics::displacement_mean(),
        metrics::displacement_max(),  metrics::flipped_facets(),  metrics::fallbacks(),
    };
    return metrics;
}

std::string series_name(const Metric& metric, Moment moment) {
    if (metric.moments.size() == 1) return metric.name;
    return metric.name + (moment == Moment::deformed ? "_d" : "_h");
}

}  // namespace trocar
