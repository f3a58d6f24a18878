#include "common/geometry/organ_shapes.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "common/geometry/organ_shapes/shapes.h"
#include "common/nearest_name.h"

namespace trocar {
namespace {

constexpr double default_edge = 4;  // mm

double parse_edge(std::string_view formula, const OrganShape& shape) {
    if (formula == shape.name) return default_edge;
    const std::string_view text = formula.substr(shape.name.size() + 1);
    double edge = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), edge);
    if (error != std::errc() || std::string_view(end, text.end()) != "mm") {
        throw std::invalid_argument(
            fmt::format("organ \"{}\": expected an edge length in millimetres after the @, such as {}@4mm",
                        formula, shape.name));
    }
    if (std::isnan(edge) || edge < shape.shortest_edge || edge > shape.longest_edge) {
        throw std::invalid_argument(
            fmt::format("organ \"{}\": edge length {} mm: expected one from {} mm to {} mm for a {}", formula,
                        edge, shape.shortest_edge, shape.longest_edge, shape.name));
    }
    return edge;
}

}  // namespace

const std::vector<OrganShape>& all_organ_shapes() {
    static const std::vector<OrganShape> shapes = {
        {"sheet", "an open square, 120 mm wide, facing +z", 120, 0.1, 120, make_sheet},
        {"rough-sheet", "the same with irregular facets, hills and roughness", 120, 0.25, 12,
         make_rough_sheet},
        {"sphere", "a closed sphere, 80 mm in diameter", 80, 0.12, 80, make_sphere},
        {"tube", "a hollow gut, 150 mm long, 40 mm wide, its wall 4 mm thick", 150, 0.5, 10, make_tube},
        {"gallbladder", "a pear with a bent neck, 80 mm long", 80, 0.25, 8, make_gallbladder},
        {"liver", "two lobes with a notch between them and a sharp lower edge, 200 mm wide", 200, 1, 20,
         make_liver},
        {"cleft", "a rounded block, 100 mm wide, with a slit 3 mm wide and 35 mm deep", 100, 1, 12,
         make_cleft},
    };
    return shapes;
}

Organ make_organ_by_formula(std::string_view formula) {
    const std::string_view name = formula.substr(0, formula.find('@'));
    std::vector<std::string> names;
    for (const OrganShape& shape : all_organ_shapes()) {
        names.push_back(shape.name);
        if (shape.name != name) continue;
        const double edge = parse_edge(formula, shape);
        return shape.make(fmt::format("{}@{}mm", name, edge), edge, shape.default_size);
    }
    throw std::invalid_argument(unknown_name("organ", name, names));
}

}  // namespace trocar
