#include "strategies/fuzzy_per_vertex.h"

#include <iterator>
#include <optional>

#include "strategies/fuzzy/rules_option.h"
#include "strategies/fuzzy/vertex_inference.h"
#include "strategies/leave_tool.h"
#include "strategies/motion_vector.h"

namespace trocar {
namespace {

class FuzzyPerVertexStrategy final : public Strategy {
  public:
    FuzzyPerVertexStrategy(const fuzzy::RuleBase& rules, const fuzzy::VertexReading& reading,
                           Fallback fallback)
        : inference_(rules), reading_(reading), fallback_(fallback) {}

    [[nodiscard]] Promises promises() const override {
        // With feedback the ring's first facet decides, and the ring starts at the facet of lowest index.
        const bool order_matters = reading_.feedback || reading_.aggregate != fuzzy::Aggregate::sum;
        const bool clears = fallback_ == Fallback::nearest_face;
        return {.clears_convex_tools = clears,
                .clears_any_tool = clears,
                .facet_order_free = !order_matters || reading_.always_penetration};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            const auto motion = motion_vector(contact, contact.positions[vertex]);
            const auto direction = motion ? direction_of(contact, vertex, *motion) : std::nullopt;
            leave_tool(contact, vertex, direction, fallback_, response);
        }
    }

  private:
    std::optional<Vec3> direction_of(const Contact& contact, Index vertex, const Vec3& motion) {
        fuzzy::gather_facets(contact, vertex, motion, reading_, facets_);
        const Vec3 vector = fuzzy::vertex_vector(inference_, reading_, motion, facets_);
        return fuzzy::direction_of(vector, facets_.size());
    }

    fuzzy::Inference inference_;
    fuzzy::VertexReading reading_;
    Fallback fallback_;
    std::vector<fuzzy::FacetNormal> facets_;  // scratch
};

std::vector<OptionSpec> options() {
    std::vector<OptionSpec> all = fuzzy::vertex_reading_options();
    all.push_back(fuzzy::rules_option());
    all.push_back(fallback_option());
    return all;
}

}  // namespace

StrategyEntry fuzzy_per_vertex_entry() {
    return {
        .description =
            {.name = "fuzzy-per-vertex",
             .summary = "the paper's method: feedback fuzzy logic over the facets around each vertex",
             .reference = "García-Pérez et al. 2009, section IV, eqs. (1) and (2), Fig. 2, Table I (rebuilt)",
             .options = options()},
        .make = [](const Options& resolved) -> std::unique_ptr<Strategy> {
            return std::make_unique<FuzzyPerVertexStrategy>(
                fuzzy::rules_of(resolved), fuzzy::vertex_reading_of(resolved), fallback_of(resolved));
        }};
}

}  // namespace trocar
