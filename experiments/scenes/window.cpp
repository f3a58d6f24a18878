#include "experiments/scenes/window.h"

#include "common/detection/detector.h"

namespace trocar {
namespace {

bool same(const Pose& a, const Pose& b) { return a.position == b.position && a.rotation == b.rotation; }

}  // namespace

std::vector<bool> window_of(const SceneInputs& inputs, const std::vector<Pose>& poses) {
    Detector detector(inputs.organ);
    Detected found;
    std::vector<bool> window;
    window.reserve(poses.size());
    for (std::size_t k = 0; k < poses.size(); ++k) {
        if (k > 0 && same(poses[k], poses[k - 1])) {
            window.push_back(window.back());
            continue;
        }
        detector.detect(inputs.organ.rest.positions, inputs.tool, ToolMotion(poses[k], poses[k]), found);
        const bool swallowed =
            inputs.organ.adjacency.closed() &&
            inputs.organ_queries.contains(poses[k].to_world(inputs.tool.mesh.positions[0]));
        window.push_back(!found.collided.empty() || !found.crossed.empty() || swallowed);
    }
    return window;
}

}  // namespace trocar
