// Tools inside closed organs that have no vertex inside the tool.

#include <algorithm>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "common/geometry/organ_shapes.h"
#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"
#include "experiments/metrics/judge/judged_tool.h"

namespace trocar::examples {
namespace {

/// The edges of a box, mm.
std::vector<std::array<Vec3, 2>> box_edges(const Vec3& low, const Vec3& high) {
    std::vector<std::array<Vec3, 2>> edges;
    for (int axis = 0; axis < 3; ++axis) {
        for (int which = 0; which < 4; ++which) {
            Vec3 from = low;
            if (which % 2 == 1) from[(axis + 1) % 3] = high[(axis + 1) % 3];
            if (which / 2 == 1) from[(axis + 2) % 3] = high[(axis + 2) % 3];
            Vec3 to = from;
            to[axis] = high[axis];
            edges.push_back({from, to});
        }
    }
    return edges;
}

}  // namespace

Example tool_points_inside() {
    SurfaceMesh ball = make_organ_by_formula("sphere@10mm").rest;
    const double radius = ball.positions.front().norm();
    for (Vec3& position : ball.positions) position *= 12 / radius;
    const Mat3 leaning = Eigen::AngleAxisd(0.7, Vec3::UnitY()).toRotationMatrix();
    Example example = still_step("tool_points_inside", Moment::handled, make_organ("ball", ball),
                                 bar(4, 4, 12), {.rotation = leaning, .position = leaning * Vec3(0, 0, -6)});
    example.expected = 2 * 4 * 4 + 4 * 4 * 12;  // its surface in mm²
    example.caption =
        "An organ, cut open, has swallowed the tool: no vertex is inside the tool and no facet crosses it. "
        "All 224 "
        "points of the tool's surface are inside the organ.";
    example.eye = {.towards = {1, -0.8, 0.4}, .centre = {0, 0, 0}, .width = 30, .height = 26, .cut = true};
    const JudgedTool tool(example.tool);
    Marks marks;
    for (const Vec3& point : tool.points()) marks.points.push_back(example.end.to_world(point));
    example.panels = {{.title = "after handling",
                       .positions = example.handled,
                       .tool = example.end,
                       .marks = std::move(marks)}};
    return example;
}

Example tool_volume_inside() {
    Example example =
        still_step("tool_volume_inside", Moment::handled,
                   make_organ("block", box({-10, -10, -7}, {10, 10, 7})), bar(3, 3, 20), tip_at(4, 0, -4));
    example.expected = 3 * 3 * 11;
    example.caption =
        "The organ, cut open, has large facets, the tool is thinner: no vertex is inside it. Of the tool 11 "
        "mm are in "
        "the organ, of 3 mm by 3 mm.";
    example.eye = {.towards = {0.7, -1, 0.5}, .centre = {0, 0, 4}, .width = 30, .height = 27, .cut = true};
    example.panels = {{.title = "after handling",
                       .positions = example.handled,
                       .tool = example.end,
                       .marks = {.segments = box_edges({2.5, -1.5, -4}, {5.5, 1.5, 7})}}};
    return example;
}

Example tool_volume_at_rest() {
    Example example =
        still_step("tool_volume_at_rest", Moment::before,
                   make_organ("block", box({-10, -10, -7}, {10, 10, 7})), bar(3, 3, 20), tip_at(4, 0, -4));
    for (Vec3& corner : example.before) corner.z() = std::min(corner.z(), -5.0);
    example.handled = example.before;
    example.deformed = example.before;
    example.expected = 3 * 3 * 11;
    example.caption =
        "The organ has been pressed flat: none of the tool is inside it. If it were at rest (the outline), "
        "11 mm of "
        "the tool would be, of 3 mm by 3 mm.";
    example.eye = {.towards = {0.7, -1, 0.5}, .centre = {0, 0, 3}, .width = 34, .height = 32, .cut = true};
    Marks outline{.segments = box_edges({-10, -10, -7}, {10, 10, 7})};
    std::ranges::copy(box_edges({2.5, -1.5, -4}, {5.5, 1.5, 7}), std::back_inserter(outline.segments));
    example.panels = {{.title = "before handling",
                       .positions = example.before,
                       .tool = example.end,
                       .marks = std::move(outline)}};
    return example;
}

}  // namespace trocar::examples
