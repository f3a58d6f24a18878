#pragma once

#include <optional>
#include <span>
#include <vector>

#include "strategies/fuzzy/inference.h"
#include "strategies/fuzzy/normals.h"
#include "strategies/options.h"

namespace trocar::fuzzy {

/// How the facets' vectors make one (◇).
enum class Aggregate {
    sum,          ///< their sum
    last,         ///< the last facet's vector alone
    mean_normal,  ///< eq. (2) of the last facet's weights and the mean normal
};

/// In which order the facets of a ring are fed to the inference (◇).
enum class Order {
    ring,             ///< counter-clockwise, from the incident facet of lowest index
    strongest_first,  ///< by |I_C|, ties as in the ring
};

/// How the paper is read where a vertex is concerned; every ◇ of fuzzy_per_vertex.md but the rule base.
struct VertexReading {
    Aggregate aggregate = Aggregate::sum;
    Order order = Order::ring;
    Normals normals = Normals::current;
    bool feedback = true;             ///< otherwise every facet is treated as the first
    bool always_penetration = false;  ///< I = (1, 0, 0): the paper's Fig. 3c
};

/// The options that make a VertexReading.
std::vector<OptionSpec> vertex_reading_options();
/// Their values.
VertexReading vertex_reading_of(const Options& resolved);

/// A facet around a vertex and its outer unit normal.
struct FacetNormal {
    Index facet;
    Vec3 normal;
};

/// What one facet adds to a vertex's vector.
struct FacetShare {
    Index facet;
    Vec3 normal;
    double collision_index;  ///< I_C
    bool first;              ///< C_1 is YES
    Weights previous;        ///< I before it
    Weights weights;         ///< I from it
    Vec3 vector;             ///< eq. (2)
};

/// Brings the facets of a ring into the reading's order.
void put_in_order(std::vector<FacetNormal>& facets, const Vec3& motion, const VertexReading& reading);

/// N(i) with the normals that the reading takes, in its order, into `facets`.
void gather_facets(const Contact& contact, Index vertex, const Vec3& motion, const VertexReading& reading,
                   std::vector<FacetNormal>& facets);

/// d_i of a vertex: what eq. (2) makes of the facets around it, in the order given.
/// @param motion v_m, of unit length
/// @param shares where not null, gets what every facet adds
Vec3 vertex_vector(const Inference& inference, const VertexReading& reading, const Vec3& motion,
                   std::span<const FacetNormal> facets, std::vector<FacetShare>* shares = nullptr);

/// d_i / |d_i|; none where the vectors of so many facets cancel.
std::optional<Vec3> direction_of(const Vec3& vector, std::size_t facets);

}  // namespace trocar::fuzzy
