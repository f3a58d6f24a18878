#include "strategies/fuzzy_per_vertex.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "strategies/fuzzy_inference.h"
#include "strategies/nearest_face.h"

namespace trocar {
namespace {

/// Below this length per facet, in mm per mm, the facets' vectors cancel and name no direction (◇).
constexpr double no_direction = 1e-6;

/// Below this part of the clearance the tool's material at a vertex counts as not having moved.
constexpr double no_motion = 1e-6;

enum class Aggregate { sum, last, mean_normal };
enum class Normals { current, reference };
enum class Order { ring, strongest_first };

struct Reading {
    Aggregate aggregate;
    bool feedback;
    Normals normals;
    Order order;
    bool always_penetration;  // I = (1, 0, 0): the paper's Fig. 3c
};

Reading reading_of(const Options& options) {
    const std::string &aggregate = word(options, "aggregate"), &normals = word(options, "normals"),
                      &order = word(options, "order");
    return {.aggregate = aggregate == "sum"    ? Aggregate::sum
                         : aggregate == "last" ? Aggregate::last
                                               : Aggregate::mean_normal,
            .feedback = flag(options, "feedback"),
            .normals = normals == "current" ? Normals::current : Normals::reference,
            .order = order == "ring" ? Order::ring : Order::strongest_first,
            .always_penetration = word(options, "case") == "penetration"};
}

class FuzzyPerVertexStrategy final : public Strategy {
  public:
    explicit FuzzyPerVertexStrategy(const Reading& reading) : reading_(reading) {}

    [[nodiscard]] Promises promises() const override {
        // With feedback the ring's first facet decides, and the ring starts at the facet of lowest index.
        const bool order_matters = reading_.feedback || reading_.aggregate != Aggregate::sum;
        return {.clears_convex_tools = true,
                .clears_any_tool = true,
                .facet_order_free = !order_matters || reading_.always_penetration};
    }

    void handle(const Contact& contact, Response& response) override {
        for (const Index vertex : contact.collided) {
            const auto motion =
                contact.motion.direction_at(contact.positions[vertex], no_motion * contact.clearance);
            const auto direction = motion ? direction_of(contact, vertex, *motion) : std::nullopt;
            if (direction) {
                const double exit =
                    contact.tool.exit_distance(contact.positions[vertex], *direction, contact.clearance);
                response.displacements.push_back({vertex, exit * *direction});
            } else {
                response.displacements.push_back({vertex, nearest_face_displacement(contact, vertex)});
                ++response.fallbacks;
            }
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
            last = displacement(weights, motion, normal);
            total += last;
            normals += normal;
            first = false;
        }
        if (reading_.aggregate == Aggregate::last) total = last;
        if (reading_.aggregate == Aggregate::mean_normal) {
            const double length = normals.norm();
            total = displacement(weights, motion, length > 0 ? Vec3(normals / length) : Vec3(Vec3::Zero()));
        }
        const double length = total.norm();
        if (length < no_direction * static_cast<double>(normals_.size()) || length == 0) return std::nullopt;
        return total / length;
    }

    /// n_ij of the facets around the vertex, in the order in which they are fed to the inference.
    void gather_normals(const Contact& contact, Index vertex, const Vec3& motion) {
        normals_.clear();
        for (const Index facet : contact.organ.adjacency.ring(vertex)) {
            normals_.push_back(reading_.normals == Normals::reference
                                   ? contact.organ.rest_normals[facet]
                                   : facet_normal(contact.positions, contact.organ.rest.facets[facet]));
        }
        if (reading_.order == Order::strongest_first) {
            std::ranges::stable_sort(normals_, std::ranges::greater{},
                                     [&](const Vec3& normal) { return std::abs(motion.dot(normal)); });
        }
    }

    [[nodiscard]] fuzzy::Cases weigh(double collision_index, const fuzzy::Cases& previous, bool first) const {
        if (reading_.always_penetration) return {.penetration = 1, .sliding = 0, .extraction = 0};
        if (first || !reading_.feedback) return fuzzy::first_pass(collision_index);
        return fuzzy::feedback(collision_index, previous);
    }

    /// Eq. (2).
    static Vec3 displacement(const fuzzy::Cases& weights, const Vec3& motion, const Vec3& normal) {
        return weights.penetration * motion - weights.sliding * normal - weights.extraction * motion;
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
                  {.name = "normals",
                   .default_value = std::string("current"),
                   .summary = "facet normals of the organ as the step found it, or at rest",
                   .choices = {"current", "reference"}},
                  {.name = "order",
                   .default_value = std::string("ring"),
                   .summary = "facets counter-clockwise from the one of lowest index, or by |I_C|",
                   .choices = {"ring", "strongest-first"}},
                  {.name = "case",
                   .default_value = std::string("inferred"),
                   .summary = "the interaction case: inferred, or penetration always (Fig. 3c)",
                   .choices = {"inferred", "penetration"}}}},
        .make = [](const Options& options) -> std::unique_ptr<Strategy> {
            return std::make_unique<FuzzyPerVertexStrategy>(reading_of(options));
        }};
}

}  // namespace trocar
