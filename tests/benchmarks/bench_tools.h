#pragma once

#include <array>

#include "common/tool/tool.h"

namespace trocar {

/// A tool that is measured.
struct BenchTool {
    const char* name;
    Tool (*make)();
};

/// prism-12, which is convex; grasper, which is not; curved-hook, not convex, of 1,052 facets of which hardly
/// two lie in one plane: a round bar that comes down, turns by half a circle and goes up again, its lowest
/// point at the origin.
extern const std::array<BenchTool, 3> bench_tools;

}  // namespace trocar
