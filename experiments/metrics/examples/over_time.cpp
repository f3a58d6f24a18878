// How a dented sheet moves from step to step, and what is left of the dent: jitter, recovery.

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

}  // namespace trocar::examples
