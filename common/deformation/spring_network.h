#pragma once

#include <vector>

#include "common/geometry/organ.h"

namespace trocar {

/// The organ's material and how it is integrated. Both stiffnesses belong to the material and not to the
/// mesh: a finer mesh of the same organ is as stiff. The defaults are a soft organ's, chosen by how it should
/// look and before any strategy was measured: a dent spreads over about √(edge_stiffness / rest_stiffness) =
/// 14 mm, and creeps back, without ringing, with a time constant of damping · density / rest_stiffness = 0.08
/// s.
struct SpringSettings {
    double density = 2e-3;        ///< mass of the surface per area, g/mm²
    double edge_stiffness = 2e4;  ///< of the spring along each edge, g/s² (= mN/m)
    double rest_stiffness = 100;  ///< of the springs to the rest shape, per area, g/(s²·mm²)
    double damping = 4000;        ///< rate at which the velocity of a free mass decays, 1/s
    int substeps = 10;            ///< of one step of the cycle
    /// Whether what lies still may sleep: only what moves, or is near something that does, is integrated.
    /// Without it every vertex is, in every step: the full simulation.
    bool sleep = true;
};

/// Point masses with springs between them and springs to their rest positions.
struct SpringNetwork {
    /// Between two vertices.
    struct Spring {
        Index a, b;
        double rest_length;  ///< mm
        double stiffness;    ///< g/s²
    };

    std::vector<Vec3> rest;              ///< mm
    std::vector<double> masses;          ///< g
    std::vector<double> rest_stiffness;  ///< of each vertex's spring to its rest position, g/s²
    std::vector<bool> fixed;             ///< vertices that stay at rest unless something moves them by force
    std::vector<Spring> springs;
    std::vector<std::vector<Index>> patches;  ///< vertices that fall asleep and wake together; those of none
                                              ///< are a patch of their own
};

/// The springs of an organ: one along every edge, one from every vertex to its rest position (surface springs
/// alone collapse; these stand for the organ's inside). A vertex has a third of its facets' area. The
/// boundary of an open surface is fixed. Throws std::invalid_argument for a density or stiffness that is not
/// positive.
SpringNetwork surface_springs(const Organ& organ, const SpringSettings& settings);

}  // namespace trocar
