// What is left of the organ's shape: edge_ratio_mean, strain, volume_change.

#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {
namespace {

const Patch patch = centred_patch(7, 4);

}  // namespace

Example edge_ratio_mean() {
    Example example =
        still_step("edge_ratio_mean", Moment::handled, patch.organ(), bar(10, 10, 10), tip_at(0, 0, -2));
    for (Vec3& position : example.handled) position = position / 2 - Vec3(0, 0, 3);
    example.expected = 0.5;
    example.caption =
        "The sheet is bunched under the tip: every edge has half its length at rest. Those with an end that "
        "was "
        "inside count.";
    example.eye.centre = {0, 0, 2};
    example.eye.width = 32;
    show_handling(example, {.vertices = collided(example)});
    example.panels.back().from.clear();
    return example;
}

Example strain() {
    Example example = still_step("strain", Moment::deformed, patch.organ(), bar(6, 6, 8), tip_at(0, 0, 0));
    for (Vec3& position : example.deformed) position *= 1.25;
    example.expected = 0.25;
    example.caption = "Every edge is a quarter longer than at rest. Edges that are shorter count alike.";
    example.eye = {.towards = {0.4, -1, 0.9}, .centre = {0, 0, 1}, .width = 36, .height = 25};
    example.panels = {{.title = "at rest", .positions = example.before, .tool = example.end},
                      {.title = "after deformation", .positions = example.deformed, .tool = example.end}};
    return example;
}

Example volume_change() {
    Example example =
        still_step("volume_change", Moment::deformed, make_organ("block", box({-9, -9, 0}, {9, 9, 10})),
                   bar(14, 14, 5), tip_at(0, 0, 8));
    for (Vec3& position : example.deformed) position.z() *= 0.8;
    example.start = tip_at(0, 0, 10);
    example.expected = -0.2;
    example.caption =
        "Pressed flat by 2 of its 10 mm, with no way aside, a closed organ loses a fifth of its volume.";
    example.eye.centre = {0, 0, 7};
    example.eye.width = 32;
    example.eye.height = 27;
    example.panels = {{.title = "at rest", .positions = example.before, .tool = example.start},
                      {.title = "after deformation",
                       .positions = example.deformed,
                       .tool = example.end,
                       .from = example.before}};
    return example;
}

}  // namespace trocar::examples
