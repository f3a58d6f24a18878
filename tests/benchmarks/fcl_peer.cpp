#include "tests/benchmarks/fcl_peer.h"

#include <chrono>
#include <set>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/math/bv/OBB.h>
#include <fcl/narrowphase/collision.h>

#include "common/tool/tool_shapes.h"

namespace trocar {

struct FclPeer::Model {
    fcl::BVHModel<fcl::OBBd> organ;
    fcl::Cylinderd cylinder{default_prism_radius, default_prism_length};
};

FclPeer::FclPeer(const Organ& organ) : model_(std::make_unique<Model>()) {
    std::vector<fcl::Triangle> facets;
    for (const auto& [a, b, c] : organ.rest.facets) facets.emplace_back(a, b, c);
    model_->organ.beginModel();
    model_->organ.addSubModel(organ.rest.positions, facets);
    model_->organ.endModel();
}
FclPeer::~FclPeer() = default;

FclPeer::Found FclPeer::detect(std::span<const Vec3> positions, const Pose& tool) {
    using Clock = std::chrono::steady_clock;
    using Nanoseconds = std::chrono::duration<double, std::nano>;
    fcl::BVHModel<fcl::OBBd>& organ = model_->organ;
    constexpr std::size_t all = 100'000;
    const fcl::CollisionRequestd request(all);
    fcl::CollisionResultd result;

    const auto start = Clock::now();
    organ.beginUpdateModel();
    for (const Vec3& position : positions) organ.updateVertex(position);
    organ.endUpdateModel(true, true);
    const auto refitted = Clock::now();
    fcl::Transform3d place = fcl::Transform3d::Identity();
    place.linear() = tool.rotation;
    place.translation() = tool.to_world({0, 0, default_prism_length / 2});
    fcl::collide(&organ, fcl::Transform3d::Identity(), &model_->cylinder, place, request, result);
    const auto end = Clock::now();

    std::set<std::intptr_t> facets;
    for (std::size_t k = 0; k < result.numContacts(); ++k) facets.insert(result.getContact(k).b1);
    return {.refit = Nanoseconds(refitted - start).count(),
            .collide = Nanoseconds(end - refitted).count(),
            .facets = facets.size()};
}

}  // namespace trocar
