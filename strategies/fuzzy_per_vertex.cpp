#include "strategies/fuzzy_per_vertex.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "strategies/fuzzy_reading.h"
#include "strategies/leave_tool.h"
#include "strategies/motion_vector.h"

namespace trocar {
namespace {

enum class Aggregate { sum, last, mean_normal };
enum class Order { ring, strongest_first };

struct Reading {
    Aggregate aggregate;
    bool feedback;
    fuzzy::Normals normals;
    fuzzy::Shape shape;
    Order order;
    bool always_penetration;  // I = (1, 0, 0): the paper's Fig. 3c
    Fallback fallback;
};

Reading reading_of(const Options& options) {
    const std::string& aggregate = word(options, "aggregate");
    return {.aggregate = aggregate == "sum"    ? Aggregate::sum
                         : aggregate == "last" ? Aggregate::last
                                               : Aggregate::mean_normal,
            .feedback = flag(options, "feedback"),
            .normals = fuzzy::normals_of(options),
            .shape = fuzzy::shape_of(options),
            .order = word(options, "order") == "ring" ? Order::ring : Order::strongest_first,
            .always_penetration = word(options, "case") == "penetration",
            .fallback = fallback_of(options)};
}

class FuzzyPerVertexStrategy final : public Strategy {
  public:
    explicit FuzzyPerVertexStrategy(const Reading& reading) : reading_(reading) {}

    [[nodiscard]] Promises promises() const override {
        // With feedback the ring's first facet decides, and the ring starts at the facet of lowest index.
        const bool order_matters = reading_.feedback || reading_.aggregate != Aggregate::sum;
        const bool clears = reading_.fallback == Fallback::nearest_face;
        return {.clears_convex_tools = clears,
                .clears_any_tool = clears,
                .facet_order_free = !order_matters || reading_.always_penetration};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            const auto motion = motion_vector(contact, contact.positions[vertex]);
            const auto direction = motion ? direction_of(contact, vertex, *motion) : std::nullopt;
            leave_tool(contact, vertex, direction, reading_.fallback, response);
        }
    }

  private:
    /// d_i / |d_i|; none where the facets' vectors cancel.
    std::optional<Vec3> direction_of(const Contact& contact, Index vertex, const Vec3& motion) {
        gather_normals(contact, vertex, motion);
        Vec3 total = Vec3::Zero(), last = Vec3::Zero(), normals = Vec3::Zero();
        fuzzy::Cases weights{};
        bool first = true;
        for (const Vec3& normal : normals_) {
            weights = weigh(motion.dot(normal), weights, first);
            last = fuzzy::displacement(weights, motion, normal);
            total += last;
            normals += normal;
            first = false;
        }
        if (reading_.aggregate == Aggregate::last) total = last;
        if (reading_.aggregate == Aggregate::mean_normal) {
            const double length = normals.norm();
            total = fuzzy::displacement(weights, motion,
                                        length > 0 ? Vec3(normals / length) : Vec3(Vec3::Zero()));
        }
        const double length = total.norm();
        if (length < fuzzy::no_direction * static_cast<double>(normals_.size()) || length == 0)
            return std::nullopt;
        return total / length;
    }

    /// n_ij of the facets around the vertex, in the order in which they are fed to the inference.
    void gather_normals(const Contact& contact, Index vertex, const Vec3& motion) {
        normals_.clear();
        for (const Index facet : contact.organ.adjacency.ring(vertex)) {
            normals_.push_back(fuzzy::organ_normal(contact, facet, reading_.normals));
        }
        if (reading_.order == Order::strongest_first) {
            std::ranges::stable_sort(normals_, std::ranges::greater{},
                                     [&](const Vec3& normal) { return std::abs(motion.dot(normal)); });
        }
    }

    [[nodiscard]] fuzzy::Cases weigh(double collision_index, const fuzzy::Cases& previous, bool first) const {
        if (reading_.always_penetration) return {.penetration = 1, .sliding = 0, .extraction = 0};
        if (first || !reading_.feedback) return fuzzy::first_pass(collision_index, reading_.shape);
        return fuzzy::feedback(collision_index, previous, reading_.shape);
    }

    Reading reading_;
    std::vector<Vec3> normals_;  // scratch
};

}  // namespace

StrategyEntry fuzzy_per_vertex_entry() {
    return {
        .description =
            {.name = "fuzzy-per-vertex",
             .summary = "the paper's method: feedback fuzzy logic over the facets around each vertex",
             .reference = "García-Pérez et al. 2009, section IV, eqs. (1) and (2), Fig. 2, Table I (rebuilt)",
             .options =
                 {{.name = "aggregate",
                   .default_value = std::string("sum"),
                   .summary =
                       "how the facets' vectors make one: their sum, the last one, or the final weights "
                       "with the mean normal",
                   .choices = {"sum", "last", "mean-normal"}},
                  {.name = "feedback",
                   .default_value = true,
                   .summary = "whether a facet's weights depend on those of the facet before",
                   .choices = {}},
                  fuzzy::memberships_option(),
                  fuzzy::normals_option(),
                  {.name = "order",
                   .default_value = std::string("ring"),
                   .summary = "facets counter-clockwise from the one of lowest index, or by |I_C|",
                   .choices = {"ring", "strongest-first"}},
                  {.name = "case",
                   .default_value = std::string("inferred"),
                   .summary = "the interaction case: inferred, or penetration always (Fig. 3c)",
                   .choices = {"inferred", "penetration"}},
                  fallback_option()}},
        .make = [](const Options& options) -> std::unique_ptr<Strategy> {
            return std::make_unique<FuzzyPerVertexStrategy>(reading_of(options));
        }};
}

}  // namespace trocar
