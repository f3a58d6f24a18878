#include "experiments/cli/better_directions.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/metrics/metric.h"
#include "experiments/run/case_series.h"

namespace trocar {

std::string better_directions() {
    std::vector<std::string> words;
    for (const Metric& metric : all_metrics()) {
        words.push_back(fmt::format("{}={}", metric.name, metric.better));
    }
    for (const Series& time : empty_series({}).times) words.push_back(time.name + "=low");
    return fmt::format("{}", fmt::join(words, ","));
}

}  // namespace trocar
