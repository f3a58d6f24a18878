#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "common/geometry/organ_shapes/implicit_surface.h"
#include "common/geometry/organ_shapes/shapes.h"

namespace trocar {
namespace {

const Vec3 half_block(50, 50, 30);  // mm
constexpr double rounding = 10;     // mm, of the block's edges
constexpr double half_width = 1.5;  // mm, of the slit
constexpr double depth = 35;        // mm
constexpr double lip_rounding = 3;  // mm

double block(const Vec3& p) {
    const Vec3 q = p.cwiseAbs() - half_block + Vec3::Constant(rounding);
    return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0) - rounding;
}

// The slit lies in the plane x = 0, from the top down, with a round bottom.
double slit(const Vec3& p) {
    const double bottom = half_block.z() - depth + half_width;
    return std::hypot(p.x(), std::min(p.z() - bottom, 0.0)) - half_width;
}

double value(const Vec3& p) { return smooth_max(block(p), -slit(p), lip_rounding); }

// The bottom's lowest line and the lips, all around.
double crease(const Vec3& p) { return p.x() * (block(p) + slit(p)); }

// The block's surface as squares of a grid. Its vertices in the plane x = 0 are there twice where the slit
// is: those of the left half move to its left wall, those of the right half to its right wall.
class SlitBlock {
  public:
    SlitBlock() {
        for (const int half : {-1, 1}) {
            add_outside(half);
            add_wall(half);
        }
        mark_creases();
    }

    CoarseMesh take() { return std::move(coarse_); }

  private:
    using GridPoint = std::array<int, 3>;  // mm

    static constexpr int bottom_ = -5;  // z of the slit's bottom
    static constexpr std::array<int, 6> half_x_{0, 10, 20, 30, 40, 50};
    static constexpr std::array<int, 11> y_{-50, -40, -30, -20, -10, 0, 10, 20, 30, 40, 50};
    static constexpr std::array<int, 8> z_{-30, -22, -14, bottom_, 4, 13, 21, 30};

    Index vertex(const GridPoint& p, int half) {
        const bool in_slit = p[0] == 0 && p[2] > bottom_;
        const auto next = static_cast<Index>(coarse_.mesh.positions.size());
        const auto [known, is_new] = vertices_.try_emplace({p, in_slit ? half : 0}, next);
        if (is_new) coarse_.mesh.positions.emplace_back(in_slit ? half * half_width : p[0], p[1], p[2]);
        return known->second;
    }

    // Two facets between a and c, counter-clockwise seen from outside in the right half; the left half is its
    // mirror image.
    void add_square(const std::array<GridPoint, 4>& corners, int half) {
        std::array<Index, 4> v{};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& [x, y, z] = corners[half > 0 ? i : 3 - i];
            v[i] = vertex({half * x, y, z}, half);
        }
        coarse_.mesh.facets.push_back({v[0], v[1], v[2]});
        coarse_.mesh.facets.push_back({v[0], v[2], v[3]});
    }

    void add_outside(int half) {
        for (std::size_t i = 0; i + 1 < half_x_.size(); ++i) {
            const int x0 = half_x_[i], x1 = half_x_[i + 1];
            for (std::size_t j = 0; j + 1 < y_.size(); ++j) {
                const int y0 = y_[j], y1 = y_[j + 1], low = z_.front(), high = z_.back();
                add_square({{{x0, y0, high}, {x1, y0, high}, {x1, y1, high}, {x0, y1, high}}}, half);
                add_square({{{x0, y1, low}, {x1, y1, low}, {x1, y0, low}, {x0, y0, low}}}, half);
            }
            for (std::size_t k = 0; k + 1 < z_.size(); ++k) {
                const int z0 = z_[k], z1 = z_[k + 1], front = y_.front(), back = y_.back();
                add_square({{{x0, front, z0}, {x1, front, z0}, {x1, front, z1}, {x0, front, z1}}}, half);
                add_square({{{x0, back, z1}, {x1, back, z1}, {x1, back, z0}, {x0, back, z0}}}, half);
            }
        }
        add_side(half_x_.back(), z_.front(), half);
    }

    void add_wall(int half) { add_side(0, bottom_, half); }

    // The squares of a plane of that x from `lowest` up, facing away from the half's middle.
    void add_side(int x, int lowest, int half) {
        for (std::size_t j = 0; j + 1 < y_.size(); ++j) {
            for (std::size_t k = 0; k + 1 < z_.size(); ++k) {
                if (z_[k] < lowest) continue;
                std::array<GridPoint, 4> corners{{{x, y_[j], z_[k]},
                                                  {x, y_[j + 1], z_[k]},
                                                  {x, y_[j + 1], z_[k + 1]},
                                                  {x, y_[j], z_[k + 1]}}};
                if (x == 0) std::ranges::reverse(corners);
                add_square(corners, half);
            }
        }
    }

    void mark_creases() {
        const auto mark = [&](const GridPoint& a, const GridPoint& b, int half) {
            coarse_.creases.push_back({vertex(a, half), vertex(b, half)});
        };
        for (std::size_t j = 0; j + 1 < y_.size(); ++j) {
            mark({0, y_[j], bottom_}, {0, y_[j + 1], bottom_}, 0);
            for (const int half : {-1, 1}) mark({0, y_[j], z_.back()}, {0, y_[j + 1], z_.back()}, half);
        }
        for (std::size_t k = 0; k + 1 < z_.size(); ++k) {
            if (z_[k] < bottom_) continue;
            for (const int y : {y_.front(), y_.back()}) {
                for (const int half : {-1, 1}) mark({0, y, z_[k]}, {0, y, z_[k + 1]}, half);
            }
        }
    }

    std::map<std::pair<GridPoint, int>, Index> vertices_;
    CoarseMesh coarse_;
};

}  // namespace

Organ make_cleft(std::string name, double edge, double size) {
    const double scale = size / (2 * half_block.x());
    const ImplicitSurface surface{.value = value, .crease = crease};
    Organ organ = make_organ(std::move(name), mesh_surface(surface, SlitBlock().take(), edge, scale));
    organ.mouth = {.point = scale * half_block.z() * Vec3::UnitZ(),
                   .normal = Vec3::UnitZ(),
                   .along = Vec3::UnitY(),
                   .length = scale * 2 * (half_block.y() - rounding)};
    return organ;
}

}  // namespace trocar
