#include "tests/strategies/contract.h"

#include <algorithm>
#include <map>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "common/geometry/surface_queries.h"

namespace trocar::contract {
namespace {

using Moves = std::map<Index, Vec3>;

/// Relative to the scene's size: answers that should be equal may differ by rounding, and exit distances
/// enlarge it where a direction grazes a face.
constexpr double tolerance = 1e-7;

Response answer(Strategy& strategy, const Scene& scene) {
    Response response;
    scene.with_contact([&](const Contact& contact) { strategy.handle(contact, response); });
    return response;
}

Moves moves_of(const Maker& make, const Scene& scene) {
    Moves moves;
    for (const auto& [vertex, displacement] : answer(*make(), scene).displacements)
        moves[vertex] = displacement;
    return moves;
}

std::string text(const Vec3& v) { return fmt::format("({}, {}, {})", v.x(), v.y(), v.z()); }

double size_of(const Scene& scene) { return bounding_box(scene.positions).size().norm(); }

/// Compares two answers after `expect(vertex, displacement)` turned the first into what the second should be.
template <typename Expect>
std::string difference(const Moves& original, const Moves& changed, double allowed, const Expect& expect) {
    if (original.size() != changed.size()) {
        return fmt::format("{} vertices moved, {} in the changed scene", original.size(), changed.size());
    }
    for (const auto& [vertex, displacement] : original) {
        const auto [number, expected] = expect(vertex, displacement);
        const auto found = changed.find(number);
        if (found == changed.end())
            return fmt::format("vertex {} moved, but not in the changed scene", vertex);
        if ((found->second - expected).norm() > allowed) {
            return fmt::format("vertex {} moved by {}, expected {}", vertex, text(found->second),
                               text(expected));
        }
    }
    return {};
}

template <typename Entry>
std::string bad_vertices(const std::vector<Entry>& entries, std::size_t count) {
    std::set<Index> named;
    for (const Entry& entry : entries) {
        if (entry.vertex < 0 || entry.vertex >= static_cast<Index>(count))
            return "a vertex that does not exist";
        if (!named.insert(entry.vertex).second) return fmt::format("vertex {} named twice", entry.vertex);
    }
    return {};
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

}  // namespace

std::string violation_of_well_formed(const Maker& make, const Scene& scene) {
    const Response response = answer(*make(), scene);
    const std::size_t count = scene.positions.size();
    if (auto bad = bad_vertices(response.displacements, count); !bad.empty()) return bad;
    if (auto bad = bad_vertices(response.forces, count); !bad.empty()) return bad;
    if (response.fallbacks < 0) return "a negative number of fallbacks";
    for (const auto& [vertex, displacement] : response.displacements) {
        if (!displacement.allFinite())
            return fmt::format("vertex {} moved by {}", vertex, text(displacement));
    }
    for (const auto& [vertex, force] : response.forces) {
        if (!force.allFinite()) return fmt::format("force {} on vertex {}", text(force), vertex);
    }
    for (const auto& [vertex, point, normal] : response.half_spaces) {
        if (!point.allFinite() || !(std::abs(normal.norm() - 1) < 1e-6)) {
            return fmt::format("half-space at {} with normal {}", text(point), text(normal));
        }
    }
    return {};
}

std::string violation_of_quiet_without_contact(const Maker& make) {
    const Response response = answer(*make(), scene_without_contact());
    if (response.displacements.empty() && response.forces.empty() && response.half_spaces.empty()) return {};
    return "it answers although nothing collided";
}

std::string violation_of_promises(const Maker& make, const Scene& scene) {
    const Promises promises = make()->promises();
    const Moves moves = moves_of(make, scene);
    const std::set<Index> collided(scene.detected.collided.begin(), scene.detected.collided.end());
    if (promises.moves_collided_only) {
        for (const auto& [vertex, displacement] : moves) {
            if (!collided.contains(vertex))
                return fmt::format("vertex {} moved without being collided", vertex);
        }
    }
    if (!promises.clears_convex_tools && !promises.clears_any_tool) return {};
    const SurfaceQueries tool(scene.tool->mesh);
    for (const Index vertex : collided) {
        const auto move = moves.find(vertex);
        const Vec3 end = scene.positions[vertex] + (move == moves.end() ? Vec3(Vec3::Zero()) : move->second);
        const Vec3 judged = judged_position(scene.after, end);
        if (tool.contains(judged)) return fmt::format("vertex {} is still inside the tool", vertex);
        if (tool.distance(judged) < scene.clearance / 2) {
            return fmt::format("vertex {} is only {} mm outside the tool", vertex, tool.distance(judged));
        }
    }
    return {};
}

std::string violation_of_rigid_equivariance(const Maker& make, const Scene& scene, const Pose& by) {
    return difference(moves_of(make, scene), moves_of(make, moved(scene, by)), tolerance * size_of(scene),
                      [&](Index vertex, const Vec3& displacement) {
                          return std::pair(vertex, by.direction_to_world(displacement));
                      });
}

std::string violation_of_scale_equivariance(const Maker& make, const Scene& scene, double factor) {
    return difference(moves_of(make, scene), moves_of(make, scaled(scene, factor)),
                      tolerance * factor * size_of(scene), [&](Index vertex, const Vec3& displacement) {
                          return std::pair(vertex, Vec3(factor * displacement));
                      });
}

std::string violation_of_vertex_numbering(const Maker& make, const Scene& scene, std::uint64_t seed) {
    const Renumbered other = with_vertices_renumbered(scene, seed);
    return difference(moves_of(make, scene), moves_of(make, other.scene), tolerance * size_of(scene),
                      [&](Index vertex, const Vec3& displacement) {
                          return std::pair(other.number[vertex], displacement);
                      });
}

std::string violation_of_facet_numbering(const Maker& make, const Scene& scene, std::uint64_t seed) {
    if (!make()->promises().facet_order_free) return {};
    const Renumbered other = with_facets_renumbered(scene, seed);
    return difference(moves_of(make, scene), moves_of(make, other.scene), tolerance * size_of(scene),
                      [](Index vertex, const Vec3& displacement) { return std::pair(vertex, displacement); });
}

std::string violation_of_repeatability(const Maker& make, const Scene& scene, const Scene& another) {
    const auto strategy = make();
    const Response first = answer(*strategy, scene);
    (void)answer(*strategy, another);
    if (!same_bits(first, answer(*strategy, scene))) return "another answer the second time";
    if (!same_bits(first, answer(*make(), scene))) return "another answer from a fresh instance";

    std::vector<Response> answers(8);
    std::vector<std::thread> threads;
    for (Response& slot : answers) {
        threads.emplace_back([&] { slot = answer(*make(), scene); });
    }
    for (std::thread& thread : threads) thread.join();
    const bool all_same =
        std::ranges::all_of(answers, [&](const Response& r) { return same_bits(first, r); });
    return all_same ? std::string() : "another answer on another thread";
}

}  // namespace trocar::contract
