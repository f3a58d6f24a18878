#include "experiments/metrics/judge/judged.h"
#include "experiments/metrics/metric_list.h"

namespace trocar::metrics {

Metric flipped_facets() {
    return {.name = "flipped_facets",
            .units = "1",
            .definition = "organ facets whose normal handling turns by more than 90 degrees",
            .better = "low",
            .moments = {Moment::handled},
            .value = [](const Judged& step, Moment moment) -> Measured {
                const auto& before = step.at(Moment::before).positions();
                const auto& after = step.at(moment).positions();
                Index flipped = 0;
                for (const Facet& facet : step.organ().facets()) {
                    const double turned =
                        facet_area_vector(before, facet).dot(facet_area_vector(after, facet));
                    if (turned < 0) ++flipped;
                }
                return static_cast<double>(flipped);
            }};
}

}  // namespace trocar::metrics
