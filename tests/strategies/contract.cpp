#include "tests/strategies/contract.h"

#include <algorithm>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "common/geometry/surface_queries.h"
#include "tests/strategies/answers.h"

namespace trocar::contract {
namespace {

Response answer(Strategy& strategy, const Scene& scene) {
    Response response;
    scene.with_contact([&](const Contact& contact) { strategy.handle(contact, response); });
    return response;
}

Response fresh_answer(const Subject& subject, const Scene& scene) { return answer(*subject.make(), scene); }

/// Answers that should be equal may differ by rounding, and exit distances enlarge it where a direction
/// grazes a face.
double allowed(const Scene& scene) { return 1e-7 * bounding_box(scene.positions).size().norm(); }

template <typename Entry>
std::string bad_vertices(const std::vector<Entry>& entries, std::size_t count) {
    std::set<Index> named;
    for (const Entry& entry : entries) {
        if (entry.vertex < 0 || entry.vertex >= static_cast<Index>(count))
            return fmt::format("vertex {}, which does not exist", entry.vertex);
        if (!named.insert(entry.vertex).second) return fmt::format("vertex {} named twice", entry.vertex);
    }
    return {};
}

/// Whether no vertex of the mesh lies above a facet; the tool itself is not asked.
bool is_convex(const SurfaceMesh& mesh) {
    const double rounding = 1e-9 * bounding_box(mesh.positions).size().norm();
    return std::ranges::all_of(mesh.facets, [&](const Facet& facet) {
        const Vec3 normal = facet_normal(mesh.positions, facet), &corner = mesh.positions[facet[0]];
        return std::ranges::all_of(mesh.positions,
                                   [&](const Vec3& p) { return normal.dot(p - corner) <= rounding; });
    });
}

/// Where vertices are after an answer.
std::vector<Vec3> positions_after(const Response& response, const Scene& scene) {
    std::vector<Vec3> positions = scene.positions;
    for (const auto& [vertex, displacement] : response.displacements) positions[vertex] += displacement;
    return positions;
}

}  // namespace

std::string violation_of_well_formed(const Subject& subject, const Scene& scene) {
    const Response response = fresh_answer(subject, scene);
    const std::size_t count = scene.positions.size();
    if (auto bad = bad_vertices(response.displacements, count); !bad.empty()) return bad;
    if (auto bad = bad_vertices(response.forces, count); !bad.empty()) return bad;
    if (response.fallbacks < 0) return "a negative number of fallbacks";
    for (const auto& [vertex, displacement] : response.displacements) {
        if (!displacement.allFinite()) return fmt::format("no finite displacement of vertex {}", vertex);
    }
    for (const auto& [vertex, force] : response.forces) {
        if (!force.allFinite()) return fmt::format("no finite force on vertex {}", vertex);
    }
    for (const auto& [vertex, point, normal] : response.half_spaces) {
        if (vertex < 0 || vertex >= static_cast<Index>(count)) return "a half-space of no vertex";
        if (!point.allFinite() || !(std::abs(normal.norm() - 1) < 1e-6)) {
            return fmt::format("no half-space for vertex {}: its point is not finite or its normal no unit",
                               vertex);
        }
    }
    return {};
}

std::string violation_of_quiet_without_contact(const Subject& subject, const Scene& scene) {
    if (!scene.detected.collided.empty()) return "the scene has a collided vertex";
    if (subject.description.swept_contact && !scene.detected.near_vertices.empty()) return {};
    const Response response = fresh_answer(subject, scene);
    if (response.displacements.empty() && response.forces.empty() && response.half_spaces.empty()) return {};
    return "it answers although nothing collided";
}

std::string violation_of_clearing(const Subject& subject, const Scene& scene) {
    const Promises promises = subject.make()->promises();
    const SurfaceMesh& mesh = scene.tool->mesh;
    const bool promised = promises.clears_any_tool || (promises.clears_convex_tools && is_convex(mesh));
    if (!promised) return {};
    const std::vector<Vec3> positions = positions_after(fresh_answer(subject, scene), scene);
    const SurfaceQueries tool(mesh);
    for (const Index vertex : scene.detected.collided) {
        const Vec3 judged = judged_position(scene.after, positions[vertex]);
        if (tool.contains(judged)) return fmt::format("vertex {} is still inside the tool", vertex);
        if (!(tool.distance(judged) >= scene.clearance / 2)) {
            return fmt::format("vertex {} is only {} mm outside the tool", vertex, tool.distance(judged));
        }
    }
    return {};
}

std::string violation_of_leaving_others(const Subject& subject, const Scene& scene) {
    if (!subject.make()->promises().moves_collided_only) return {};
    const Response response = fresh_answer(subject, scene);
    const auto find_other = [&](const auto& entries) -> std::string {
        for (const auto& entry : entries) {
            if (!std::ranges::binary_search(scene.detected.collided, entry.vertex))
                return fmt::format("vertex {} is not collided", entry.vertex);
        }
        return {};
    };
    if (auto other = find_other(response.displacements); !other.empty()) return other;
    if (auto other = find_other(response.forces); !other.empty()) return other;
    return find_other(response.half_spaces);
}

std::string violation_of_rigid_equivariance(const Subject& subject, const Scene& scene, const Pose& by) {
    const Response expected = changed(fresh_answer(subject, scene), {.moved = by});
    return difference(expected, fresh_answer(subject, moved(scene, by)), allowed(scene));
}

std::string violation_of_scale_equivariance(const Subject& subject, const Scene& scene, double factor) {
    Response expected = changed(fresh_answer(subject, scene), {.scaled = factor});
    Response found = fresh_answer(subject, scaled(scene, factor));
    expected.forces.clear();
    found.forces.clear();
    return difference(expected, found, factor * allowed(scene));
}

std::string violation_of_vertex_numbering(const Subject& subject, const Scene& scene, std::uint64_t seed) {
    const Renumbered other = with_vertices_renumbered(scene, seed);
    const Response expected =
        changed(fresh_answer(subject, scene), {.number = [&](Index vertex) { return other.number[vertex]; }});
    return difference(expected, fresh_answer(subject, other.scene), allowed(scene));
}

std::string violation_of_facet_numbering(const Subject& subject, const Scene& scene, std::uint64_t seed) {
    if (!subject.make()->promises().facet_order_free) return {};
    const Renumbered other = with_facets_renumbered(scene, seed);
    return difference(fresh_answer(subject, scene), fresh_answer(subject, other.scene), allowed(scene));
}

std::string violation_of_repeatability(const Subject& subject, const Scene& scene, const Scene& another) {
    const auto strategy = subject.make();
    const Response first = answer(*strategy, scene);
    if (!subject.description.keeps_state) {
        (void)answer(*strategy, another);
        if (!same_bits(first, answer(*strategy, scene))) return "another answer the second time";
    }
    if (!same_bits(first, fresh_answer(subject, scene))) return "another answer from a fresh instance";

    std::vector<Response> answers(8);
    std::vector<std::thread> threads;
    for (Response& slot : answers) {
        threads.emplace_back([&] { slot = fresh_answer(subject, scene); });
    }
    for (std::thread& thread : threads) thread.join();
    const bool all_same =
        std::ranges::all_of(answers, [&](const Response& r) { return same_bits(first, r); });
    return all_same ? std::string() : "another answer on another thread";
}

}  // namespace trocar::contract
