#include "tests/strategies/answers.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace trocar::contract {
namespace {

constexpr double relative = 1e-7;

std::string text(const Vec3& v) { return fmt::format("({}, {}, {})", v.x(), v.y(), v.z()); }

/// Entries of the same vertex keep their order.
template <typename Entry>
std::multimap<Index, Vec3> by_vertex(const std::vector<Entry>& entries, Vec3 Entry::*vector) {
    std::multimap<Index, Vec3> ordered;
    for (const Entry& entry : entries) ordered.emplace(entry.vertex, entry.*vector);
    return ordered;
}

/// Compares one vector of each entry.
template <typename Entry>
std::string list_difference(const char* what, const std::vector<Entry>& expected,
                            const std::vector<Entry>& found, Vec3 Entry::*vector, double allowed) {
    if (expected.size() != found.size()) {
        return fmt::format("{} of {} vertices, expected {}", what, found.size(), expected.size());
    }
    const auto right = by_vertex(expected, vector), given = by_vertex(found, vector);
    for (auto r = right.begin(), g = given.begin(); r != right.end(); ++r, ++g) {
        if (r->first != g->first) {
            return fmt::format("{} of vertex {}, expected of {}", what, g->first, r->first);
        }
        if ((r->second - g->second).norm() <= allowed) continue;
        return fmt::format("{} of vertex {}: {}, expected {}", what, g->first, text(g->second),
                           text(r->second));
    }
    return {};
}

double largest(const std::vector<VertexForce>& forces) {
    double length = 0;
    for (const VertexForce& entry : forces) length = std::max(length, entry.force.norm());
    return length;
}

/// A half-space as its normal and the foot of its plane under the origin: any point of the plane names it.
std::vector<HalfSpace> with_feet(std::vector<HalfSpace> half_spaces) {
    for (HalfSpace& entry : half_spaces) entry.point = entry.normal * entry.normal.dot(entry.point);
    return half_spaces;
}

}  // namespace

Response changed(const Response& original, const Change& change) {
    Response answer = original;
    for (auto& [vertex, displacement] : answer.displacements) {
        vertex = change.number(vertex);
        displacement = change.scaled * change.moved.direction_to_world(displacement);
    }
    for (auto& [vertex, force] : answer.forces) {
        vertex = change.number(vertex);
        force = change.moved.direction_to_world(force);
    }
    for (auto& [vertex, point, normal] : answer.half_spaces) {
        vertex = change.number(vertex);
        point = change.scaled * change.moved.to_world(point);
        normal = change.moved.direction_to_world(normal);
    }
    return answer;
}

std::string difference(Response expected, Response found, double allowed) {
    if (expected.fallbacks != found.fallbacks) {
        return fmt::format("{} fallbacks, expected {}", found.fallbacks, expected.fallbacks);
    }
    auto what = list_difference("displacement", expected.displacements, found.displacements,
                                &VertexDisplacement::displacement, allowed);
    if (what.empty()) {
        what = list_difference("force", expected.forces, found.forces, &VertexForce::force,
                               relative * largest(expected.forces));
    }
    expected.half_spaces = with_feet(std::move(expected.half_spaces));
    found.half_spaces = with_feet(std::move(found.half_spaces));
    if (what.empty()) {
        what = list_difference("normal of the half-space", expected.half_spaces, found.half_spaces,
                               &HalfSpace::normal, relative);
    }
    if (what.empty()) {
        what = list_difference("plane of the half-space", expected.half_spaces, found.half_spaces,
                               &HalfSpace::point, allowed);
    }
    return what;
}

bool same_bits(const Response& a, const Response& b) {
    const auto same = [](const auto& x, const auto& y) { return x.vertex == y.vertex; };
    return a.fallbacks == b.fallbacks &&
           std::ranges::equal(a.displacements, b.displacements,
                              [&](const auto& x, const auto& y) {
                                  return same(x, y) && x.displacement == y.displacement;
                              }) &&
           std::ranges::equal(
               a.forces, b.forces,
               [&](const auto& x, const auto& y) { return same(x, y) && x.force == y.force; }) &&
           std::ranges::equal(a.half_spaces, b.half_spaces, [&](const auto& x, const auto& y) {
               return same(x, y) && x.point == y.point && x.normal == y.normal;
           });
}

}  // namespace trocar::contract
