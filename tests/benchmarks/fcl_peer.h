#pragma once

#include <memory>
#include <span>

#include "common/geometry/organ.h"
#include "common/tool/pose.h"

namespace trocar {

/// The organ as one model of FCL's, a tree of oriented boxes refitted from below, against a cylinder as wide
/// and long as prism-12.
class FclPeer {
  public:
    explicit FclPeer(const Organ& organ);
    ~FclPeer();
    FclPeer(const FclPeer&) = delete;
    FclPeer& operator=(const FclPeer&) = delete;

    /// How long each part took, ns, and how many of the organ's facets meet the cylinder.
    struct Found {
        double refit, collide;
        std::size_t facets;
    };
    /// Tells FCL where the vertices are, refits the whole model and asks for all contacts.
    Found detect(std::span<const Vec3> positions, const Pose& tool);

  private:
    struct Model;
    std::unique_ptr<Model> model_;
};

}  // namespace trocar
