// What an answer owes to where rings begin: order_spread, order_spread_mean. A method is made up that sends a
// vertex in another direction for every facet at which its ring begins.

#include <cmath>
#include <numbers>
#include <vector>

#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {
namespace {

const Patch patch{.columns = 6, .rows = 5, .edge = 5, .x = -10, .y = -10};
constexpr double length = 2.8;  // of every displacement, mm

/// For each shift of the ring of six facets, the angle from +x in which the vertex is sent, degrees.
using Angles = std::vector<double>;

void send(Example& example, Index vertex, const Angles& angles) {
    auto& by_shift = example.shifted.displacements;
    by_shift.resize(angles.size());
    for (std::size_t shift = 0; shift < angles.size(); ++shift) {
        const double angle = angles[shift] * std::numbers::pi / 180;
        by_shift[shift].push_back({vertex, length * Vec3(std::cos(angle), std::sin(angle), 0)});
    }
}

/// How the vertices go when their rings begin `shift` facets on, with the facets marked at which they begin.
Panel panel_of(const Example& example, std::string title, std::size_t shift) {
    Panel panel{
        .title = std::move(title), .positions = example.before, .tool = example.end, .from = example.before};
    for (const auto& [vertex, displacement] : example.shifted.displacements[shift]) {
        panel.positions[vertex] += displacement;
        panel.marks.facets.push_back(example.organ.adjacency.ring(vertex)[shift]);
    }
    return panel;
}

/// All directions of each vertex, from where it was found.
Panel panel_of_all(const Example& example) {
    Panel panel{.title = "… at each of the six", .positions = example.before, .tool = example.end};
    for (const auto& displacements : example.shifted.displacements) {
        for (const auto& [vertex, displacement] : displacements) {
            const Vec3& from = example.before[vertex];
            panel.marks.segments.push_back({from, from + displacement});
        }
    }
    return panel;
}

void show_shifts(Example& example, std::size_t another) {
    example.handled = panel_of(example, "", 0).positions;
    example.panels = {panel_of(example, "rings begin at the red facet", 0),
                      panel_of(example, "… at another", another), panel_of_all(example)};
}

}  // namespace

Example order_spread() {
    Example example =
        still_step("order_spread", Moment::handled, patch.organ(), bar(2.4, 2.4, 4), tip_at(0, 0, -1.5));
    example.shifted.missing = Missing::nothing;
    send(example, patch.vertex(2, 2), {-75, -60, -100, -30, -40, -65});
    example.expected = 70;
    example.caption =
        "A made-up method sends the vertex in the tool in one of six directions, depending on the facet at "
        "which it "
        "begins to go around the vertex. Two of the directions are 70 degrees apart.";
    example.eye = {.towards = {0.15, -1, 1.5}, .centre = {0, -0.4, 0.8}, .width = 12.5, .height = 11.25};
    show_shifts(example, 3);
    return example;
}

Example order_spread_mean() {
    Example example =
        still_step("order_spread_mean", Moment::handled, patch.organ(), bar(6.6, 2, 4), tip_at(2.5, 0, -1.5));
    example.shifted.missing = Missing::nothing;
    send(example, patch.vertex(2, 2), {-110, -120, -90, -130, -150, -125});
    send(example, patch.vertex(3, 2), {-70, -70, -50, -60, -50, -55});
    example.expected = 40;
    example.caption =
        "Of two vertices in the tool one is sent in directions up to 60 degrees apart, the other up to 20: "
        "40 on "
        "average.";
    example.eye = {.towards = {0.15, -1, 1.5}, .centre = {2.5, -0.4, 0.8}, .width = 16, .height = 13.5};
    show_shifts(example, 4);
    return example;
}

}  // namespace trocar::examples
