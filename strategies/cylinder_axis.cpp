#include "strategies/cylinder_axis.h"

#include <Eigen/Geometry>

#include "strategies/negligible.h"

namespace trocar {
namespace {

class CylinderAxisStrategy final : public Strategy {
  public:
    [[nodiscard]] Promises promises() const override {
        return {.clears_convex_tools = true, .clears_any_tool = true, .facet_order_free = true};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            const AxisExit exit = leave_axis(contact, vertex);
            response.displacements.push_back({vertex, exit.displacement});
            if (exit.on_axis) ++response.fallbacks;
        }
    }
};

}  // namespace

AxisExit leave_axis(const Contact& contact, Index vertex) {
    const PlacedTool& tool = contact.tool;
    const Vec3& x = contact.positions[vertex];
    const Vec3 axis = tool.axis(), from_tip = x - tool.pose().position;
    const Vec3 offset = from_tip - axis.dot(from_tip) * axis;
    const double distance = offset.norm();
    const bool on_axis = distance <= negligible_length(contact);
    const Vec3 away =
        on_axis ? tool.pose().direction_to_world(tool.tool().axis.unitOrthogonal()) : Vec3(offset / distance);
    return {.displacement = tool.exit_distance(x, away, contact.clearance) * away, .on_axis = on_axis};
}

StrategyEntry cylinder_axis_entry() {
    return {.description = {.name = "cylinder-axis",
                            .summary = "each vertex orthogonally away from the tool's axis",
                            .reference = "García-Pérez et al. 2009, section III, of their [27]",
                            .options = {}},
            .make = [](const Options&) -> std::unique_ptr<Strategy> {
                return std::make_unique<CylinderAxisStrategy>();
            }};
}

}  // namespace trocar
