#pragma once

#include <string>

namespace trocar {

/// What the analysis cannot know from a file: "depth_max=low,edge_ratio_min=high,…".
std::string better_directions();

}  // namespace trocar
