// How alike neighbours are moved: displacement_crossings, spread, edge_ratio_min.

#include <cmath>
#include <numbers>

#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {
namespace {

const Patch patch = centred_patch(8, 3);
// The square in the middle.
const Index a = patch.vertex(3, 3), b = patch.vertex(4, 3), c = patch.vertex(4, 4), d = patch.vertex(3, 4);

}  // namespace

Example displacement_crossings() {
    Example example = still_step("displacement_crossings", Moment::handled, patch.organ(), bar(5, 2, 6),
                                 tip_at(0, -1.5, -2));
    example.handled[a] = {2, -3.6, -0.5};
    example.handled[b] = {-2, -3.6, -0.5};
    example.expected = 1;
    example.caption =
        "Two neighbours inside the tool change places on their way out: the edge between them is turned "
        "around.";
    example.eye = {.towards = {0.3, -1, 1.6}, .centre = {0, -1.5, 1}, .width = 16, .height = 14};
    show_handling(example, {.vertices = {a, b},
                            .segments = {{example.before[a], example.handled[a]},
                                         {example.before[b], example.handled[b]}}});
    return example;
}

Example spread() {
    Example example = still_step("spread", Moment::handled, patch.organ(), bar(4, 4, 6), tip_at(0, 0, -2));
    std::vector<Vec3> alike = example.before;
    for (const Index vertex : {a, b, c, d}) alike[vertex] += Vec3(0, -4, -0.6);
    example.handled[a] += Vec3(0, -2.5, -0.6);
    example.handled[b] += Vec3(2.5, 0, -0.6);
    example.handled[c] += Vec3(0, 2.5, -0.6);
    example.handled[d] += Vec3(-2.5, 0, -0.6);
    example.expected = 2.5 * std::numbers::sqrt2 / 3;  // of every edge, also of the diagonal
    example.caption =
        "Four neighbours, 3 mm apart, go 2.5 mm each, in four directions. Moved all alike, as on the right, "
        "they would "
        "have a spread of 0, however far they go.";
    example.eye = {.towards = {0.3, -1, 1.6}, .centre = {0, -0.5, 1}, .width = 15, .height = 13.5};
    show_handling(example, {.vertices = {a, b, c, d},
                            .segments = {{example.before[a], example.handled[a]},
                                         {example.before[b], example.handled[b]},
                                         {example.before[c], example.handled[c]},
                                         {example.before[d], example.handled[d]}}});
    example.panels.push_back({.title = "if they were moved all alike",
                              .positions = alike,
                              .tool = example.end,
                              .from = example.before});
    return example;
}

Example edge_ratio_min() {
    Example example =
        still_step("edge_ratio_min", Moment::handled, patch.organ(), bar(4, 4, 6), tip_at(0, 0, -2));
    example.handled[a] = {-0.15, -3, -0.5};
    example.handled[b] = {0.15, -3, -0.5};
    example.handled[c] = {1.5, 3, -0.5};
    example.handled[d] = {-1.5, 3, -0.5};
    example.expected = 0.1;
    example.caption = "Two neighbours, 3 mm apart at rest, are put almost in the same place: 0.3 mm apart.";
    example.eye = {.towards = {0.3, -1, 1.6}, .centre = {0, -1.5, 1}, .width = 16, .height = 14};
    show_handling(example, {.vertices = {a, b}});
    return example;
}

}  // namespace trocar::examples
