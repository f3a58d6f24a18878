#include "experiments/metrics/examples/example_list.h"
#include "experiments/metrics/examples/example_parts.h"

namespace trocar::examples {

Example facets_crossing() {
    const Patch patch = centred_patch(4, 8);
    Example example =
        still_step("facets_crossing", Moment::handled, patch.organ(), bar(1, 1, 14), tip_at(1.5, -1.5, -4));
    example.expected = 1;
    example.caption =
        "A needle goes through the middle of a facet. No vertex is inside it, so there is nothing to "
        "handle: "
        "vertices_inside is 0 although the needle is 4 mm deep.";
    example.eye.centre = {0, 0, 2};
    example.eye.height = 20;
    example.panels = {{.title = "after handling",
                       .positions = example.handled,
                       .tool = example.end,
                       .marks = {.facets = {patch.lower(1, 1)}}}};
    return example;
}

}  // namespace trocar::examples
