#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace trocar {

/// A scene to look at before anything runs.
struct SceneRequest {
    std::string scene;
    std::string organ;                 ///< formula, or a mesh file
    std::optional<double> organ_size;  ///< mm, of a mesh file
    std::string tool = "prism-12";
    double speed = 100;  ///< mm/s
    std::uint64_t seed = 1;
    std::string recording;        ///< CSV file, for the scene that needs one
    std::string frame = "organ";  ///< of the recording: organ or entry
};

/// Lays the scene out, brings the organ to the state it starts from, and has the analysis draw it into
/// `output`. Throws InputError for names, files and places that do not exist.
/// @returns the exit code of the analysis
int draw_scene(const SceneRequest& request, const std::string& output);

}  // namespace trocar
