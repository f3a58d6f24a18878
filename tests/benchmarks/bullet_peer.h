#pragma once

#include <memory>
#include <span>

#include "common/geometry/organ.h"
#include "common/tool/pose.h"
#include "experiments/scenes/scene.h"

namespace trocar {

/// Bullet's soft body as an organ, and a rigid cylinder that goes where it is told: what a simulation by
/// Bullet costs at its cheapest. A node at every vertex, a link along every edge, no pose matching, no
/// volume, no gravity; nodes against the cylinder by its signed distance field (SDF_RS). What holds the organ
/// in place are nodes without mass at the end away from the tool, as Bullet has no cheap springs to the rest
/// shape.
class BulletPeer {
  public:
    /// What changes the cost and not the work. The links are solved in the order in which they are kept.
    enum class Setup {
        in_order,  ///< links in the order of the organ's edges: neighbours lie close together in memory
        shuffled,  ///< links as btSoftBodyHelpers leaves them, in random order
        fresh,     ///< shuffled, and the distance field still empty: Bullet fills it where it is first asked
    };

    /// @param at where the tool goes in
    /// @param tool of the cylinder, its tip's centre at the origin
    BulletPeer(const Organ& organ, const Placement& at, const Pose& tool, int position_iterations,
               Setup setup);
    ~BulletPeer();
    BulletPeer(const BulletPeer&) = delete;
    BulletPeer& operator=(const BulletPeer&) = delete;

    /// Moves the cylinder there and makes one step of `dt` (s). Returns what the step took, ns.
    double step(const Pose& tool, double dt);

    /// Nodes that the last step found in contact with the cylinder.
    [[nodiscard]] std::size_t contacts() const;
    /// How far the deepest node is below its place at rest, along the entry's normal, mm.
    [[nodiscard]] double dent() const;

  private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace trocar
