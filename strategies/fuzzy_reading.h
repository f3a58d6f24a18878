#pragma once

#include "common/cycle/contact.h"
#include "strategies/fuzzy_inference.h"
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

/// The option `memberships` of both fuzzy strategies: the shape of Fig. 2a.
OptionSpec memberships_option();
/// Its value.
Shape shape_of(const Options& resolved);

}  // namespace trocar::fuzzy
