// A tool comes down on a sheet; some of the vertices that it holds are left in it.

#include "common/tool/tool_shapes.h"
#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {

Example collided_vertices() {
    const Patch patch = centred_patch(9, 3);
    Example example = still_step("collided_vertices", Moment::before, patch.organ(), make_prism(12, 4, 12),
                                 tip_at(0, 0, -3));
    example.start = tip_at(0, 0, 4);
    example.expected = 5;
    example.caption =
        "The tool comes down through the sheet. Five vertices are inside it and have to be handled.";
    example.eye.centre = {0, 0, 4};
    example.panels = {{.title = "as the step begins", .positions = example.before, .tool = example.start},
                      {.title = "before handling",
                       .positions = example.before,
                       .tool = example.end,
                       .marks = {.vertices = {patch.vertex(4, 3), patch.vertex(3, 4), patch.vertex(4, 4),
                                              patch.vertex(5, 4), patch.vertex(4, 5)}}}};
    return example;
}

Example vertices_inside() {
    const Patch patch = centred_patch(9, 3);
    Example example =
        still_step("vertices_inside", Moment::handled, patch.organ(), bar(8, 8, 12), tip_at(0, 0, -2));
    for (const Index vertex : collided(example)) example.handled[vertex].z() = -2.5;
    const std::vector<Index> left = {patch.vertex(4, 4), patch.vertex(5, 4)};
    for (const Index vertex : left) example.handled[vertex].z() = -0.8;
    example.expected = 2;
    example.caption = "Nine vertices were inside. Seven are pushed out below the tip, two not far enough.";
    example.eye.centre = {0, 0, 3};
    show_handling(example, {.vertices = left});
    return example;
}

}  // namespace trocar::examples
