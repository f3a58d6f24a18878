#include "common/geometry/adjacency.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

// A facet as one of its vertices sees it: counter-clockwise it runs vertex, first, second.
struct Wedge {
    Index facet, first, second;
};

[[noreturn]] void fail_at_facet(std::size_t facet, const std::string& what) {
    throw std::invalid_argument("facet " + std::to_string(facet) + " " + what);
}

void check_facets(std::size_t vertex_count, std::span<const Facet> facets) {
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const auto [a, b, c] = facets[f];
        for (const Index vertex : facets[f]) {
            if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertex_count) {
                fail_at_facet(f, "names vertex " + std::to_string(vertex) + ", but there are " +
                                     std::to_string(vertex_count) + " vertices, counted from 0");
            }
        }
        if (a == b || b == c || c == a) fail_at_facet(f, "names a vertex twice");
    }
}

// Where each vertex's facets begin among all 3 × facet_count entries.
std::vector<Index> ring_offsets(std::size_t vertex_count, std::span<const Facet> facets) {
    std::vector<Index> offsets(vertex_count + 1, 0);
    for (const Facet& facet : facets) {
        for (const Index vertex : facet) ++offsets[vertex + 1];
    }
    for (std::size_t v = 0; v < vertex_count; ++v) offsets[v + 1] += offsets[v];
    return offsets;
}

// Every vertex's wedges, in the order of `offsets`, each vertex's by ascending facet.
std::vector<Wedge> gather_wedges(std::span<const Facet> facets, const std::vector<Index>& offsets) {
    std::vector<Wedge> wedges(3 * facets.size());
    std::vector<Index> next(offsets.begin(), offsets.end() - 1);
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const auto [a, b, c] = facets[f];
        const auto facet = static_cast<Index>(f);
        wedges[next[a]++] = {facet, b, c};
        wedges[next[b]++] = {facet, c, a};
        wedges[next[c]++] = {facet, a, b};
    }
    return wedges;
}

[[noreturn]] void fail_at_vertex(Index vertex) {
    throw std::invalid_argument("the facets around vertex " + std::to_string(vertex) +
                                " do not form one fan: the surface is not manifold or not consistently "
                                "oriented there");
}

// Puts one vertex's wedges counter-clockwise, an open fan from its boundary. Answers whether the fan is open.
bool order_fan(Index vertex, std::span<Wedge> fan, std::vector<Wedge>& by_first) {
    if (fan.empty()) return false;
    by_first.assign(fan.begin(), fan.end());
    std::ranges::sort(by_first, {}, &Wedge::first);
    if (std::ranges::adjacent_find(by_first, {}, &Wedge::first) != by_first.end()) fail_at_vertex(vertex);

    std::ranges::sort(fan, {}, &Wedge::second);
    if (std::ranges::adjacent_find(fan, {}, &Wedge::second) != fan.end()) fail_at_vertex(vertex);
    const auto opening = std::ranges::find_if(by_first, [&](const Wedge& wedge) {
        return !std::ranges::binary_search(fan, wedge.first, {}, &Wedge::second);
    });
    const bool open = opening != by_first.end();

    fan.front() = open ? *opening : by_first.front();
    for (std::size_t i = 1; i < fan.size(); ++i) {
        const auto next = std::ranges::lower_bound(by_first, fan[i - 1].second, {}, &Wedge::first);
        const bool found = next != by_first.end() && next->first == fan[i - 1].second;
        if (!found || next->facet == fan.front().facet) fail_at_vertex(vertex);
        fan[i] = *next;
    }
    return open;
}

}  // namespace

Adjacency::Adjacency(std::size_t vertex_count, std::span<const Facet> facets)
    : neighbour_offsets_{0}, on_boundary_(vertex_count, false) {
    check_facets(vertex_count, facets);
    ring_offsets_ = ring_offsets(vertex_count, facets);
    std::vector<Wedge> wedges = gather_wedges(facets, ring_offsets_);

    ring_facets_.reserve(wedges.size());
    neighbours_.reserve(wedges.size());
    neighbour_offsets_.reserve(vertex_count + 1);
    edges_.reserve(wedges.size() / 2);
    std::vector<Wedge> scratch;
    for (Index vertex = 0; static_cast<std::size_t>(vertex) < vertex_count; ++vertex) {
        const std::span fan(wedges.begin() + ring_offsets_[vertex],
                            wedges.begin() + ring_offsets_[vertex + 1]);
        const bool open = order_fan(vertex, fan, scratch);
        on_boundary_[vertex] = open;
        closed_ = closed_ && !open;

        const auto first_neighbour = static_cast<std::ptrdiff_t>(neighbours_.size());
        for (const Wedge& wedge : fan) neighbours_.push_back(wedge.first);
        if (open) neighbours_.push_back(fan.back().second);
        std::sort(neighbours_.begin() + first_neighbour, neighbours_.end());
        neighbour_offsets_.push_back(static_cast<Index>(neighbours_.size()));
        for (const Index neighbour : neighbours(vertex)) {
            if (vertex < neighbour) edges_.push_back({vertex, neighbour});
        }

        std::rotate(fan.begin(), std::ranges::min_element(fan, {}, &Wedge::facet), fan.end());
        for (const Wedge& wedge : fan) ring_facets_.push_back(wedge.facet);
    }
}

void Adjacency::begin_ring_at(Index vertex, Index facet) {
    const std::span fan(ring_facets_.begin() + ring_offsets_[vertex],
                        ring_facets_.begin() + ring_offsets_[vertex + 1]);
    const auto found = std::ranges::find(fan, facet);
    if (found == fan.end()) fail_at_facet(facet, "is not around vertex " + std::to_string(vertex));
    std::ranges::rotate(fan, found);
}

}  // namespace trocar
