// How far vertices are moved, and how far from the tool they end: displacement, gap, drag. A tool in a sheet
// that ends at its middle, so that its tip is seen beneath; six vertices are inside.

#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {
namespace {

const Patch half_sheet{.columns = 9, .rows = 4, .edge = 3, .x = -12, .y = 0};
constexpr int first_column = 3;  // of the vertices inside, in rows 0 and 1
constexpr double tip = -2;       // mm

/// Each vertex inside is moved down, those of a column alike (mm).
Example pushed_down(std::string metric, const std::array<double, 3>& by) {
    Example example =
        still_step(std::move(metric), Moment::handled, half_sheet.organ(), bar(8, 8, 10), tip_at(0, 0, tip));
    for (int column = 0; column < 3; ++column) {
        for (const int row : {0, 1}) {
            example.handled[half_sheet.vertex(first_column + column, row)].z() -= by[column];
        }
    }
    example.eye = {.towards = {0.3, -1, 0.35}, .centre = {0, 3, 0}, .width = 29, .height = 21};
    return example;
}

/// From each vertex that was inside to a point, mm.
template <typename Point>
Marks marks_of(const Example& example, Point&& point) {
    Marks marks;
    for (const Index vertex : collided(example)) {
        marks.vertices.push_back(vertex);
        marks.segments.push_back({point(vertex), example.handled[vertex]});
    }
    return marks;
}

}  // namespace

Example displacement_mean() {
    Example example = pushed_down("displacement_mean", {2.5, 3, 3.5});
    example.expected = 3;
    example.caption =
        "The six vertices inside the tool are moved: two by 2.5 mm, two by 3 mm, two by 3.5 mm.";
    show_handling(example, marks_of(example, [&](Index vertex) { return example.before[vertex]; }));
    return example;
}

Example displacement_max() {
    Example example = pushed_down("displacement_max", {2.5, 2.5, 2.5});
    const Index far = half_sheet.vertex(first_column + 1, 0);
    example.handled[far] = example.before[far] + Vec3(0, -3, -4);
    example.expected = 5;
    example.caption = "Five of the six vertices inside the tool are moved by 2.5 mm, one by 5 mm.";
    show_handling(example, {.vertices = {far}, .segments = {{example.before[far], example.handled[far]}}});
    return example;
}

Example gap_mean() {
    Example example = pushed_down("gap_mean", {3 - tip, 4 - tip, 5 - tip});
    example.expected = 4;
    example.caption =
        "All six are thrown far out: 3, 4 and 5 mm beneath the tip there is a hole around the tool.";
    show_handling(example, marks_of(example, [&](Index vertex) {
                      return Vec3(example.handled[vertex].x(), example.handled[vertex].y(), tip);
                  }));
    return example;
}

Example gap_max() {
    Example example = pushed_down("gap_max", {0.5 - tip, 0.5 - tip, 0.5 - tip});
    const Index far = half_sheet.vertex(first_column + 1, 0);
    example.handled[far].z() = tip - 6;
    example.expected = 6;
    example.caption = "Five vertices end 0.5 mm outside the tool, one is thrown 6 mm away from it.";
    show_handling(example, {.vertices = {far}, .segments = {{Vec3(0, 0, tip), example.handled[far]}}});
    return example;
}

Example drag() {
    Example example = pushed_down("drag", {0.4 - tip, 0.4 - tip, 0.4 - tip});
    example.start = tip_at(-6, 0, tip);
    for (const Index vertex : collided(example)) example.handled[vertex].x() += 2;
    example.expected = 2;
    example.caption =
        "The tool slides 6 mm to the right. The vertices that it meets are put out below it, and taken along "
        "by 2 mm: "
        "the part of their way that counts.";
    show_handling(example, marks_of(example, [&](Index vertex) {
                      return Vec3(example.before[vertex].x(), example.handled[vertex].y(),
                                  example.handled[vertex].z());
                  }));
    example.panels.front() = {
        .title = "as the step begins", .positions = example.before, .tool = example.start};
    return example;
}

}  // namespace trocar::examples
