#include "common/geometry/inside_test.h"

#include <algorithm>

namespace trocar {
namespace {

/// Sign for a turn_sign of zero: that for a point which is moved by an infinitely small step along the first
/// of the two other axes, and by one infinitely smaller still along the second. A ray from there never meets
/// an edge or a corner of the surface.
int moved_sign(const Vec3& a, const Vec3& b, int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (a[v] != b[v]) return a[v] > b[v] ? 1 : -1;
    if (a[u] != b[u]) return b[u] > a[u] ? 1 : -1;
    return 0;  // the edge is seen as a point
}

/// How a point lies to a triangle's edges, as they are seen along an axis.
struct Turns {
    Turns(const Corners& c, const Vec3& p, int axis) {
        for (int k = 0; k < 3; ++k) signs[k] = turn_sign(c[k], c[(k + 1) % 3], p, axis);
    }

    /// Whether the point is not in the triangle, edges and corners counted with it. Nothing is outside a
    /// triangle that is seen as a line, if it is on that line.
    [[nodiscard]] bool outside() const {
        const auto [least, most] = std::ranges::minmax(signs);
        return least < 0 && most > 0;
    }

    std::array<int, 3> signs{};
};

/// Counts how often the ray from a point along an axis meets the surface.
class Crossings {
  public:
    Crossings(const Vec3& point, int axis) : point_(point), axis_(axis) {}

    [[nodiscard]] bool point_is_inside() const { return odd_ && !on_surface_; }

    // A search of a FacetTree.
    [[nodiscard]] double key(const Box& box) const { return meets(box.low, box.high) ? 0 : 1; }
    [[nodiscard]] static double limit() { return 0; }
    void visit(const FacetTree::Item& item) {
        const Corners& c = item.corners;
        const Vec3 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]), high = c[0].cwiseMax(c[1]).cwiseMax(c[2]);
        if (!meets(low, high)) return;
        const Turns turns(c, point_, axis_);
        if (turns.outside()) return;
        const bool reached = point_[axis_] >= low[axis_];
        const int side = reached ? orientation_sign(c[0], c[1], c[2], point_) : 0;
        if (reached && side == 0) {
            on_surface_ = on_surface_ || is_on(c);
            return;
        }
        const int facing = facing_of(c, turns);
        // Where it faces along the ray, a point below it, or below all its corners, is behind it.
        if (facing != 0 && (!reached || side == -facing)) odd_ = !odd_;
    }

  private:
    [[nodiscard]] bool meets(const Vec3& low, const Vec3& high) const {
        const int u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
        return point_[u] >= low[u] && point_[u] <= high[u] && point_[v] >= low[v] && point_[v] <= high[v] &&
               point_[axis_] <= high[axis_];
    }

    /// Of a triangle in whose plane the point is.
    [[nodiscard]] bool is_on(const Corners& c) const {
        return !Turns(c, point_, 0).outside() && !Turns(c, point_, 1).outside() &&
               !Turns(c, point_, 2).outside();
    }

    /// +1 or −1 where the moved ray meets the triangle, as its outside faces along the ray or against it; 0
    /// where it does not.
    [[nodiscard]] int facing_of(const Corners& c, const Turns& turns) const {
        std::array<int, 3> signs = turns.signs;
        for (int k = 0; k < 3; ++k) {
            if (signs[k] == 0) signs[k] = moved_sign(c[k], c[(k + 1) % 3], axis_);
        }
        return signs[0] == signs[1] && signs[1] == signs[2] ? signs[0] : 0;
    }

    Vec3 point_;
    int axis_;
    bool odd_ = false, on_surface_ = false;
};

}  // namespace

bool is_inside(const FacetTree& tree, const Vec3& point) {
    int shortest = 0;
    tree.box().size().minCoeff(&shortest);
    Crossings crossings(point, shortest);
    tree.walk(crossings);
    return crossings.point_is_inside();
}

}  // namespace trocar
