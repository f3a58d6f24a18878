#include "experiments/metrics/self_crossing/self_intersections.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

#include "experiments/metrics/self_crossing/box_pairs.h"
#include "experiments/metrics/self_crossing/facet_gap.h"

namespace trocar {
namespace {

bool share_vertex(const Facet& one, const Facet& other) {
    return std::ranges::any_of(one, [&](Index v) { return v == other[0] || v == other[1] || v == other[2]; });
}

Box box_of(std::span<const Vec3> positions, const Facet& facet) {
    const auto& [a, b, c] = facet;
    return {positions[a].cwiseMin(positions[b]).cwiseMin(positions[c]),
            positions[a].cwiseMax(positions[b]).cwiseMax(positions[c])};
}

/// What is true of some facets.
class FacetSet {
  public:
    explicit FacetSet(std::size_t count) : in_(count, 0) {}
    void add(Index facet) { in_[facet] = 1; }
    [[nodiscard]] std::vector<Index> ascending() const {
        std::vector<Index> all;
        for (std::size_t k = 0; k < in_.size(); ++k) {
            if (in_[k] != 0) all.push_back(static_cast<Index>(k));
        }
        return all;
    }

  private:
    std::vector<char> in_;
};

}  // namespace

SelfIntersections::SelfIntersections(const Organ& organ) : organ_(organ), cgal_(organ.rest), stars_(organ) {
    std::vector<Index> all(organ.rest.facets.size());
    std::iota(all.begin(), all.end(), 0);
    at_rest_ = cgal_.pairs(all, organ.rest.positions);
    find_freedom();
}

Corners SelfIntersections::corners(std::span<const Vec3> positions, Index facet) const {
    const auto& [a, b, c] = organ_.rest.facets[facet];
    return {positions[a], positions[b], positions[c]};
}

bool SelfIntersections::at_rest(Index one, Index other) const {
    return std::ranges::binary_search(at_rest_, FacetPair{std::min(one, other), std::max(one, other)});
}

void SelfIntersections::find_freedom() {
    const auto& [positions, facets] = organ_.rest;
    std::vector<double> of_star(positions.size(), 0);
    for (std::size_t k = 0; k < positions.size(); ++k) {
        const auto vertex = static_cast<Index>(k);
        if (!organ_.adjacency.ring(vertex).empty()) of_star[k] = stars_.freedom(vertex, positions);
    }
    std::vector<Box> boxes;
    for (const Facet& facet : facets) {
        const auto& [a, b, c] = facet;
        freedom_.push_back(std::min({of_star[a], of_star[b], of_star[c]}));
        boxes.push_back(box_of(positions, facet).grown(freedom_.back()));
    }
    for (const auto& [one, other] : box_pairs(boxes, boxes)) {
        if (one >= other || share_vertex(facets[one], facets[other]) || at_rest(one, other)) continue;
        const double wanted = freedom_[one] + freedom_[other];
        const double gap = facet_gap(corners(positions, one), corners(positions, other), wanted);
        if (gap >= wanted) continue;
        freedom_[one] = std::min(freedom_[one], gap / 2);
        freedom_[other] = std::min(freedom_[other], gap / 2);
    }
    constexpr double rounding = 1e-9;
    for (double& freedom : freedom_) freedom *= 1 - rounding;
}

std::vector<Index> SelfIntersections::moved(std::span<const Vec3> positions) const {
    std::vector<double> squares;
    squares.reserve(positions.size());
    for (std::size_t k = 0; k < positions.size(); ++k) {
        squares.push_back((positions[k] - organ_.rest.positions[k]).squaredNorm());
    }
    std::vector<Index> moved;
    for (std::size_t k = 0; k < freedom_.size(); ++k) {
        const auto& [a, b, c] = organ_.rest.facets[k];
        const double furthest = std::max({squares[a], squares[b], squares[c]});
        if (furthest >= freedom_[k] * freedom_[k]) moved.push_back(static_cast<Index>(k));
    }
    return moved;
}

std::vector<Index> SelfIntersections::doubtful(std::span<const Vec3> positions) const {
    const std::vector<Facet>& facets = organ_.rest.facets;
    FacetSet doubtful(facets.size());
    std::vector<char> star_seen(positions.size(), 0);
    Box around;
    std::vector<Box> moved_boxes;
    const std::vector<Index> moved = this->moved(positions);
    for (const Index facet : moved) {
        moved_boxes.push_back(box_of(positions, facets[facet]));
        around.add(moved_boxes.back());
        for (const Index vertex : facets[facet]) {
            if (star_seen[vertex] != 0) continue;
            star_seen[vertex] = 1;
            if (stars_.unfolding(vertex, positions)) continue;
            for (const Index of_star : organ_.adjacency.ring(vertex)) doubtful.add(of_star);
        }
    }
    std::vector<Index> near;
    std::vector<Box> near_boxes;
    for (std::size_t k = 0; k < facets.size(); ++k) {
        const Box box = box_of(positions, facets[k]);
        if (!box.overlaps(around)) continue;
        near.push_back(static_cast<Index>(k));
        near_boxes.push_back(box);
    }
    for (const auto& [i, j] : box_pairs(moved_boxes, near_boxes)) {
        const Index one = moved[i], other = near[j];
        if (share_vertex(facets[one], facets[other])) continue;
        if (shown_apart(corners(positions, one), corners(positions, other))) continue;
        doubtful.add(one);
        doubtful.add(other);
    }
    return doubtful.ascending();
}

std::vector<FacetPair> SelfIntersections::beyond_rest(std::span<const Vec3> positions) const {
    const std::vector<Index> facets = doubtful(positions);
    if (facets.empty()) return {};
    const std::vector<FacetPair> now = cgal_.pairs(facets, positions);
    std::vector<FacetPair> beyond;
    std::ranges::set_difference(now, at_rest_, std::back_inserter(beyond));
    return beyond;
}

}  // namespace trocar
