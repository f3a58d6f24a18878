#include "tests/benchmarks/bandwidth.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <benchmark/benchmark.h>
#include <unistd.h>

namespace trocar {

double last_cache() {
    constexpr double usual = 32e6;
    const long bytes = sysconf(_SC_LEVEL3_CACHE_SIZE);
    return bytes > 0 ? static_cast<double>(bytes) : usual;
}

double triad_bandwidth() {
    // Each array alone is twice the cache.
    const auto count = static_cast<std::size_t>(2 * last_cache() / sizeof(double));
    std::vector<double> a(count, 0.0), b(count, 1.0), c(count, 2.0);
    double best = 0;
    for (int k = 0; k < 10; ++k) {
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + 3 * c[i];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        best = std::max(best, 3 * sizeof(double) * static_cast<double>(count) / took.count());
    }
    return best;
}

double least_bytes(double moving_vertices, int substeps) {
    constexpr double number = 8;
    constexpr double vertex =
        number * (2 * 3 + 2 * 3 + 3 + 1 + 1);           // x and v both ways, rest, mass, stiffness
    constexpr double spring = 2 * number / 2 + number;  // two vertex numbers of 4 bytes, a length
    constexpr double springs_a_vertex = 3;
    const double once = moving_vertices * (vertex + springs_a_vertex * spring);
    return once <= last_cache() ? once : once * substeps;
}

}  // namespace trocar
