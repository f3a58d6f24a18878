#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "common/deformation/spring_layout.h"

namespace trocar {

/// Four numbers of a vertex that are worked on at once: x, y, z and one more.
struct alignas(32) Slot : Eigen::Vector4d {
    using Eigen::Vector4d::Vector4d;
    using Eigen::Vector4d::operator=;
};

/// The inner loops of the integrator. Where the processor has AVX2 they do four numbers at once, with the
/// same bits as elsewhere: the same operations, each rounded by itself.
struct SpringKernels {
    /// Moves both ends of springs that share no vertex, one after another (Macklin et al. 2019, eq. 7 of XPBD
    /// with a single iteration). @param positions of all slots: mm, and inverse masses in 1/g
    /// @param idle a slot of no vertex, without inverse mass
    void (*project)(std::span<const SpringLayout::Spring> springs, Slot* positions, std::uint32_t idle);

    /// Notes where the slots [begin, end) are and lets them go on: before = x, x += h (kept v).
    void (*predict)(Slot* positions, Slot* before, const Slot* velocities, std::uint32_t begin,
                    std::uint32_t end, double kept, double h);

    /// Pulls the slots [begin, end) their share of the way to rest and measures v = (x − before) / h.
    /// @returns the largest squared speed
    double (*pull_to_rest)(Slot* positions, const Slot* before, const Slot* rest, const double* shares,
                           Slot* velocities, std::uint32_t begin, std::uint32_t end, double h);
};

/// Those that this processor does fastest.
const SpringKernels& spring_kernels();

/// Those that every processor has.
const SpringKernels& plain_spring_kernels();

}  // namespace trocar
