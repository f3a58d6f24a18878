#include "strategies/fuzzy/normals.h"

#include <algorithm>

namespace trocar::fuzzy {

OptionSpec normals_option() {
    return {.name = "normals",
            .default_value = std::string("current"),
            .summary = "facet normals of the organ as the step found it, or at rest",
            .choices = {"current", "reference"}};
}

Normals normals_of(const Options& resolved) {
    return word(resolved, "normals") == "reference" ? Normals::reference : Normals::current;
}

Vec3 organ_normal(const Contact& contact, Index facet, Normals normals) {
    return normals == Normals::reference ? contact.organ.rest_normals[facet]
                                         : facet_normal(contact.positions, contact.organ.rest.facets[facet]);
}

double collision_index(const Vec3& motion, const Vec3& normal) {
    return std::clamp(motion.dot(normal), -1.0, 1.0);
}

}  // namespace trocar::fuzzy
