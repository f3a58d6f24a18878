#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "common/geometry/organ.h"

namespace trocar {

class SelfIntersections;

/// What the metrics know of an organ at rest; prepared once, safe to share between threads.
class JudgedOrgan {
  public:
    /// The organ must outlive it.
    explicit JudgedOrgan(const Organ& organ);
    ~JudgedOrgan();
    JudgedOrgan(const JudgedOrgan&) = delete;
    JudgedOrgan& operator=(const JudgedOrgan&) = delete;

    [[nodiscard]] const Organ& organ() const { return organ_; }
    [[nodiscard]] const SurfaceMesh& rest() const { return organ_.rest; }
    [[nodiscard]] const std::vector<Facet>& facets() const { return organ_.rest.facets; }

    /// Every edge once, and the length of each at rest, mm.
    [[nodiscard]] std::span<const Edge> edges() const { return organ_.adjacency.edges(); }
    [[nodiscard]] const std::vector<double>& rest_lengths() const { return rest_lengths_; }

    /// Of each vertex at rest, outer, of unit length: the mean of its facets' normals by their areas.
    [[nodiscard]] const std::vector<Vec3>& vertex_normals() const { return vertex_normals_; }

    /// The edges of an open surface's border, each from vertex to vertex as its facet runs.
    [[nodiscard]] const std::vector<std::array<Index, 2>>& border() const { return border_; }
    /// Whether there is an inside: the organ is closed, or a sheet made by formula, whose inside is beneath
    /// it.
    [[nodiscard]] bool has_inside() const { return border_.empty() || organ_.outline; }
    /// Prepared when it is first asked for, which takes longer than all else.
    [[nodiscard]] const SelfIntersections& self_intersections() const;

  private:
    const Organ& organ_;
    std::vector<double> rest_lengths_;
    std::vector<Vec3> vertex_normals_;
    std::vector<std::array<Index, 2>> border_;
    mutable std::once_flag once_;
    mutable std::unique_ptr<const SelfIntersections> self_intersections_;
};

}  // namespace trocar
