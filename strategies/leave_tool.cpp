#include "strategies/leave_tool.h"

#include "strategies/nearest_face.h"

namespace trocar {

OptionSpec fallback_option() {
    return {.name = "fallback",
            .default_value = std::string("nearest-face"),
            .summary = "a vertex without a direction goes to the nearest face, or stays where it is",
            .choices = {"nearest-face", "stay"}};
}

Fallback fallback_of(const Options& resolved) {
    return word(resolved, "fallback") == "stay" ? Fallback::stay : Fallback::nearest_face;
}

void leave_tool(const Contact& contact, Index vertex, const std::optional<Vec3>& direction, Fallback fallback,
                Response& response) {
    if (direction) {
        const double exit =
            contact.tool.exit_distance(contact.positions[vertex], *direction, contact.clearance);
        response.displacements.push_back({vertex, exit * *direction});
        return;
    }
    ++response.fallbacks;
    if (fallback == Fallback::nearest_face) {
        response.displacements.push_back({vertex, nearest_face_displacement(contact, vertex)});
    }
}

}  // namespace trocar
