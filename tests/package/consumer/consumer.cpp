#include <iostream>

#include "common/cycle/cycle.h"
#include "common/tool/tool_shapes.h"
#include "strategies/registry.h"

using namespace trocar;

int main() {
    // Lengths in mm; facets run counter-clockwise seen from outside.
    const Organ organ = make_organ(
        "tetrahedron", {.positions = {{0, 0, 10}, {20, 0, -10}, {-10, 17, -10}, {-10, -17, -10}},
                        .facets = {Facet{0, 1, 2}, Facet{0, 2, 3}, Facet{0, 3, 1}, Facet{1, 3, 2}}});
    const Tool tool = make_prism(12);
    const auto strategy = make_strategy("fuzzy-per-vertex");

    // From 2 mm above the organ's top to 1 mm below it, in one step.
    const CycleStart start = start_at_rest(organ, {.position = {0, 0, 12}});
    Cycle cycle(organ, tool, start, CycleSettings{}, SpringSettings{});
    cycle.move({.position = {0, 0, 9}});
    cycle.detect();
    cycle.handle([&](const Contact& contact, Response& response) { strategy->handle(contact, response); });

    for (const Index vertex : cycle.detected().collided) {
        const Vec3& x = cycle.positions()[vertex];
        std::cout << "vertex " << vertex << " goes to " << x.transpose() << " mm, "
                  << (cycle.tool().contains(x) ? "inside" : "outside") << " the tool\n";
    }
}
