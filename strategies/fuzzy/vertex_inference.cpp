#include "strategies/fuzzy/vertex_inference.h"

#include <algorithm>
#include <cmath>

namespace trocar::fuzzy {

std::vector<OptionSpec> vertex_reading_options() {
    return {{.name = "aggregate",
             .default_value = std::string("sum"),
             .summary = "how the facets' vectors make one: their sum, the last one, or the final weights "
                        "with the mean normal",
             .choices = {"sum", "last", "mean-normal"}},
            {.name = "feedback",
             .default_value = true,
             .summary = "whether a facet's weights depend on those of the facet before",
             .choices = {}},
            normals_option(),
            {.name = "order",
             .default_value = std::string("ring"),
             .summary = "facets counter-clockwise from the one of lowest index, or by |I_C|",
             .choices = {"ring", "strongest-first"}},
            {.name = "case",
             .default_value = std::string("inferred"),
             .summary = "the interaction case: inferred, or penetration always (Fig. 3c)",
             .choices = {"inferred", "penetration"}}};
}

VertexReading vertex_reading_of(const Options& resolved) {
    const std::string& aggregate = word(resolved, "aggregate");
    return {.aggregate = aggregate == "sum"    ? Aggregate::sum
                         : aggregate == "last" ? Aggregate::last
                                               : Aggregate::mean_normal,
            .order = word(resolved, "order") == "ring" ? Order::ring : Order::strongest_first,
            .normals = normals_of(resolved),
            .feedback = flag(resolved, "feedback"),
            .always_penetration = word(resolved, "case") == "penetration"};
}

void put_in_order(std::vector<FacetNormal>& facets, const Vec3& motion, const VertexReading& reading) {
    if (reading.order == Order::ring) return;
    const auto strength = [&](const FacetNormal& one) {
        return std::abs(collision_index(motion, one.normal));
    };
    // By insertion: a ring is short, and std::stable_sort asks for memory.
    for (auto next = facets.begin(); next != facets.end(); ++next) {
        const auto place =
            std::ranges::upper_bound(facets.begin(), next, strength(*next), std::ranges::greater{}, strength);
        std::rotate(place, next, next + 1);
    }
}

void gather_facets(const Contact& contact, Index vertex, const Vec3& motion, const VertexReading& reading,
                   std::vector<FacetNormal>& facets) {
    facets.clear();
    for (const Index facet : contact.organ.adjacency.ring(vertex)) {
        facets.push_back({facet, organ_normal(contact, facet, reading.normals)});
    }
    put_in_order(facets, motion, reading);
}

namespace {

Weights weigh(const Inference& inference, const VertexReading& reading, double index, const Weights& previous,
              bool first) {
    if (reading.always_penetration) return {.penetration = 1, .sliding = 0, .extraction = 0};
    return first ? inference.first(index) : inference.further(index, previous);
}

}  // namespace

Vec3 vertex_vector(const Inference& inference, const VertexReading& reading, const Vec3& motion,
                   std::span<const FacetNormal> facets, std::vector<FacetShare>* shares) {
    Vec3 sum = Vec3::Zero(), last = Vec3::Zero(), normals = Vec3::Zero();
    Weights weights;
    for (std::size_t k = 0; k < facets.size(); ++k) {
        const auto& [facet, normal] = facets[k];
        const bool first = k == 0 || !reading.feedback;
        const Weights previous = weights;
        const double index = collision_index(motion, normal);
        weights = weigh(inference, reading, index, previous, first);
        last = displacement(weights, motion, normal);
        sum += last;
        normals += normal;
        if (shares != nullptr) shares->push_back({facet, normal, index, first, previous, weights, last});
    }
    if (reading.aggregate == Aggregate::sum) return sum;
    if (reading.aggregate == Aggregate::last) return last;
    const double length = normals.norm();
    return displacement(weights, motion, length > 0 ? Vec3(normals / length) : Vec3(Vec3::Zero()));
}

std::optional<Vec3> direction_of(const Vec3& vector, std::size_t facets) {
    const double length = vector.norm();
    if (length == 0 || length < no_direction * static_cast<double>(facets)) return std::nullopt;
    return vector / length;
}

}  // namespace trocar::fuzzy
