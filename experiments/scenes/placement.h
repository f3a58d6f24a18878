#pragma once

#include "experiments/scenes/scene.h"

namespace trocar {

/// Where on an organ a scene may begin.
struct PlacementRule {
    double depth;       ///< mm that the tool goes below the surface
    bool thin = false;  ///< where the opposite wall is nearer than twice the depth, instead of not there
    double aside = 0;   ///< mm that the tool goes straight along the tangent
    double along = 0;   ///< mm that it goes along the surface (see surface_way)
};

/// Where the seed puts the tool: an entry point drawn uniformly by area (on a sheet by the area of its
/// outline, so that a seed is the same place on every sheet of that outline), at least two tool radii from
/// the boundary of an open organ, and so is the way aside. The inward ray leaves the organ no nearer than
/// twice the depth or, where the rule says thin, nearer. The normal is the mean_normal within two tool radii.
/// The tool, 3 mm clear along it, meets no other part of the organ. Where the rule has it go along the
/// surface, there is a surface_way, and each of its points is as the entry point has to be; besides, a tip at
/// the depth below it along its own normal is half the depth or more from all of the surface. Throws
/// PlacementError when 10,000 draws find no such point.
Placement place(const SceneInputs& inputs, const PlacementRule& rule);

/// The pose of a tool whose axis points along the placement's normal, tip at `tip`.
Pose upright_pose(const Placement& placement, const Vec3& tip);

/// Why the scene has no place on this organ with this tool, whatever the seed: the error of the inputs' seed,
/// when the next one finds no place either. Empty otherwise.
std::string unsuited(const SceneEntry& scene, SceneInputs inputs);

}  // namespace trocar
