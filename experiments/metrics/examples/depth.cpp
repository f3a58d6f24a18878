// A tool in a sheet that ends at its middle, so that its tip is seen beneath.

#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {
namespace {

const Patch half_sheet{.columns = 9, .rows = 4, .edge = 3, .x = -12, .y = 0};

/// The six vertices inside are put below the tip, but for those of the first row that stay where they are.
Example leave(std::string metric, const std::vector<Index>& left) {
    Example example =
        still_step(std::move(metric), Moment::handled, half_sheet.organ(), bar(8, 8, 12), tip_at(0, 0, -2));
    for (const Index vertex : collided(example)) example.handled[vertex].z() = -2.4;
    for (const Index vertex : left) example.handled[vertex].z() = 0;
    example.eye = {.towards = {0.3, -1, 0.4}, .centre = {0, 3, 2.4}, .width = 29, .height = 18};
    return example;
}

}  // namespace

Example depth_max() {
    const Index middle = half_sheet.vertex(4, 0);
    Example example = leave("depth_max", {middle});
    example.expected = 2;
    example.caption =
        "Six vertices were inside. One is left, 2 mm from the nearest point of the tool's surface, its tip.";
    show_handling(example, {.vertices = {middle}, .segments = {{Vec3(0, 0, 0), Vec3(0, 0, -2)}}});
    return example;
}

Example depth_mean() {
    const std::vector<Index> row = {half_sheet.vertex(3, 0), half_sheet.vertex(4, 0),
                                    half_sheet.vertex(5, 0)};
    Example example = leave("depth_mean", row);
    example.expected = (1.0 + 2 + 1) / 3;
    example.caption =
        "Three vertices are left inside: two of them 1 mm from the tool's sides, one 2 mm from its tip.";
    show_handling(example, {.vertices = row,
                            .segments = {{Vec3(-3, 0, 0), Vec3(-4, 0, 0)},
                                         {Vec3(0, 0, 0), Vec3(0, 0, -2)},
                                         {Vec3(3, 0, 0), Vec3(4, 0, 0)}}});
    return example;
}

}  // namespace trocar::examples
