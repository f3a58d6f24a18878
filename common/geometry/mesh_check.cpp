#include "common/geometry/mesh_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/geometry/mesh_topology.h"

namespace trocar {
namespace {

using Severity = Finding::Severity;

constexpr std::size_t places_named = 3;

class Checker {
  public:
    Checker(const SurfaceMesh& mesh, MeshReport& report) : mesh_(mesh), report_(report) {}

    // Whether the mesh is sound enough for the questions below.
    bool check_numbers() {
        std::vector<Index> strange, lost, repeated;
        for (Index v = 0; v < vertex_count(); ++v) {
            if (!mesh_.positions[v].allFinite()) strange.push_back(v);
        }
        for (Index f = 0; f < facet_count(); ++f) {
            const Facet& facet = mesh_.facets[f];
            const auto [low, high] = std::ranges::minmax(facet);
            if (low < 0 || high >= vertex_count()) lost.push_back(f);
            if (facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0]) repeated.push_back(f);
        }
        const auto facet_vertices = [&](Index f) {
            return fmt::format("facet {} ({})", f, fmt::join(mesh_.facets[f], ", "));
        };
        add(Severity::refused, "vertices with a coordinate that is not finite", strange,
            [](Index v) { return fmt::format("vertex {}", v); });
        add(Severity::refused, "facets that name a vertex that does not exist", lost, facet_vertices);
        add(Severity::refused, "facets that name a vertex twice", repeated, facet_vertices);
        return strange.empty() && lost.empty() && repeated.empty() && !mesh_.facets.empty();
    }

    void check_facets() {
        std::vector<Index> flat, order(mesh_.facets.size()), copies;
        for (Index f = 0; f < facet_count(); ++f) {
            const auto [a, b, c] = mesh_.facets[f];
            const double longest = std::max({length(a, b), length(b, c), length(c, a)});
            constexpr double rounding =
                1e-15;  // an area this far below the longest edge's square has no direction
            const double area = facet_area_vector(mesh_.positions, mesh_.facets[f]).norm();
            if (area <= rounding * longest * longest) flat.push_back(f);
        }
        std::vector<Facet> sorted = mesh_.facets;
        for (Facet& facet : sorted) std::ranges::sort(facet);
        std::iota(order.begin(), order.end(), 0);
        std::ranges::sort(order,
                          [&](Index a, Index b) { return std::tie(sorted[a], a) < std::tie(sorted[b], b); });
        for (std::size_t i = 1; i < order.size(); ++i) {
            if (sorted[order[i]] == sorted[order[i - 1]]) copies.push_back(order[i]);
        }
        std::ranges::sort(copies);
        const auto place = [&](Index f) { return facet_place(f); };
        add(Severity::refused, "facets without area", flat, place);
        add(Severity::refused, "facets with the same vertices as another one", copies, place);
    }

    void check_edges() {
        uses_ = edge_uses(mesh_.facets);
        std::vector<Index> crowded, unordered, border;  // numbers of the edge's first use
        for_each_edge(uses_, [&](std::span<const EdgeUse> uses) {
            const auto first = static_cast<Index>(uses.data() - uses_.data());
            if (uses.size() > 2) crowded.push_back(first);
            if (uses.size() == 2 && uses[0].forward == uses[1].forward) unordered.push_back(first);
            if (uses.size() == 1) border.push_back(first);
            ++report_.edges;
        });
        const auto place = [&](Index use) { return edge_place(uses_[use]); };
        add(Severity::refused, "edges with more than two facets (not manifold)", crowded, place);
        add(Severity::refused, "edges whose two facets are oriented against each other", unordered, place);
        add(Severity::note, "border edges (the surface is open)", border, place);
        report_.closed = border.empty() && crowded.empty();
    }

    // Around a manifold vertex the facets are joined by edges, one to the next; else it is where surfaces
    // only touch.
    void check_vertices() {
        DisjointSets corners(3 * mesh_.facets.size());
        for_each_edge(uses_, [&](std::span<const EdgeUse> uses) {
            for (std::size_t i = 1; i < uses.size(); ++i) {
                corners.unite(corner(uses[0].facet, uses[0].low), corner(uses[i].facet, uses[0].low));
                corners.unite(corner(uses[0].facet, uses[0].high), corner(uses[i].facet, uses[0].high));
            }
        });
        std::vector<Index> fan(mesh_.positions.size(), -1), touching, unused;
        for (Index f = 0; f < facet_count(); ++f) {
            for (const Index vertex : mesh_.facets[f]) {
                const Index root = corners.find(corner(f, vertex));
                if (fan[vertex] == -1) fan[vertex] = root;
                if (fan[vertex] != root) touching.push_back(vertex);
            }
        }
        for (Index v = 0; v < vertex_count(); ++v) {
            if (fan[v] == -1) unused.push_back(v);
        }
        std::ranges::sort(touching);
        touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
        const auto place = [&](Index v) {
            return fmt::format("vertex {} at {}", v, point(mesh_.positions[v]));
        };
        add(Severity::refused, "vertices in which parts of the surface only touch (not manifold)", touching,
            place);
        add(Severity::mended, "vertices that no facet names, dropped", unused, place);
    }

