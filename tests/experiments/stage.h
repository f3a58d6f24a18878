#pragma once

#include <string>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "experiments/scenes/scene.h"

namespace trocar {

/// An organ, its queries and a tool, to lay scenes out on.
struct Stage {
    explicit Stage(const std::string& formula, const std::string& tool_formula = "prism-12")
        : organ(make_organ_by_formula(formula)), tool(make_tool_by_formula(tool_formula)) {}

    [[nodiscard]] SceneInputs inputs(double speed, std::uint64_t seed) const {
        return {.organ = organ,
                .organ_queries = queries,
                .tool = tool,
                .speed = speed,
                .dt = 1.0 / 30,
                .seed = seed};
    }

    Organ organ;
    SurfaceQueries queries{organ.rest};
    Tool tool;
};

}  // namespace trocar
