#include "experiments/metrics/judge/judged_organ.h"

#include <set>

#include "experiments/metrics/self_crossing/self_intersections.h"

namespace trocar {
namespace {

std::vector<std::array<Index, 2>> border_of(std::span<const Facet> facets) {
    std::set<std::array<Index, 2>> edges;
    for (const auto& [a, b, c] : facets) edges.insert({{a, b}, {b, c}, {c, a}});
    std::vector<std::array<Index, 2>> border;
    for (const auto& [from, to] : edges) {
        if (!edges.contains({to, from})) border.push_back({from, to});
    }
    return border;
}

}  // namespace

JudgedOrgan::JudgedOrgan(const Organ& organ)
    : organ_(organ), vertex_normals_(organ.rest.positions.size(), Vec3::Zero()) {
    const std::vector<Vec3>& positions = organ.rest.positions;
    for (const auto& [a, b] : edges()) rest_lengths_.push_back((positions[b] - positions[a]).norm());
    for (const Facet& facet : facets()) {
        const Vec3 area_vector = facet_area_vector(positions, facet);
        for (const Index vertex : facet) vertex_normals_[vertex] += area_vector;
    }
    for (Vec3& normal : vertex_normals_) normal.stableNormalize();
    if (!organ.adjacency.closed()) border_ = border_of(facets());
}

JudgedOrgan::~JudgedOrgan() = default;

const SelfIntersections& JudgedOrgan::self_intersections() const {
    std::call_once(once_, [&] { self_intersections_ = std::make_unique<const SelfIntersections>(organ_); });
    return *self_intersections_;
}

}  // namespace trocar
