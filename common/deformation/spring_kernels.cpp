#include "common/deformation/spring_kernels.h"

#include <algorithm>

#include "common/geometry/vector.h"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace trocar {
namespace {

using Spring = SpringLayout::Spring;

inline void project_one(const Spring& spring, Slot* positions) {
    Slot &a = positions[spring.a], &b = positions[spring.b];
    const double w_a = a[3], w_b = b[3];
    const Vec3 along = b.head<3>() - a.head<3>();
    const double length = along.norm();
    if (w_a + w_b == 0 || length == 0) return;
    const Vec3 pull = along * ((length - spring.rest_length) / (length * (w_a + w_b + spring.compliance)));
    a.head<3>() += w_a * pull;
    b.head<3>() -= w_b * pull;
}

void project(std::span<const Spring> springs, Slot* positions, std::uint32_t /*idle*/) {
    for (const Spring& spring : springs) project_one(spring, positions);
}

void predict(Slot* positions, Slot* before, const Slot* velocities, std::uint32_t begin, std::uint32_t end,
             double kept, double h) {
    for (std::uint32_t slot = begin; slot < end; ++slot) {
        before[slot] = positions[slot];
        positions[slot] += h * (kept * velocities[slot]);
    }
}

double pull_to_rest(Slot* positions, const Slot* before, const Slot* rest, const double* shares,
                    Slot* velocities, std::uint32_t begin, std::uint32_t end, double h) {
    double fastest = 0;
    for (std::uint32_t slot = begin; slot < end; ++slot) {
        positions[slot] += (rest[slot] - positions[slot]) * shares[slot];
        velocities[slot] = (positions[slot] - before[slot]) / h;
        fastest = std::max(fastest, velocities[slot].squaredNorm());
    }
    return fastest;
}

#ifdef __x86_64__
#define TROCAR_AVX2 __attribute__((target("avx2")))
// std::array would take the alignment from them.
// NOLINTBEGIN(modernize-avoid-c-arrays)

/// x, y, z and w of four slots, made of the slots themselves.
struct Transposed {
    __m256d x, y, z, w;
};

TROCAR_AVX2 inline Transposed transposed(const __m256d (&slot)[4]) {
    const __m256d xz_01 = _mm256_unpacklo_pd(slot[0], slot[1]), yw_01 = _mm256_unpackhi_pd(slot[0], slot[1]);
    const __m256d xz_23 = _mm256_unpacklo_pd(slot[2], slot[3]), yw_23 = _mm256_unpackhi_pd(slot[2], slot[3]);
    return {_mm256_permute2f128_pd(xz_01, xz_23, 0x20), _mm256_permute2f128_pd(yw_01, yw_23, 0x20),
            _mm256_permute2f128_pd(xz_01, xz_23, 0x31), _mm256_permute2f128_pd(yw_01, yw_23, 0x31)};
}

/// The fourth number of each of four slots.
TROCAR_AVX2 inline __m256d fourths(const __m256d (&slot)[4]) {
    const __m256d yw_01 = _mm256_unpackhi_pd(slot[0], slot[1]), yw_23 = _mm256_unpackhi_pd(slot[2], slot[3]);
    return _mm256_permute2f128_pd(yw_01, yw_23, 0x31);
}

/// Four springs that share no vertex: project_one of each.
TROCAR_AVX2 inline void project_four(const Spring* spring, Slot* positions) {
    __m256d a[4], b[4], along[4];
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
        a[k] = _mm256_load_pd(positions[spring[k].a].data());
        b[k] = _mm256_load_pd(positions[spring[k].b].data());
        along[k] = b[k] - a[k];
    }
    const Transposed d = transposed(along);
    const __m256d w_a = fourths(a), w_b = fourths(b);
    const __m256d rest_length = _mm256_set_pd(spring[3].rest_length, spring[2].rest_length,
                                              spring[1].rest_length, spring[0].rest_length);
    const __m256d compliance =
        _mm256_set_pd(spring[3].compliance, spring[2].compliance, spring[1].compliance, spring[0].compliance);
    const __m256d length = _mm256_sqrt_pd(d.x * d.x + d.y * d.y + d.z * d.z);
    const __m256d softness = w_a + w_b + compliance;
    const __m256d share = (length - rest_length) / (length * softness);
    // A spring without length has no direction. One between masses that do not move is multiplied by zero.
    const __m256d zero = _mm256_setzero_pd();
    const __m256d s = _mm256_and_pd(share, _mm256_cmp_pd(length, zero, _CMP_NEQ_UQ));
    alignas(32) double shares[4];
    _mm256_store_pd(shares, s);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
        const __m256d pull = _mm256_blend_pd(along[k], zero, 8) * _mm256_broadcast_sd(&shares[k]);
        const __m256d moves_a = _mm256_permute4x64_pd(a[k], 0xff),
                      moves_b = _mm256_permute4x64_pd(b[k], 0xff);
        _mm256_store_pd(positions[spring[k].a].data(), a[k] + moves_a * pull);
        _mm256_store_pd(positions[spring[k].b].data(), b[k] - moves_b * pull);
    }
}

