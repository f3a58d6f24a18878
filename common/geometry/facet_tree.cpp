#include "common/geometry/facet_tree.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace trocar {
namespace {

// Measured on a jaw of 952 facets: searches take as long with one or three, and longer with four.
constexpr std::size_t most_in_a_leaf = 2;
/// More facets are split into halves: a better cut would take long to find and gain little.
constexpr std::size_t most_to_weigh = 1024;
/// From this depth on all are, which ends soon whatever the facets are like.
constexpr std::size_t halves_from = 32;

Box box_of(const FacetTree::Item& item) {
    Box box;
    for (const Vec3& corner : item.corners) box.add(corner);
    return box;
}

/// Half of its surface, mm²: how likely a search is to meet it.
double half_area(const Box& box) {
    const Vec3 size = box.size();
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

void sort_along(std::span<FacetTree::Item> items, int axis) {
    std::ranges::sort(items, {}, [&](const FacetTree::Item& item) {
        const Box box = box_of(item);
        return std::tuple(box.low[axis] + box.high[axis], item.facet);
    });
}

/// Where to cut a row of facets in two.
struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    std::size_t left = 0;  ///< so many facets of those sorted along the axis
};

/// The cut that makes a search cheapest: both parts small, and few facets in what is large (the surface area
/// heuristic of Goldsmith and Salmon, 1987).
Cut best_cut(std::span<FacetTree::Item> items) {
    Cut best;
    std::vector<double> costs_to_the_right(items.size());
    for (int axis = 0; axis < 3; ++axis) {
        sort_along(items, axis);
        Box right;
        for (std::size_t k = items.size() - 1; k > 0; --k) {
            right.add(box_of(items[k]));
            costs_to_the_right[k] = half_area(right) * static_cast<double>(items.size() - k);
        }
        Box left;
        for (std::size_t k = 1; k < items.size(); ++k) {
            left.add(box_of(items[k - 1]));
            const double cost = half_area(left) * static_cast<double>(k) + costs_to_the_right[k];
            if (cost < best.cost) best = {cost, axis, k};
        }
    }
    return best;
}

Cut middle(std::span<const FacetTree::Item> items) {
    Box box;
    for (const FacetTree::Item& item : items) box.add(box_of(item));
    Cut cut{.left = items.size() / 2};
    box.size().maxCoeff(&cut.axis);
    return cut;
}

}  // namespace

class FacetTree::Builder {
  public:
    explicit Builder(FacetTree& tree) : tree_(tree) {}

    void fill(std::size_t node, std::span<Item> items, std::size_t depth) {
        Box box;
        for (const Item& item : items) box.add(box_of(item));
        tree_.nodes_[node].box = box;
        if (items.size() <= most_in_a_leaf) {
            tree_.nodes_[node].first = static_cast<Index>(items.data() - tree_.items_.data());
            tree_.nodes_[node].count = static_cast<Index>(items.size());
            return;
        }
        const bool weigh = items.size() <= most_to_weigh && depth < halves_from;
        const Cut cut = weigh ? best_cut(items) : middle(items);
        sort_along(items, cut.axis);
        const std::size_t first = tree_.nodes_.size();
        tree_.nodes_.resize(first + 2);
        tree_.nodes_[node].first = static_cast<Index>(first);
        fill(first, items.first(cut.left), depth + 1);
        fill(first + 1, items.subspan(cut.left), depth + 1);
    }

  private:
    FacetTree& tree_;
};

FacetTree::FacetTree(const SurfaceMesh& mesh) : nodes_(1) {
    if (mesh.facets.empty()) throw std::invalid_argument("a tree needs facets");
    const auto& p = mesh.positions;
    for (const auto& [a, b, c] : mesh.facets) {
        items_.push_back({{p[a], p[b], p[c]}, static_cast<Index>(items_.size())});
    }
    Builder(*this).fill(0, items_, 0);
}

}  // namespace trocar
