#pragma once

#include <memory>
#include <random>
#include <vector>

#include "common/cycle/contact.h"
#include "common/detection/detector.h"

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

/// A prism pushed some way into a dented sphere, or into a sheet, turning a little as it moves. The same for
/// the same seed. Some vertex is collided.
Scene random_scene(std::uint64_t seed);

/// A tool beside the organ, moving: nothing collided.
Scene scene_without_contact();

/// Degenerate scenes, each with a name for messages.
struct NamedScene {
    const char* name;
    Scene scene;
};
std::vector<NamedScene> degenerate_scenes();

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