/// What is left of a level is filled up with springs from the idle slot to itself, which do nothing: a spring
/// by itself would write its ends in pieces, and reading them as a whole soon after would stall.
TROCAR_AVX2 void project_avx2(std::span<const Spring> springs, Slot* positions, std::uint32_t idle) {
    const Spring* next = springs.data();
    const Spring* const end = next + springs.size();
    for (; end - next >= 4; next += 4) project_four(next, positions);
    if (next == end) return;
    const Spring none{.a = idle, .b = idle, .level = 0, .rest_length = 1, .compliance = 1};
    const Spring rest[4] = {next[0], next + 1 < end ? next[1] : none, next + 2 < end ? next[2] : none, none};
    project_four(rest, positions);
}

TROCAR_AVX2 void predict_avx2(Slot* positions, Slot* before, const Slot* velocities, std::uint32_t begin,
                              std::uint32_t end, double kept, double h) {
    const __m256d kept_4 = _mm256_set1_pd(kept), h_4 = _mm256_set1_pd(h);
    for (std::uint32_t slot = begin; slot < end; ++slot) {
        const __m256d x = _mm256_load_pd(positions[slot].data()), v = _mm256_load_pd(velocities[slot].data());
        _mm256_store_pd(before[slot].data(), x);
        _mm256_store_pd(positions[slot].data(), x + h_4 * (kept_4 * v));
    }
}

TROCAR_AVX2 double pull_to_rest_avx2(Slot* positions, const Slot* before, const Slot* rest,
                                     const double* shares, Slot* velocities, std::uint32_t begin,
                                     std::uint32_t end, double h) {
    const __m256d h_4 = _mm256_set1_pd(h);
    __m256d fastest = _mm256_setzero_pd();
    for (std::uint32_t slot = begin; slot < end; ++slot) {
        const __m256d x = _mm256_load_pd(positions[slot].data());
        const __m256d way = _mm256_load_pd(rest[slot].data()) - x;
        const __m256d there = x + way * _mm256_broadcast_sd(&shares[slot]);
        const __m256d v = (there - _mm256_load_pd(before[slot].data())) / h_4;
        _mm256_store_pd(positions[slot].data(), there);
        _mm256_store_pd(velocities[slot].data(), v);
        const __m256d squares = v * v;
        const __m256d pairs = squares + _mm256_permute_pd(squares, 5);
        const __m256d sums = pairs + _mm256_permute2f128_pd(pairs, pairs, 1);
        fastest = sums > fastest ? sums : fastest;
    }
    return _mm256_cvtsd_f64(fastest);
}
// NOLINTEND(modernize-avoid-c-arrays)
#endif

}  // namespace

const SpringKernels& plain_spring_kernels() {
    static const SpringKernels plain{project, predict, pull_to_rest};
    return plain;
}

const SpringKernels& spring_kernels() {
#ifdef __x86_64__
    static const SpringKernels avx2{project_avx2, predict_avx2, pull_to_rest_avx2};
    if (__builtin_cpu_supports("avx2")) return avx2;
#endif
    return plain_spring_kernels();
}

}  // namespace trocar
