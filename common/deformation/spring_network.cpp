#include "common/deformation/spring_network.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

void demand_positive(double value, const char* what) {
    if (value > 0 && std::isfinite(value)) return;
    throw std::invalid_argument(std::string(what) + " must be a positive number, not " +
                                std::to_string(value));
}

std::vector<double> vertex_areas(const Organ& organ) {
    std::vector<double> areas(organ.rest.positions.size(), 0.0);
    for (std::size_t f = 0; f < organ.rest.facets.size(); ++f) {
        for (const Index vertex : organ.rest.facets[f]) areas[vertex] += organ.rest_areas[f] / 3;
    }
    return areas;
}

}  // namespace

SpringNetwork surface_springs(const Organ& organ, const SpringSettings& settings) {
    demand_positive(settings.density, "density");
    demand_positive(settings.edge_stiffness, "edge_stiffness");
    demand_positive(settings.rest_stiffness, "rest_stiffness");

    SpringNetwork network;
    network.rest = organ.rest.positions;
    const std::vector<double> areas = vertex_areas(organ);
    for (std::size_t vertex = 0; vertex < areas.size(); ++vertex) {
        network.masses.push_back(areas[vertex] * settings.density);
        network.rest_stiffness.push_back(areas[vertex] * settings.rest_stiffness);
        network.fixed.push_back(organ.adjacency.on_boundary(static_cast<Index>(vertex)));
    }
    for (const auto& [a, b] : organ.adjacency.edges()) {
        const double length = (network.rest[a] - network.rest[b]).norm();
        network.springs.push_back({a, b, length, settings.edge_stiffness});
    }
    for (const Patch& patch : organ.patches) network.patches.push_back(patch.vertices);
    return network;
}

}  // namespace trocar
