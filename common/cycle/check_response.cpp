#include "common/cycle/check_response.h"

#include <stdexcept>
#include <string>

namespace trocar {
namespace {

void demand_finite(const Vec3& value, Index vertex, const char* what) {
    if (value.allFinite()) return;
    throw std::runtime_error("the strategy answered a " + std::string(what) +
                             " that is not finite for vertex " + std::to_string(vertex));
}

bool exists(Index vertex, std::size_t vertices) {
    return vertex >= 0 && static_cast<std::size_t>(vertex) < vertices;
}

}  // namespace

template <typename Entry>
void ResponseCheck::demand_distinct_vertices(const std::vector<Entry>& entries, const char* what) {
    ++list_;
    for (const Entry& entry : entries) {
        if (!exists(entry.vertex, named_in_.size())) {
            throw std::runtime_error("the strategy answered a " + std::string(what) +
                                     " for a vertex that does not exist");
        }
        if (named_in_[entry.vertex] == list_) {
            throw std::runtime_error("the strategy answered more than one " + std::string(what) +
                                     " for vertex " + std::to_string(entry.vertex));
        }
        named_in_[entry.vertex] = list_;
    }
}

void ResponseCheck::check(const Response& response) {
    demand_distinct_vertices(response.displacements, "displacement");
    demand_distinct_vertices(response.forces, "force");
    for (const auto& [vertex, displacement] : response.displacements) {
        demand_finite(displacement, vertex, "displacement");
    }
    for (const auto& [vertex, force] : response.forces) demand_finite(force, vertex, "force");
    for (const auto& [vertex, point, normal] : response.half_spaces) {
        if (!exists(vertex, named_in_.size())) {
            throw std::runtime_error("the strategy answered a half-space for a vertex that does not exist");
        }
        demand_finite(point, vertex, "half-space");
        demand_finite(normal, vertex, "half-space");
    }
}

}  // namespace trocar
