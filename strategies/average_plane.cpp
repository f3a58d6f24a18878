#include "strategies/average_plane.h"

#include <optional>

#include "strategies/cylinder_axis.h"
#include "strategies/nearest_face.h"

namespace trocar {
namespace {

/// A mean normal with less than this across the axis names no plane parallel to it.
constexpr double no_plane = 1e-3;

struct Reading {
    bool tangent;       // else the plane goes through the axis
    bool to_axis_exit;  // without a plane as cylinder-axis does, else as nearest-face does
};

class AveragePlaneStrategy final : public Strategy {
  public:
    explicit AveragePlaneStrategy(const Reading& reading) : reading_(reading) {}

    [[nodiscard]] Promises promises() const override {
        return {.clears_convex_tools = reading_.tangent,
                .clears_any_tool = reading_.tangent,
                .facet_order_free = true};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            response.displacements.push_back({vertex, displacement_of(contact, vertex, response)});
        }
    }

  private:
    [[nodiscard]] Vec3 displacement_of(const Contact& contact, Index vertex, Response& response) const {
        if (const auto normal = plane_normal(contact, vertex)) {
            return -distance_to_plane(contact, contact.positions[vertex], *normal) * *normal;
        }
        ++response.fallbacks;
        return reading_.to_axis_exit ? leave_axis(contact, vertex).displacement
                                     : nearest_face_displacement(contact, vertex);
    }

    /// m: the mean outer normal of the interpenetrated facets around the vertex, less its part along the
    /// axis, normalised. All facets around a collided vertex are interpenetrated, by definition.
    static std::optional<Vec3> plane_normal(const Contact& contact, Index vertex) {
        const auto ring = contact.organ.adjacency.ring(vertex);
        Vec3 sum = Vec3::Zero();
        for (const Index facet : ring) {
            sum += facet_normal(contact.positions, contact.organ.rest.facets[facet]);
        }
        const Vec3 axis = contact.tool.axis(), across = sum - axis.dot(sum) * axis;
        const double length = across.norm();
        if (length <= no_plane * static_cast<double>(ring.size())) return std::nullopt;
        return across / length;
    }

    /// How far `x` goes against the normal: to the clearance beyond the plane that touches the tool on the
    /// organ's side, or to the plane through the axis (negative on its other side).
    [[nodiscard]] double distance_to_plane(const Contact& contact, const Vec3& x, const Vec3& normal) const {
        if (!reading_.tangent) return normal.dot(x - contact.tool.pose().position);
        return normal.dot(x - contact.tool.support(-normal)) + contact.clearance;
    }

    Reading reading_;
};

}  // namespace

StrategyEntry average_plane_entry() {
    return {
        .description =
            {.name = "average-plane",
             .summary = "each vertex to a plane along the tool's axis that faces as the organ does there",
             .reference = "García-Pérez et al. 2009, section III, of their [30]",
             .options = {{.name = "plane",
                          .default_value = std::string("tangent"),
                          .summary = "the plane touches the tool on the organ's side, or goes through its "
                                     "axis (leaves vertices inside)",
                          .choices = {"tangent", "axis"}},
                         {.name = "fallback",
                          .default_value = std::string("cylinder-axis"),
                          .summary = "a vertex without a plane goes where this strategy sends it",
                          .choices = {"cylinder-axis", "nearest-face"}}}},
        .make = [](const Options& options) -> std::unique_ptr<Strategy> {
            return std::make_unique<AveragePlaneStrategy>(
                Reading{.tangent = word(options, "plane") == "tangent",
                        .to_axis_exit = word(options, "fallback") == "cylinder-axis"});
        }};
}

}  // namespace trocar
