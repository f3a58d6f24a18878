#include "strategies/nearest_face.h"

namespace trocar {
namespace {

class NearestFaceStrategy final : public Strategy {
  public:
    [[nodiscard]] Promises promises() const override {
        return {.clears_convex_tools = true, .facet_order_free = true};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            response.displacements.push_back({vertex, nearest_face_displacement(contact, vertex)});
        }
    }
};

}  // namespace

Vec3 nearest_face_displacement(const Contact& contact, Index vertex) {
    const NearestFace nearest = contact.tool.nearest_face(contact.positions[vertex]);
    return (contact.clearance - nearest.signed_distance) * nearest.normal;
}

StrategyEntry nearest_face_entry() {
    return {
        .description = {.name = "nearest-face",
                        .summary = "each vertex to the nearest face of the tool, along that face's normal",
                        .reference = "García-Pérez et al. 2009, section V and Fig. 5, of their [30]",
                        .options = {}},
        .make = [](const Options&) -> std::unique_ptr<Strategy> {
            return std::make_unique<NearestFaceStrategy>();
        }};
}

}  // namespace trocar
