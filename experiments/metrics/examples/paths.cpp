// A tool that goes sideways past the top of a tent.

#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {
namespace {

const Patch patch = centred_patch(7, 4);
const Index top = patch.vertex(3, 3);
const Vec3 top_at(0, 0, 4);

Example at_a_tent(std::string metric, Moment moment, Tool tool, const Pose& start, const Pose& end) {
    Example example = still_step(std::move(metric), moment, patch.organ(), std::move(tool), end);
    example.start = start;
    example.before[top] = top_at;
    example.handled = example.deformed = example.before;
    example.eye.centre = {0, 0, 4};
    example.panels = {
        {.title = "as the step begins",
         .positions = example.before,
         .tool = start,
         .marks = {.vertices = {top}}},
        {.title = "before handling", .positions = example.before, .tool = end, .marks = {.vertices = {top}}}};
    return example;
}

}  // namespace

Example tunnelled() {
    Example example =
        at_a_tent("tunnelled", Moment::before, bar(0.6, 7, 10), tip_at(-6, 0, 2), tip_at(6, 0, 2));
    example.expected = 1;
    example.caption =
        "Within one step a blade goes from one side of the vertex to the other, right through it. It is "
        "outside when "
        "the step begins and outside when collisions are looked for: never detected.";
    return example;
}

Example tool_crossings() {
    Example example =
        at_a_tent("tool_crossings", Moment::handled, bar(6, 6, 10), tip_at(6, 0, 2), tip_at(1, 0, 2));
    example.handled[top] = {4.5, 0, 4};
    example.deformed = example.handled;
    example.expected = 1;
    example.caption =
        "The tool comes from the right, so the vertex goes in through its left side. It is put out on the "
        "right: the "
        "tissue now lies on the wrong side of the tool.";
    example.panels.push_back({.title = "after handling",
                              .positions = example.handled,
                              .tool = example.end,
                              .from = example.before,
                              .marks = {.vertices = {top}, .segments = {{top_at, example.handled[top]}}}});
    return example;
}

}  // namespace trocar::examples
