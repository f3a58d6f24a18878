#include "strategies/tool_facet.h"

#include <optional>

#include "strategies/fuzzy/interaction.h"
#include "strategies/leave_tool.h"
#include "strategies/motion_vector.h"

namespace trocar {
namespace {

class ToolFacetStrategy final : public Strategy {
  public:
    explicit ToolFacetStrategy(Fallback fallback) : fallback_(fallback) {}

    [[nodiscard]] Promises promises() const override {
        const bool clears = fallback_ == Fallback::nearest_face;
        return {.clears_convex_tools = clears, .clears_any_tool = clears, .facet_order_free = true};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            leave_tool(contact, vertex, direction_of(contact, vertex), fallback_, response);
        }
    }

  private:
    static std::optional<Vec3> direction_of(const Contact& contact, Index vertex) {
        const Vec3& x = contact.positions[vertex];
        auto motion = motion_vector(contact, x);
        if (!motion) return std::nullopt;
        Vec3 normal = contact.tool.nearest_face(x).normal;
        const double along = motion->dot(normal);
        if (along > fuzzy::threshold) return motion;
        if (along < -fuzzy::threshold) return -*motion;
        return normal;
    }

    Fallback fallback_;
};

}  // namespace

StrategyEntry tool_facet_entry() {
    return {.description = {.name = "tool-facet",
                            .summary = "each vertex with the motion, against it, or along the nearest tool "
                                       "facet's normal",
                            .reference = "García-Pérez et al. 2009, section III and Fig. 6a, of their [15]",
                            .options = {fallback_option()}},
            .make = [](const Options& options) -> std::unique_ptr<Strategy> {
                return std::make_unique<ToolFacetStrategy>(fallback_of(options));
            }};
}

}  // namespace trocar
