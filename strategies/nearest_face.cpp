#include "strategies/nearest_face.h"

#include "strategies/negligible.h"

namespace trocar {
namespace {

class NearestFaceStrategy final : public Strategy {
  public:
    [[nodiscard]] Promises promises() const override {
        return {.clears_convex_tools = true, .clears_any_tool = true, .facet_order_free = true};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            response.displacements.push_back({vertex, nearest_face_displacement(contact, vertex)});
        }
    }
};

}  // namespace

Vec3 nearest_face_displacement(const Contact& contact, Index vertex) {
    const Vec3& x = contact.positions[vertex];
    if (contact.tool.convex()) {
        const NearestFace nearest = contact.tool.nearest_face(x);
        return (contact.clearance - nearest.signed_distance) * nearest.normal;
    }
    const SurfacePoint closest = contact.tool.closest(x);
    const Vec3 way = closest.position - x;
    const double distance = way.norm();
    const bool on_surface = distance <= negligible_length(contact);
    const Vec3 direction = on_surface ? closest.normal : Vec3(way / distance);
    return contact.tool.exit_distance(x, direction, contact.clearance) * direction;
}

StrategyEntry nearest_face_entry() {
    return {.description = {.name = "nearest-face",
                            .summary = "each vertex to the nearest face of the tool, by the shortest way",
                            .reference = "García-Pérez et al. 2009, section V and Fig. 5, of their [30]",
                            .options = {}},
            .make = [](const Options&) -> std::unique_ptr<Strategy> {
                return std::make_unique<NearestFaceStrategy>();
            }};
}

}  // namespace trocar
