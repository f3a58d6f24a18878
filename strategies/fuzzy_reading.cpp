#include "strategies/fuzzy_reading.h"

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

OptionSpec memberships_option() {
    return {
        .name = "memberships",
        .default_value = std::string("ramp"),
        .summary = "how the interaction cases pass into one another around 45°: linearly, smoothly, at once",
        .choices = {"ramp", "smooth", "crisp"}};
}

Shape shape_of(const Options& resolved) {
    const std::string& shape = word(resolved, "memberships");
    return shape == "ramp" ? Shape::ramp : shape == "smooth" ? Shape::smooth : Shape::crisp;
}

}  // namespace trocar::fuzzy