    void check_components() {
        DisjointSets parts(mesh_.positions.size());
        for (const auto& [a, b, c] : mesh_.facets) {
            parts.unite(a, b);
            parts.unite(b, c);
        }
        std::vector<std::size_t> sizes(mesh_.positions.size(), 0);
        for (const Facet& facet : mesh_.facets) ++sizes[parts.find(facet[0])];
        std::erase(sizes, 0);
        std::ranges::sort(sizes, std::ranges::greater());
        report_.components = sizes.size();
        if (sizes.size() < 2) return;
        const std::size_t named = std::min(sizes.size(), places_named);
        report_.findings.push_back(
            {Severity::refused, fmt::format("components that do not touch: {} instead of one", sizes.size()),
             fmt::format(
                 "facets in {}: {}", named == sizes.size() ? "each" : "the largest",
                 fmt::join(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(named), ", "))});
    }

    void measure() {
        std::vector<double> lengths;
        lengths.reserve(report_.edges);
        for_each_edge(uses_, [&](std::span<const EdgeUse> uses) {
            lengths.push_back(length(uses[0].low, uses[0].high));
        });
        const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
        std::ranges::nth_element(lengths, middle);
        report_.median_edge = *middle;
        const auto [shortest, longest] = std::ranges::minmax(lengths);
        report_.shortest_edge = shortest;
        report_.longest_edge = longest;
        for (const Facet& facet : mesh_.facets) {
            for (const Index vertex : facet) report_.box.add(mesh_.positions[vertex]);
        }
        const std::vector<double> areas = facet_areas(mesh_);
        report_.area = std::accumulate(areas.begin(), areas.end(), 0.0);
    }

  private:
    [[nodiscard]] Index vertex_count() const { return static_cast<Index>(mesh_.positions.size()); }
    [[nodiscard]] Index facet_count() const { return static_cast<Index>(mesh_.facets.size()); }
    [[nodiscard]] double length(Index a, Index b) const {
        return (mesh_.positions[a] - mesh_.positions[b]).norm();
    }
    [[nodiscard]] Index corner(Index facet, Index vertex) const {
        const Facet& corners = mesh_.facets[facet];
        return 3 * facet + static_cast<Index>(std::ranges::find(corners, vertex) - corners.begin());
    }

    static std::string point(const Vec3& p) {
        return fmt::format("({:.5g}, {:.5g}, {:.5g})", p.x(), p.y(), p.z());
    }
    [[nodiscard]] std::string facet_place(Index f) const {
        const auto [a, b, c] = mesh_.facets[f];
        return fmt::format("facet {} at {}", f,
                           point((mesh_.positions[a] + mesh_.positions[b] + mesh_.positions[c]) / 3));
    }
    [[nodiscard]] std::string edge_place(const EdgeUse& use) const {
        return fmt::format("edge {}–{} of facet {} at {}", use.low, use.high, use.facet,
                           point((mesh_.positions[use.low] + mesh_.positions[use.high]) / 2));
    }

    template <class Place>
    void add(Severity severity, std::string_view what, const std::vector<Index>& found, Place place) {
        if (found.empty()) return;
        std::string where;
        for (std::size_t i = 0; i < std::min(found.size(), places_named); ++i) {
            where += (i == 0 ? "" : ", ") + place(found[i]);
        }
        if (found.size() > places_named) where += fmt::format(", and {} more", found.size() - places_named);
        report_.findings.push_back({severity, fmt::format("{}: {}", what, found.size()), std::move(where)});
    }

    const SurfaceMesh& mesh_;
    MeshReport& report_;
    std::vector<EdgeUse> uses_;  // ascending by edge
};

void drop_unused_vertices(SurfaceMesh& mesh) {
    std::vector<Index> number(mesh.positions.size(), -1);
    for (const Facet& facet : mesh.facets) {
        for (const Index vertex : facet) number[vertex] = 0;
    }
    Index kept = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == -1) continue;
        mesh.positions[kept] = mesh.positions[v];
        number[v] = kept++;
    }
    mesh.positions.resize(kept);
    for (Facet& facet : mesh.facets) {
        for (Index& vertex : facet) vertex = number[vertex];
    }
}

void turn_outward(SurfaceMesh& mesh, MeshReport& report) {
    report.volume = signed_volume(mesh);
    if (*report.volume >= 0) return;
    for (Facet& facet : mesh.facets) std::swap(facet[1], facet[2]);
    report.volume = -*report.volume;
    report.findings.push_back({Severity::mended, "the surface was inside out: turned all facets", ""});
}

}  // namespace

bool MeshReport::usable() const {
    return std::ranges::find(findings, Severity::refused, &Finding::severity) == findings.end();
}

MeshReport check_mesh(SurfaceMesh& mesh) {
    MeshReport report;
    Checker checker(mesh, report);
    if (mesh.facets.empty()) report.findings.push_back({Severity::refused, "the mesh has no facet", ""});
    if (checker.check_numbers()) {
        checker.check_facets();
        checker.check_edges();
        checker.check_vertices();
        checker.check_components();
        checker.measure();
        if (report.usable()) {
            drop_unused_vertices(mesh);
            if (report.closed) turn_outward(mesh, report);
        }
    }
    report.vertices = mesh.positions.size();
    report.facets = mesh.facets.size();
    if (report.usable() && report.closed) {
        const auto euler = static_cast<std::int64_t>(report.vertices + report.facets) -
                           static_cast<std::int64_t>(report.edges);
        report.genus = (2 - euler) / 2;
    }
    std::ranges::stable_sort(report.findings, std::ranges::greater(), &Finding::severity);
    return report;
}

}  // namespace trocar
