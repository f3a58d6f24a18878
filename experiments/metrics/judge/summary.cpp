#include "experiments/metrics/judge/summary.h"

#include <algorithm>
#include <numeric>

namespace trocar {

Measured mean_of(std::span<const double> values, Missing none) {
    if (values.empty()) return none;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Measured largest_of(std::span<const double> values, Missing none) {
    return values.empty() ? Measured(none) : std::ranges::max(values);
}

Measured least_of(std::span<const double> values, Missing none) {
    return values.empty() ? Measured(none) : std::ranges::min(values);
}

}  // namespace trocar
