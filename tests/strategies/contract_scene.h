#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "common/cycle/contact.h"
#include "common/detection/detector.h"
#include "strategies/options.h"

namespace trocar::contract {

/// A contact that owns its world, so that tests can turn it into another one.
struct Scene {
    std::shared_ptr<const Organ> organ;
    std::vector<Vec3> positions, velocities;
    std::shared_ptr<const Tool> tool;
    Pose before, after;
    double clearance = 0.01, dt = 1.0 / 30;
    Detected detected;

    /// Calls `use(contact)` with this scene as a strategy sees it.
    template <typename Use>
    auto with_contact(const Use& use) const {
        const PlacedTool placed(*tool, after);
        const ToolMotion motion(before, after);
        return use(Contact{.organ = *organ,
                           .positions = positions,
                           .velocities = velocities,
                           .tool = placed,
                           .motion = motion,
                           .collided = detected.collided,
                           .crossed = detected.crossed,
                           .near_vertices = detected.near_vertices,
                           .near_facets = detected.near_facets,
                           .clearance = clearance,
                           .dt = dt});
    }
};

/// What the registered strategy `name` answers to the scene.
Response answer_of(std::string_view name, const Scene& scene, const Options& options = {});

/// The whole scene moved rigidly.
Scene moved(const Scene& scene, const Pose& by);
/// Every length times `factor`, the clearance too.
Scene scaled(const Scene& scene, double factor);

/// The same scene with vertices (or facets) numbered anew; `number[old]` is the new number.
struct Renumbered {
    Scene scene;
    std::vector<Index> number;
};
Renumbered with_vertices_renumbered(const Scene& scene, std::uint64_t seed);
Renumbered with_facets_renumbered(const Scene& scene, std::uint64_t seed);

}  // namespace trocar::contract
