// What is left of the organ's shape: edge_ratio_mean, strain, jitter, recovery, volume_change.

#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {
namespace {

const Patch patch = centred_patch(7, 4);

/// The nine vertices in the middle.
std::vector<Index> middle() {
    std::vector<Index> vertices;
    for (const int row : {2, 3, 4}) {
        for (const int column : {2, 3, 4}) vertices.push_back(patch.vertex(column, row));
    }
    return vertices;
}

std::vector<Vec3> middle_at(double z) {
    std::vector<Vec3> positions = patch.organ().rest.positions;
    for (const Index vertex : middle()) positions[vertex].z() = z;
    return positions;
}

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

Example jitter() {
    Example example = still_step("jitter", Moment::deformed, patch.organ(), bar(6, 6, 5), tip_at(0, 0, 5));
    example.two_before = example.deformed = middle_at(0);
    example.before = example.handled = middle_at(1.5);
    example.region = middle();
    example.expected = 3;
    example.caption =
        "Nine vertices jump up by 1.5 mm in one step and down by as much in the next: their velocity changes "
        "by 3 mm a "
        "step. A steady motion would have no jitter.";
    example.eye = {.towards = {0.4, -1, 0.6}, .centre = {0, 0, 3}, .width = 24, .height = 21};
    const Marks marks{.vertices = example.region};
    example.panels = {
        {.title = "two steps ago", .positions = example.two_before, .tool = example.end, .marks = marks},
        {.title = "one step ago",
         .positions = example.before,
         .tool = example.end,
         .from = example.two_before,
         .marks = marks},
        {.title = "after deformation",
         .positions = example.deformed,
         .tool = example.end,
         .from = example.before,
         .marks = marks}};
    return example;
}

Example recovery() {
    Example example = still_step("recovery", Moment::end, patch.organ(), bar(6, 6, 6), tip_at(0, 0, 9));
    example.before = example.handled = example.deformed = middle_at(-2);
    example.region = middle();
    example.expected = 2;
    example.caption =
        "The tool has left, and a dent is still there: the nine vertices near its way are 2 mm from where "
        "they were.";
    example.eye = {.towards = {0.4, -1, 0.7}, .centre = {0, 0, 5}, .width = 30, .height = 27};
    Marks marks{.vertices = example.region};
    const std::vector<Vec3> rest = middle_at(0);
    for (const Index vertex : example.region)
        marks.segments.push_back({rest[vertex], example.deformed[vertex]});
    example.panels = {{.title = "at rest", .positions = rest, .tool = example.end},
                      {.title = "one second after the tool has left",
                       .positions = example.deformed,
                       .tool = example.end,
                       .marks = std::move(marks)}};
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
