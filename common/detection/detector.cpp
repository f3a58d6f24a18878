#include "common/detection/detector.h"

#include <algorithm>
#include <cmath>

#include "common/detection/patch_tree.h"
#include "common/geometry/number_lists.h"
#include "common/geometry/patches.h"

namespace trocar {
namespace {

Box world_box(const Box& in_tool, const Pose& pose) {
    Box box;
    for (int corner = 0; corner < 8; ++corner) {
        box.add(pose.to_world({(corner & 1) != 0 ? in_tool.high.x() : in_tool.low.x(),
                               (corner & 2) != 0 ? in_tool.high.y() : in_tool.low.y(),
                               (corner & 4) != 0 ? in_tool.high.z() : in_tool.low.z()}));
    }
    // From there a vertex is judged in the tool's frame: what rounding brings in there has to be in here.
    return box.grown(1e-9 * (1 + box.low.norm() + box.high.norm()));
}

/// Where the tool was and is in this step, in its own frame at the end of the step.
Box swept_box(const Tool& tool, const ToolMotion& motion) {
    Box swept = tool.solid.box();
    for (const Vec3& position : tool.mesh.positions) {
        swept.add(judged_position(motion.after(), motion.before().to_world(position)));
    }
    return swept;
}

/// For each patch those with a facet that has a vertex of it: their boxes follow it.
NumberLists users_of(const Organ& organ) {
    const std::vector<Index> patch_of = patch_of_vertices(organ.patches, organ.rest.positions.size());
    std::vector<std::vector<std::uint32_t>> users(organ.patches.size());
    for (std::uint32_t user = 0; user < organ.patches.size(); ++user) {
        for (const Index facet : organ.patches[user].facets) {
            for (const Index vertex : organ.rest.facets[facet]) {
                auto& of_patch = users[patch_of[vertex]];
                if (of_patch.empty() || of_patch.back() != user) of_patch.push_back(user);
            }
        }
    }
    NumberLists lists;
    for (const auto& of_patch : users) lists.add(of_patch);
    return lists;
}

/// The vertices of each patch's facets, each once.
NumberLists corners_of(const Organ& organ) {
    NumberLists lists;
    for (const Patch& patch : organ.patches) {
        std::vector<std::uint32_t> corners;
        for (const Index facet : patch.facets) {
            for (const Index vertex : organ.rest.facets[facet]) {
                corners.push_back(static_cast<std::uint32_t>(vertex));
            }
        }
        std::ranges::sort(corners);
        const auto repeated = std::ranges::unique(corners);
        corners.erase(repeated.begin(), repeated.end());
        lists.add(corners);
    }
    return lists;
}

Box box_around(std::span<const std::uint32_t> vertices, std::span<const Vec3> positions) {
    Box box;
    for (const std::uint32_t vertex : vertices) box.add(positions[vertex]);
    return box;
}

std::vector<Box> boxes_around(const NumberLists& corners, std::span<const Vec3> positions) {
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < corners.size(); ++k) boxes.push_back(box_around(corners[k], positions));
    return boxes;
}

}  // namespace

struct Detector::World {
    explicit World(const Organ& the_organ)
        : organ(the_organ),
          users(users_of(organ)),
          corners(corners_of(organ)),
          tree(boxes_around(corners, organ.rest.positions)),
          refitted_in(organ.patches.size(), 0),
          judged(organ.rest.positions.size()),
          judged_in(judged.size(), 0),
          inside(judged.size(), false) {
        near.reserve(organ.patches.size());
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
    NumberLists users;    // of each patch
    NumberLists corners;  // of each patch
    PatchTree tree;
    std::vector<std::uint64_t> refitted_in;
    std::uint64_t round = 0;  // of refitting
    std::vector<std::uint32_t> near;
    std::vector<Vec3> judged;
    std::vector<std::uint64_t> judged_in;  // the step in which `judged` was computed
    std::vector<bool> inside;              // of the vertices in C; all false between steps
    std::uint64_t step = 0;
};

Detector::Detector(const Organ& organ) : world_(std::make_unique<World>(organ)) {}
Detector::~Detector() = default;

void Detector::follow(std::span<const std::uint32_t> patches, std::span<const Vec3> positions) {
    World& world = *world_;
    ++world.round;
    for (const std::uint32_t patch : patches) {
        for (const std::uint32_t user : world.users[patch]) {
            if (world.refitted_in[user] == world.round) continue;
            world.refitted_in[user] = world.round;
            world.tree.set(user, box_around(world.corners[user], positions));
        }
    }
}

void Detector::follow_all(std::span<const Vec3> positions) {
    for (std::uint32_t k = 0; k < world_->corners.size(); ++k) {
        world_->tree.set(k, box_around(world_->corners[k], positions));
    }
}

void Detector::detect(std::span<const Vec3> positions, const Tool& tool, const ToolMotion& motion,
                      Detected& found) {
    found.clear();
    World& world = *world_;
    const Organ& organ = world.organ;
    ++world.step;
    const Pose& pose = motion.after();
    const Box swept = swept_box(tool, motion);
    world.near.clear();
    world.tree.find(world_box(swept, pose), world.near);

    for (const std::uint32_t patch : world.near) {
        for (const Index vertex : organ.patches[patch].vertices) {
            const Vec3& at = world.judge(vertex, pose, positions);
            if (!swept.contains(at)) continue;
            found.near_vertices.push_back(vertex);
            if (!tool.solid.contains(at)) continue;
            found.collided.push_back(vertex);
            world.inside[vertex] = true;
        }
    }
    for (const std::uint32_t patch : world.near) {
        for (const Index facet : organ.patches[patch].facets) {
            const auto [a, b, c] = organ.rest.facets[facet];
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
