#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/predicates.h"
#include "common/geometry/surface_mesh.h"

namespace trocar {

/// The facets of a surface that does not move, in boxes within boxes; they and their corners lie in one array
/// in the order of the boxes. Searches ask for no memory, and several threads may search at once.
class FacetTree {
  public:
    /// A facet and where its corners are.
    struct Item {
        Corners corners;
        Index facet;
    };

    /// Keeps a copy of what it needs. Throws std::invalid_argument for a mesh without facets.
    explicit FacetTree(const SurfaceMesh& mesh);

    [[nodiscard]] const Box& box() const { return nodes_.front().box; }

    /// Shows a search the facets that may matter to it, those in nearer boxes first. The search has
    /// - `double key(const Box&) const`: at most the key of any facet in the box, such as its distance;
    /// - `double limit() const`: boxes with a greater key are left out; it may sink while the search goes on;
    /// - `void visit(const Item&)`: called for each facet of the boxes that are left.
    template <typename Search>
    void walk(Search& search) const;

  private:
    /// Two boxes lie side by side in nodes_, or some facets in items_.
    struct Node {
        Box box;
        Index first = 0;  ///< of the two, or of the facets
        Index count = 0;  ///< of the facets; 0 where there are boxes
    };
    /// Boxes within boxes, at most; see the constructor's split.
    static constexpr std::size_t deepest = 64;

    class Builder;

    std::vector<Node> nodes_;
    std::vector<Item> items_;
};

template <typename Search>
void FacetTree::walk(Search& search) const {
    struct Waiting {
        double key;
        Index node;
    };
    std::array<Waiting, deepest> waiting;  // set as far as `count`
    std::size_t count = 0;
    waiting[count++] = {search.key(nodes_.front().box), 0};
    while (count > 0) {
        const Waiting next = waiting[--count];
        if (!(next.key <= search.limit())) continue;
        const Node* node = &nodes_[next.node];
        while (node->count == 0) {
            Waiting near{search.key(nodes_[node->first].box), node->first};
            Waiting far{search.key(nodes_[node->first + 1].box), node->first + 1};
            if (far.key < near.key) std::swap(near, far);
            if (far.key <= search.limit()) waiting[count++] = far;
            if (!(near.key <= search.limit())) break;
            node = &nodes_[near.node];
        }
        for (const Item& item : std::span(items_).subspan(node->first, node->count)) search.visit(item);
    }
}

}  // namespace trocar
