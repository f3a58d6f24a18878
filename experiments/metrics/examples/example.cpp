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
    judge.handled(example.handled, example.fallbacks, [&] { return example.shifted; });
    judge.deformed(example.deformed);
    return judge.settings().metrics.front()->value(judge.step(), example.moment);
}

const std::vector<Example>& all_examples() {
    static const std::vector<Example> all = {
#define TROCAR_METRIC(name) examples::name(),
#include "experiments/metrics/metrics.inc"
#undef TROCAR_METRIC
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
