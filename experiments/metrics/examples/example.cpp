#include "experiments/metrics/examples/example.h"

#include <numeric>
#include <stdexcept>

#include "common/nearest_name.h"
#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/judge/judge.h"

namespace trocar {

Example still_step(std::string metric, Moment moment, Organ organ, Tool tool, const Pose& pose) {
    std::vector<Vec3> rest = organ.rest.positions;
    std::vector<Index> all(rest.size());
    std::iota(all.begin(), all.end(), 0);
    return {.metric = std::move(metric),
            .moment = moment,
            .organ = std::move(organ),
            .tool = std::move(tool),
            .start = pose,
            .end = pose,
            .before = rest,
            .handled = rest,
            .deformed = rest,
            .region = std::move(all)};
}

Measured judge_example(const Example& example) {
    const JudgedOrgan organ(example.organ);
    const JudgedTool tool(example.tool);
    const bool first = example.two_before.empty();
    Judge judge(JudgedState(organ, tool, first ? example.before : example.two_before, example.start),
                {.metrics = choose_metrics(example.metric), .region = region_of(organ, example.region)});
    if (!first) {
        judge.before(example.two_before, example.start);
        judge.handled(example.two_before, 0);
        judge.deformed(example.before);
    }
    judge.before(example.before, example.end);
    judge.handled(example.handled, example.fallbacks);
    judge.deformed(example.deformed);
    return judge.settings().metrics.front()->value(judge.step(), example.moment);
}

const std::vector<Example>& all_examples() {
    static const std::vector<Example> all = {
        examples::collided_vertices(),
        examples::vertices_inside(),
        examples::depth_max(),
        examples::depth_mean(),
        examples::facets_crossing(),
        examples::tool_points_inside(),
        examples::tool_volume_inside(),
        examples::tunnelled(),
        examples::tool_crossings(),
        examples::displacement_crossings(),
        examples::flipped_facets(),
        examples::self_crossings(),
        examples::spread(),
        examples::edge_ratio_mean(),
        examples::edge_ratio_min(),
        examples::displacement_mean(),
        examples::displacement_max(),
        examples::gap_mean(),
        examples::gap_max(),
        examples::drag(),
        examples::strain(),
        examples::jitter(),
        examples::recovery(),
        examples::volume_change(),
        examples::fallbacks(),
    };
    return all;
}

const Example& find_example(const std::string& metric) {
    std::vector<std::string> names;
    for (const Example& example : all_examples()) {
        if (example.metric == metric) return example;
        names.push_back(example.metric);
    }
    throw std::invalid_argument(unknown_name("metric", metric, names));
}

}  // namespace trocar
