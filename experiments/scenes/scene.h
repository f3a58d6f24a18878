#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/organ.h"
#include "common/geometry/surface_queries.h"
#include "common/tool/recorded_motion.h"
#include "common/tool/tool.h"

namespace trocar {

/// A recorded motion, and what its poses are relative to.
struct Recording {
    enum class Frame {
        organ,  ///< the organ's own coordinates
        entry,  ///< the entry point: z along the normal n, x along the tangent t
    };
    RecordedMotion motion;
    Frame frame = Frame::organ;
};

/// What a scene is laid out from. Nothing of a strategy is in it.
struct SceneInputs {
    const Organ& organ;
    const SurfaceQueries& organ_queries;  ///< of the organ at rest
    const Tool& tool;
    double speed;  ///< mm/s
    double dt;     ///< s
    std::uint64_t seed;
    const Recording* recording = nullptr;  ///< of a scene that needs one
};

/// Where a seed put the tool.
struct Placement {
    Vec3 entry;    ///< point of the organ at rest, mm
    Vec3 normal;   ///< unit: mean outer normal within two tool radii of the entry point
    Vec3 tangent;  ///< unit, orthogonal to the normal
    double phase;  ///< in [0, 1): how much of a full step the first step is
};

/// How a tool that starts inside the organ came there.
struct Insertion {
    Vec3 direction;  ///< unit: it was pushed straight this way, without turning
    double length;   ///< mm, from where it was clear of the organ
};

/// A scene laid out: where the tool is at the end of every step, in the frame of the organ at rest.
struct ScenePlan {
    Pose start;
    std::vector<Pose> poses;             ///< at the end of each step
    std::optional<Insertion> insertion;  ///< of a tool that starts inside (see reference_state)
};

/// The seed leads to no place that the scene allows on this organ.
struct PlacementError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A scene that can be laid out.
struct SceneEntry {
    std::string name;
    std::string summary;                                      ///< one line
    Placement (*place)(const SceneInputs&);                   ///< throws PlacementError
    ScenePlan (*plan)(const SceneInputs&, const Placement&);  ///< what place answered
    bool needs_recording = false;  ///< the motion, its speed included, comes from a file
};

/// Every scene of this build, in the order in which they are listed to users.
const std::vector<SceneEntry>& all_scenes();

/// Throws std::invalid_argument, naming the nearest right name, when there is none of that name.
const SceneEntry& find_scene(std::string_view name);

}  // namespace trocar
