#include "experiments/metrics/metric.h"

#include <algorithm>
#include <ranges>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "common/nearest_name.h"
#include "experiments/metrics/metric_list.h"

namespace trocar {
namespace {

std::set<std::string> names_in(std::string_view choice) {
    std::vector<std::string> known;
    for (const Metric& metric : all_metrics()) known.push_back(metric.name);
    std::set<std::string> names;
    for (const auto part : std::views::split(choice, ',')) {
        const std::string name(part.begin(), part.end());
        if (std::ranges::find(known, name) == known.end()) {
            throw std::invalid_argument(unknown_name("metric", name, known));
        }
        names.insert(name);
    }
    return names;
}

}  // namespace

const std::vector<Metric>& all_metrics() {
    static const std::vector<Metric> metrics = {
#define TROCAR_METRIC(name) metrics::name(),
#include "experiments/metrics/metrics.inc"
#undef TROCAR_METRIC
    };
    return metrics;
}

std::vector<const Metric*> choose_metrics(std::string_view choice) {
    const bool all = choice == "all", fast = choice == "fast";
    if (choice.empty()) throw std::invalid_argument("no metric is named");
    const std::set<std::string> names = all || fast ? std::set<std::string>{} : names_in(choice);
    std::vector<const Metric*> chosen;
    for (const Metric& metric : all_metrics()) {
        if (all || (fast && metric.cost == Cost::low) || names.contains(metric.name)) {
            chosen.push_back(&metric);
        }
    }
    return chosen;
}

std::string series_name(const Metric& metric, Moment moment) {
    if (metric.moments.size() == 1) return metric.name;
    return metric.name + (moment == Moment::deformed ? "_d" : "_h");
}

}  // namespace trocar
