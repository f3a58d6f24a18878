#pragma once

#include <span>
#include <vector>

#include "common/tool/tool.h"
#include "experiments/metrics/judge/judged_organ.h"

namespace trocar {

/// The fixed region of a scene: the part of the organ that the tool comes near, the same for all strategies.
struct Region {
    std::vector<Index> vertices;  ///< ascending
    std::vector<Index> edges;     ///< numbers of the organ's edges that have both ends among them, ascending
};

/// The region of these vertices (ascending).
Region region_of(const JudgedOrgan& organ, std::vector<Index> vertices);

/// The vertices of the organ at rest that come within two tool radii of the tool, or inside it, while it goes
/// from `start` through these poses. Between two poses, where its tip goes straight and it turns evenly, it
/// is looked at as often as it takes for none of its points to go further than a quarter of its radius.
std::vector<Index> vertices_near_sweep(const Organ& organ, const Tool& tool, const Pose& start,
                                       std::span<const Pose> poses);

}  // namespace trocar
