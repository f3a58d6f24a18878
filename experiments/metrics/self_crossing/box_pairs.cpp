#include "experiments/metrics/self_crossing/box_pairs.h"

#include <CGAL/box_intersection_d.h>

namespace trocar {
namespace {

using CgalBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Index>;

std::vector<CgalBox> to_cgal(std::span<const Box> boxes) {
    std::vector<CgalBox> copies;
    copies.reserve(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        std::array<double, 3> low{}, high{};
        Eigen::Map<Vec3>(low.data()) = boxes[k].low;
        Eigen::Map<Vec3>(high.data()) = boxes[k].high;
        copies.emplace_back(low.data(), high.data(), static_cast<Index>(k));
    }
    return copies;
}

}  // namespace

std::vector<std::array<Index, 2>> box_pairs(std::span<const Box> one, std::span<const Box> other) {
    std::vector<CgalBox> ones = to_cgal(one), others = to_cgal(other);
    std::vector<std::array<Index, 2>> pairs;
    CGAL::box_intersection_d(ones.begin(), ones.end(), others.begin(), others.end(),
                             [&](const CgalBox& a, const CgalBox& b) {
                                 pairs.push_back({a.info(), b.info()});
                             });
    return pairs;
}

}  // namespace trocar
