#pragma once

#include "common/cycle/contact.h"
#include "strategies/options.h"

namespace trocar::fuzzy {

/// Below this length per facet, in mm per mm, vectors cancel and name no direction.
inline constexpr double no_direction = 1e-6;

/// Which normals of the organ's facets the inference is fed (◇).
enum class Normals {
    current,    ///< of the organ as the step found it
    reference,  ///< of the organ at rest
};

/// The option `normals` of both fuzzy strategies.
OptionSpec normals_option();
/// Its value.
Normals normals_of(const Options& resolved);

/// n_def of the paper: the outer unit normal of an organ facet; zero for a facet without area.
Vec3 organ_normal(const Contact& contact, Index facet, Normals normals);

/// I_C (eq. 1) of two vectors of unit length, in [−1, 1] whatever their last bits say.
double collision_index(const Vec3& motion, const Vec3& normal);

}  // namespace trocar::fuzzy
