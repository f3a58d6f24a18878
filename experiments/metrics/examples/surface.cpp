// What handling does to the surface itself: flipped_facets, self_crossings.

#include "common/tool/tool_shapes.h"
#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {

Example flipped_facets() {
    const Patch patch = centred_patch(7, 4);
    Example example =
        still_step("flipped_facets", Moment::handled, patch.organ(), bar(4, 4, 6), tip_at(0, 0, -2));
    example.handled[patch.vertex(3, 3)] = {6.5, 1, 3.5};
    example.expected = 2;
    example.caption =
        "A vertex is put beyond its neighbours. Two of its six facets turn over and show their inner side.";
    example.eye = {.towards = {1, -0.75, 0.45}, .centre = {2, 0, 2}, .width = 22, .height = 16};
    show_handling(example,
                  {.vertices = {patch.vertex(3, 3)}, .facets = {patch.upper(3, 2), patch.lower(3, 3)}});
    return example;
}

/// A strip of squares, bent along a line of corners. Where two of its squares cross at different parts of
/// their length, three pairs of their facets do.
Example self_crossings() {
    const std::vector<Vec3> line = {{-15, 0, 0}, {-9, 0, 0},   {-3, 0, 0.5}, {3, 0, 2.5},
                                    {4.5, 0, 8}, {0, 0, 11.5}, {-4.5, 0, 8}, {-3, 0, 2.5},
                                    {4, 0, 0.2}, {9.5, 0, 0},  {15.5, 0, 0}};
    const int corners = static_cast<int>(line.size());
    const Patch strip{.columns = corners, .rows = 2, .edge = 6, .x = -30, .y = -3};
    Mat3 lying;  // the tool's axis along y
    lying << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    Example example = still_step("self_crossings", Moment::handled, strip.organ(), make_prism(12, 3, 14),
                                 {.rotation = lying, .position = {0, -6, 6.5}});
    for (int column = 0; column < corners; ++column) {
        for (const int row : {0, 1}) {
            Vec3& position = example.handled[strip.vertex(column, row)];
            position = line[column] + Vec3(0, position.y(), 0);
        }
    }
    example.expected = 3;
    example.caption =
        "A strip is laid around a thin tool and through itself. Of the two squares that cross, each of two "
        "facets, "
        "three pairs of facets do.";
    example.eye = {.towards = {0.45, -1, 0.45}, .centre = {0, 0, 4}, .width = 36, .height = 20};
    example.panels = {
        {.title = "after handling",
         .positions = example.handled,
         .tool = example.end,
         .marks = {.facets = {strip.lower(2, 0), strip.upper(2, 0), strip.lower(7, 0), strip.upper(7, 0)}}}};
    return example;
}

}  // namespace trocar::examples
