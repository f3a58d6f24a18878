#include "experiments/metrics/examples/example_parts.h"

#include "common/tool/shape_parts.h"
#include "experiments/metrics/judge/judged_state.h"

namespace trocar::examples {

Organ Patch::organ() const {
    SurfaceMesh mesh;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            mesh.positions.emplace_back(x + edge * column, y + edge * row, 0);
            if (row + 1 == rows || column + 1 == columns) continue;
            const Index a = vertex(column, row), b = vertex(column + 1, row), c = vertex(column + 1, row + 1),
                        d = vertex(column, row + 1);
            mesh.facets.push_back({a, b, c});
            mesh.facets.push_back({a, c, d});
        }
    }
    return make_organ("patch", mesh);
}

Patch centred_patch(int vertices_across, double edge) {
    const double low = -edge * (vertices_across - 1) / 2;
    return {.columns = vertices_across, .rows = vertices_across, .edge = edge, .x = low, .y = low};
}

SurfaceMesh box(const Vec3& low, const Vec3& high) {
    SurfaceMesh mesh;
    for (const double z : {low.z(), high.z()}) {
        mesh.positions.emplace_back(low.x(), low.y(), z);
        mesh.positions.emplace_back(high.x(), low.y(), z);
        mesh.positions.emplace_back(high.x(), high.y(), z);
        mesh.positions.emplace_back(low.x(), high.y(), z);
    }
    add_side(mesh, 0, 3, 2, 1);
    add_side(mesh, 4, 5, 6, 7);
    for (const Index k : {0, 1, 2, 3}) {
        const Index next = (k + 1) % 4;
        add_side(mesh, k, next, next + 4, k + 4);
    }
    return mesh;
}

Tool bar(double width_x, double width_y, double length) {
    const Vec3 half(width_x / 2, width_y / 2, 0);
    return make_tool("bar", box(-half, half + Vec3(0, 0, length)));
}

Pose tip_at(double x, double y, double z) { return {.rotation = Mat3::Identity(), .position = {x, y, z}}; }

std::vector<Index> collided(const Example& example) {
    const JudgedOrgan organ(example.organ);
    const JudgedTool tool(example.tool);
    const JudgedState before(organ, tool, example.before, example.end);
    return before.inside();
}

void show_handling(Example& example, Marks marks) {
    example.panels = {{.title = "before handling", .positions = example.before, .tool = example.end},
                      {.title = "after handling",
                       .positions = example.handled,
                       .tool = example.end,
                       .from = example.before,
                       .marks = std::move(marks)}};
}

}  // namespace trocar::examples
