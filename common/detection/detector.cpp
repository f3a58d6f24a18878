#include "common/detection/detector.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include "common/detection/patches.h"

namespace trocar {
namespace {

// Measured on 7,200 to 80,000 facets: refitting and colliding FCL's triangle trees costs more than looking at
// every facet of the few patches near the tool, so patches are as small as FCL's manager stays cheap.
constexpr std::size_t largest_patch = 128;

/// An FCL object that stands for a box in the world.
struct BoxObject {
    std::shared_ptr<fcl::Boxd> shape = std::make_shared<fcl::Boxd>(1, 1, 1);
    fcl::CollisionObjectd object{shape};

    void set(const Box& box) {
        shape->side = box.size();
        shape->computeLocalAABB();
        object.setTranslation(box.centre());
        object.computeAABB();
    }
};

Box world_box(const Box& in_tool, const Pose& pose) {
    Box box;
    for (int corner = 0; corner < 8; ++corner) {
        box.add(pose.to_world({(corner & 1) != 0 ? in_tool.high.x() : in_tool.low.x(),
                               (corner & 2) != 0 ? in_tool.high.y() : in_tool.low.y(),
                               (corner & 4) != 0 ? in_tool.high.z() : in_tool.low.z()}));
    }
    return box;
}

/// Where the tool was and is in this step, in its own frame at the end of the step.
Box swept_box(const Tool& tool, const ToolMotion& motion) {
    Box swept = tool.solid.box();
    for (const Vec3& position : tool.mesh.positions) {
        swept.add(judged_position(motion.after(), motion.before().to_world(position)));
    }
    return swept;
}

}  // namespace

struct Detector::World {
    World(const Organ& the_organ)
        : organ(the_organ),
          patches(split_into_patches(the_organ, largest_patch)),
          boxes(patches.size()),
          judged(the_organ.rest.positions.size()),
          judged_in(the_organ.rest.positions.size(), 0),
          inside(the_organ.rest.positions.size(), false) {
        for (std::size_t k = 0; k < patches.size(); ++k) {
            fit(k, organ.rest.positions);
            boxes[k].object.setUserData(&patches[k]);
            manager.registerObject(&boxes[k].object);
        }
        manager.setup();
    }

    void fit(std::size_t k, std::span<const Vec3> positions) {
        Box box;
        for (const Index facet : patches[k].facets) {
            for (const Index vertex : organ.rest.facets[facet]) box.add(positions[vertex]);
        }
        // FCL keeps a box as centre and sides, which rounds: the margin keeps every vertex in it.
        boxes[k].set(box.grown(1e-9 * (1 + box.low.norm() + box.high.norm())));
    }

    /// Patches whose box meets `box`, as FCL finds them.
    std::vector<const Patch*> patches_near(const Box& box) {
        BoxObject query;
        query.set(box);
        std::vector<const Patch*> near;
        manager.collide(
            &query.object, &near, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* found) {
                void* patch = a->getUserData() != nullptr ? a->getUserData() : b->getUserData();
                static_cast<std::vector<const Patch*>*>(found)->push_back(static_cast<const Patch*>(patch));
                return false;  // go on
            });
        return near;
    }

    /// A vertex in the tool's frame, computed once a step.
    const Vec3& judge(Index vertex, const Pose& pose, std::span<const Vec3> positions) {
        if (judged_in[vertex] != step) {
            judged_in[vertex] = step;
            judged[vertex] = judged_position(pose, positions[vertex]);
        }
        return judged[vertex];
    }

    const Organ& organ;
    std::vector<Patch> patches;
    std::deque<BoxObject> boxes;  // a deque: FCL keeps pointers to them
    fcl::DynamicAABBTreeCollisionManagerd manager;
    std::vector<Vec3> judged;
    std::vector<std::uint64_t> judged_in;  // the step in which `judged` was computed
    std::vector<bool> inside;              // of the vertices in C; all false between steps
    std::uint64_t step = 0;
};

Detector::Detector(const Organ& organ) : world_(std::make_unique<World>(organ)) {}
Detector::~Detector() = default;

void Detector::detect(std::span<const Vec3> positions, const Tool& tool, const ToolMotion& motion,
                      Detected& found) {
    found = {};
    World& world = *world_;
    ++world.step;
    for (std::size_t k = 0; k < world.patches.size(); ++k) world.fit(k, positions);
    world.manager.update();

    const Pose& pose = motion.after();
    const Box swept = swept_box(tool, motion);
    const std::vector<const Patch*> near = world.patches_near(world_box(swept, pose));

    for (const Patch* patch : near) {
        for (const Index vertex : patch->vertices) {
            const Vec3& at = world.judge(vertex, pose, positions);
            if (!swept.contains(at)) continue;
            found.near_vertices.push_back(vertex);
            if (!tool.solid.contains(at)) continue;
            found.collided.push_back(vertex);
            world.inside[vertex] = true;
        }
    }
    for (const Patch* patch : near) {
        for (const Index facet : patch->facets) {
            const auto [a, b, c] = world.organ.rest.facets[facet];
            const Vec3 &at_a = world.judge(a, pose, positions), &at_b = world.judge(b, pose, positions),
                       &at_c = world.judge(c, pose, positions);
            Box box;
            for (const Vec3* corner : {&at_a, &at_b, &at_c}) box.add(*corner);
            if (!box.overlaps(swept)) continue;
            found.near_facets.push_back(facet);
            if (!box.overlaps(tool.solid.box())) continue;
            const bool has_collided = world.inside[a] || world.inside[b] || world.inside[c];
            if (has_collided || tool.solid.crossed_by(at_a, at_b, at_c)) found.crossed.push_back(facet);
        }
    }
    for (const Index vertex : found.collided) world.inside[vertex] = false;
    for (auto* list : {&found.collided, &found.crossed, &found.near_vertices, &found.near_facets}) {
        std::ranges::sort(*list);
    }
}

}  // namespace trocar
