#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

/// Everything of Trocar: a testbed of collision-handling strategies for surgery simulation.
/// Units throughout: millimetres, seconds, grams.
namespace trocar {

/// A point (mm) or a direction.
using Vec3 = Eigen::Vector3d;
/// A rotation, or a linear map.
using Mat3 = Eigen::Matrix3d;

/// Number of a vertex or of a facet, counted from 0.
using Index = std::int32_t;

/// The three vertices of a facet, counter-clockwise seen from outside.
using Facet = std::array<Index, 3>;

/// An axis-aligned box; `low` and `high` in mm. A fresh one is empty: it contains nothing.
struct Box {
    Vec3 low = Vec3::Constant(1e300);
    Vec3 high = Vec3::Constant(-1e300);

    void add(const Vec3& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    void add(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    [[nodiscard]] bool contains(const Vec3& point) const {
        return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
    }
    [[nodiscard]] bool overlaps(const Box& other) const {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
    /// Square of the distance (mm²) of a point; 0 for one in it.
    [[nodiscard]] double squared_distance(const Vec3& point) const {
        return (point - point.cwiseMax(low).cwiseMin(high)).squaredNorm();
    }
    /// The same box with every face moved out by `margin` (mm).
    [[nodiscard]] Box grown(double margin) const {
        return {low - Vec3::Constant(margin), high + Vec3::Constant(margin)};
    }
    [[nodiscard]] Vec3 size() const { return high - low; }
    [[nodiscard]] Vec3 centre() const { return (low + high) / 2; }
};

}  // namespace trocar
