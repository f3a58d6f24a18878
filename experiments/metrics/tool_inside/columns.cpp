#include "experiments/metrics/tool_inside/columns.h"

#include <algorithm>
#include <numeric>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>

namespace trocar {
namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

int sign_of(double value) { return static_cast<int>(value > 0) - static_cast<int>(value < 0); }

/// On which side of the line from a to b the point is: +1 left, −1 right. A point on the line is moved by
/// (ε, ε²); 0 only where a = b.
int side(const Point& a, const Point& b, const Point& point) {
    if (const auto sign = CGAL::orientation(a, b, point); sign != CGAL::COLLINEAR) {
        return static_cast<int>(sign);
    }
    return a.y() != b.y() ? sign_of(a.y() - b.y()) : sign_of(b.x() - a.x());
}

/// Of the facet's plane at (x, y), no further up or down than the facet goes, mm.
double height(const Corners& facet, const Vec3& at) {
    const auto [low, high] = std::minmax({facet[0].z(), facet[1].z(), facet[2].z()});
    const Vec3 normal = (facet[1] - facet[0]).cross(facet[2] - facet[0]);
    if (normal.z() == 0) return high;  // upright but for rounding
    const double z = facet[0].z() - normal.head<2>().dot(at.head<2>() - facet[0].head<2>()) / normal.z();
    return std::clamp(z, low, high);
}

}  // namespace

void find_columns(std::span<const Vec3> points, const Corners& facet, std::vector<ColumnHit>& hits) {
    hits.clear();
    const auto x_of = [](const Vec3& point) { return point.x(); };
    const auto [low_x, high_x] = std::minmax({facet[0].x(), facet[1].x(), facet[2].x()});
    const auto [low_y, high_y] = std::minmax({facet[0].y(), facet[1].y(), facet[2].y()});
    const auto begin = std::ranges::lower_bound(points, low_x, {}, x_of);
    const auto end = std::ranges::upper_bound(points, high_x, {}, x_of);
    const Point a(facet[0].x(), facet[0].y()), b(facet[1].x(), facet[1].y()), c(facet[2].x(), facet[2].y());
    for (auto point = begin; point < end; ++point) {
        if (point->y() < low_y || point->y() > high_y) continue;
        const Point at(point->x(), point->y());
        const int sign = side(a, b, at);
        if (sign == 0 || side(b, c, at) != sign || side(c, a, at) != sign) continue;
        hits.push_back({static_cast<Index>(point - points.begin()), sign});
    }
}

Crossings::Crossings(std::span<const Vec3> points, std::span<const Corners> facets)
    : offsets_(points.size() + 1, 0) {
    struct Found {
        Index column;
        Crossing crossing;
    };
    std::vector<Found> found;
    std::vector<ColumnHit> hits;
    for (const Corners& facet : facets) {
        find_columns(points, facet, hits);
        for (const auto& [column, sign] : hits) {
            found.push_back({column, {height(facet, points[column]), sign}});
            ++offsets_[column + 1];
        }
    }
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    crossings_.resize(found.size());
    for (const auto& [column, crossing] : found) crossings_[next[column]++] = crossing;
    for (std::size_t column = 0; column < points.size(); ++column) {
        std::sort(crossings_.data() + offsets_[column], crossings_.data() + offsets_[column + 1],
                  [](const Crossing& one, const Crossing& other) { return one.z > other.z; });
    }
}

}  // namespace trocar
