#include "common/cycle/check_response.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

void demand_finite(const Vec3& value, Index vertex, const char* what) {
    if (value.allFinite()) return;
    throw std::runtime_error("the strategy answered a " + std::string(what) +
                             " that is not finite for vertex " + std::to_string(vertex));
}

/// Throws when a vertex of `entries` does not exist or is named twice.
template <typename Entry>
void demand_distinct_vertices(const std::vector<Entry>& entries, std::size_t vertex_count, const char* what) {
    std::vector<Index> vertices;
    for (const Entry& entry : entries) vertices.push_back(entry.vertex);
    std::ranges::sort(vertices);
    if (!vertices.empty() && (vertices.front() < 0 || vertices.back() >= static_cast<Index>(vertex_count))) {
        throw std::runtime_error("the strategy answered a " + std::string(what) +
                                 " for a vertex that does not exist");
    }
    const auto twice = std::ranges::adjacent_find(vertices);
    if (twice == vertices.end()) return;
    throw std::runtime_error("the strategy answered more than one " + std::string(what) + " for vertex " +
                             std::to_string(*twice));
}

}  // namespace

void check_response(const Response& response, std::size_t vertices) {
    demand_distinct_vertices(response.displacements, vertices, "displacement");
    demand_distinct_vertices(response.forces, vertices, "force");
    for (const auto& [vertex, displacement] : response.displacements) {
        demand_finite(displacement, vertex, "displacement");
    }
    for (const auto& [vertex, force] : response.forces) demand_finite(force, vertex, "force");
    for (const auto& [vertex, point, normal] : response.half_spaces) {
        if (vertex < 0 || vertex >= static_cast<Index>(vertices)) {
            throw std::runtime_error("the strategy answered a half-space for a vertex that does not exist");
        }
        demand_finite(point, vertex, "half-space");
        demand_finite(normal, vertex, "half-space");
    }
}

}  // namespace trocar
