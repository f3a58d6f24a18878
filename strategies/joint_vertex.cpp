#include "strategies/joint_vertex.h"

#include <algorithm>
#include <optional>

#include "strategies/fuzzy/inference.h"
#include "strategies/fuzzy/normals.h"
#include "strategies/fuzzy/rules_option.h"
#include "strategies/leave_tool.h"
#include "strategies/motion_vector.h"

namespace trocar {
namespace {

struct Reading {
    bool count_facets_once;  // else once for each collided vertex they have
    fuzzy::Normals normals;
    Fallback fallback;
};

class JointVertexStrategy final : public Strategy {
  public:
    JointVertexStrategy(const fuzzy::RuleBase& rules, const Reading& reading)
        : inference_(rules), reading_(reading) {}

    [[nodiscard]] Promises promises() const override {
        // One length for all: in a tool that is not convex it may carry a vertex from one part into another.
        return {.clears_convex_tools = reading_.fallback == Fallback::nearest_face, .facet_order_free = true};
    }

    void handle(const Contact& contact, Response& response) override {
        if (contact.collided.empty()) return;
        const auto direction = joint_direction(contact);
        if (!direction) {
            for (const Index vertex : contact.collided) {
                leave_tool(contact, vertex, std::nullopt, reading_.fallback, response);
            }
            return;
        }
        double furthest = 0;
        for (const Index vertex : contact.collided) {
            furthest = std::max(furthest, contact.tool.exit_distance(contact.positions[vertex], *direction,
                                                                     contact.clearance));
        }
        for (const Index vertex : contact.collided) {
            response.displacements.push_back({vertex, furthest * *direction});
        }
    }

  private:
    std::optional<Vec3> joint_direction(const Contact& contact) {
        const auto motion = motion_vector(contact, centroid(contact));
        const auto normal = motion ? mean_normal(contact) : std::nullopt;
        if (!normal) return std::nullopt;
        const fuzzy::Weights weights = inference_.first(fuzzy::collision_index(*motion, *normal));
        const Vec3 total = fuzzy::displacement(weights, *motion, *normal);
        const double length = total.norm();
        if (length < fuzzy::no_direction) return std::nullopt;
        return total / length;
    }

    /// Of the collided vertices. The tool's motion is an affine map, so its mean over them is that here.
    static Vec3 centroid(const Contact& contact) {
        Vec3 sum = Vec3::Zero();
        for (const Index vertex : contact.collided) sum += contact.positions[vertex];
        return sum / static_cast<double>(contact.collided.size());
    }

    /// The mean outer normal of the facets around all collided vertices, normalised; none where they cancel.
    std::optional<Vec3> mean_normal(const Contact& contact) {
        facets_.clear();
        for (const Index vertex : contact.collided) {
            const auto ring = contact.organ.adjacency.ring(vertex);
            facets_.insert(facets_.end(), ring.begin(), ring.end());
        }
        if (reading_.count_facets_once) {
            std::ranges::sort(facets_);
            const auto repeated = std::ranges::unique(facets_);
            facets_.erase(repeated.begin(), repeated.end());
        }
        Vec3 sum = Vec3::Zero();
        for (const Index facet : facets_) sum += fuzzy::organ_normal(contact, facet, reading_.normals);
        const double length = sum.norm();
        if (length <= fuzzy::no_direction * static_cast<double>(facets_.size())) return std::nullopt;
        return sum / length;
    }

    fuzzy::Inference inference_;
    Reading reading_;
    std::vector<Index> facets_;  // scratch
};

}  // namespace

StrategyEntry joint_vertex_entry() {
    return {
        .description = {.name = "joint-vertex",
                        .summary = "all vertices alike: the fuzzy inference once, one direction, one length",
                        .reference = "García-Pérez et al. 2009, section IV and Fig. 4",
                        .options = {{.name = "shared-facets",
                                     .default_value = std::string("once"),
                                     .summary =
                                         "how often the mean normal counts a facet of several collided "
                                         "vertices: once, or once for each",
                                     .choices = {"once", "each"}},
                                    fuzzy::normals_option(),
                                    fuzzy::rules_option(),
                                    fallback_option()}},
        .make = [](const Options& options) -> std::unique_ptr<Strategy> {
            return std::make_unique<JointVertexStrategy>(
                fuzzy::rules_of(options),
                Reading{.count_facets_once = word(options, "shared-facets") == "once",
                        .normals = fuzzy::normals_of(options),
                        .fallback = fallback_of(options)});
        }};
}

}  // namespace trocar
