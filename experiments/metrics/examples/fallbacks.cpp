#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {

/// A fold so sharp that the normals on either side of its crest are opposite but for a little.
Example fallbacks() {
    const Patch patch = centred_patch(5, 6);
    constexpr int crest = 2;
    SurfaceMesh folded = patch.organ().rest;
    for (int row = 0; row < patch.rows; ++row) {
        folded.positions[patch.vertex(crest - 1, row)].x() = -0.3;
        folded.positions[patch.vertex(crest + 1, row)].x() = 0.3;
        folded.positions[patch.vertex(crest - 2, row)].x() = -8;
        folded.positions[patch.vertex(crest + 2, row)].x() = 8;
        folded.positions[patch.vertex(crest, row)].z() = 8;
    }
    Example example =
        still_step("fallbacks", Moment::handled, make_organ("fold", folded), bar(6, 6, 10), tip_at(0, 0, 4));
    example.fallbacks = 1;  // as a strategy says that takes the mean of the normals
    example.expected = 1;
    example.caption =
        "A vertex on a sharp fold: the normals around it cancel, and their mean names no direction. The "
        "strategy says so "
        "and moves the vertex in some other way.";
    example.eye = {.towards = {0.7, -1, 0.5}, .centre = {0, 0, 6}, .width = 30, .height = 26};
    const Vec3 vertex(0, 0, 8), normal(4.5, 0, 0);
    example.panels = {{.title = "before handling",
                       .positions = example.before,
                       .tool = example.end,
                       .marks = {.vertices = {patch.vertex(crest, crest)},
                                 .segments = {{vertex, vertex - normal}, {vertex, vertex + normal}}}}};
    return example;
}

}  // namespace trocar::examples
