#pragma once

#include <string>

namespace trocar {

/// Takes a metric of its example and has the analysis draw it into `output`; of "all" metrics each into
/// NAME.png in the folder `output`. Throws InputError for names and folders that do not exist.
/// @returns the exit code of the analysis
int draw_metric(const std::string& metric, const std::string& output);

}  // namespace trocar
