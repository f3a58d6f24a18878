#include "common/tool/tool_shapes.h"

#include <charconv>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "common/nearest_name.h"

namespace trocar {
namespace {

constexpr std::string_view number = "N";  // stands for the number of sides in a shape's name

struct Formula {
    ToolShape shape;
    Tool (*make)(int sides);
};

const std::vector<Formula>& formulas() {
    static const std::vector<Formula> all{
        {{"prism-N", "a straight prism of N sides (3 to 64), 4 mm in radius, 80 mm long, with flat ends"},
         [](int sides) { return make_prism(sides); }},
        {{"pointed-prism-N", "the same with a pyramid of 8 mm as its tip"},
         [](int sides) { return make_pointed_prism(sides); }},
        {{"needle", "0.75 mm in radius, 80 mm long, with a tip of 5 degrees and 16 sides"},
         [](int) { return make_needle(); }},
        {{"grasper",
          "open jaws, not convex: 18 mm long, 20 degrees from the axis each, on a shaft of 2.5 mm in radius"},
         [](int) { return make_grasper(); }},
    };
    return all;
}

/// The sides that `text` states in the place of N; 0 for a shape without.
int sides_of(std::string_view formula, std::string_view text, const ToolShape& shape) {
    if (text.empty() && !shape.name.ends_with(number)) return 0;
    int sides = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), sides);
    if (error == std::errc() && end == text.end() && sides >= fewest_sides && sides <= most_sides)
        return sides;
    const std::string_view stem(shape.name.data(), shape.name.size() - number.size());
    throw std::invalid_argument(fmt::format(
        "tool \"{}\": expected {}, N a whole number from 3 to 64, such as {}12", formula, shape.name, stem));
}

}  // namespace

const std::vector<ToolShape>& all_tool_shapes() {
    static const std::vector<ToolShape> shapes = [] {
        std::vector<ToolShape> all;
        for (const Formula& formula : formulas()) all.push_back(formula.shape);
        return all;
    }();
    return shapes;
}

Tool make_tool_by_formula(std::string_view formula) {
    std::vector<std::string> names;
    for (const auto& [shape, make] : formulas()) {
        const bool numbered = shape.name.ends_with(number);
        const std::string_view stem(shape.name.data(), shape.name.size() - (numbered ? number.size() : 0));
        if (numbered ? formula.starts_with(stem) : formula == stem) {
            return make(sides_of(formula, formula.substr(stem.size()), shape));
        }
        names.push_back(shape.name);
    }
    throw std::invalid_argument(unknown_name("tool", formula, names));
}

}  // namespace trocar
