#include "experiments/cli/vertex_story.h"

#include <fmt/format.h>

#include "strategies/fuzzy/fired_rules.h"

namespace trocar {
namespace {

/// Six decimals; no minus before a zero.
std::string number_text(double number) {
    const std::string text = fmt::format("{:.6f}", number);
    return text == "-0.000000" ? "0.000000" : text;
}

}  // namespace

std::string vector_text(const Vec3& vector) {
    return fmt::format("({}, {}, {})", number_text(vector.x()), number_text(vector.y()),
                       number_text(vector.z()));
}

namespace {

std::string weights_text(const fuzzy::Weights& weights) {
    return fmt::format("I_P {}, I_S {}, I_E {}", number_text(weights.penetration),
                       number_text(weights.sliding), number_text(weights.extraction));
}

/// "penetration 0.931717, sliding 0.068283": the terms that hold at all.
std::string told_terms(const fuzzy::RuleBase& rules, double collision_index) {
    std::string text;
    for (const auto& [term, degree] :
         fuzzy::term_degrees(rules, fuzzy::Input::collision_index, collision_index)) {
        if (degree > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", term, number_text(degree));
    }
    return text.empty() ? "no term" : text;
}

std::string told_rules(const fuzzy::RuleBase& rules, const fuzzy::FacetShare& share) {
    std::string text;
    for (const auto& [rule, strength] :
         fuzzy::fired_rules(rules, {share.collision_index, share.previous, share.first})) {
        text += fmt::format("    {}  {}  (line {})\n", number_text(strength), rule->text, rule->line);
    }
    return text.empty() ? "    no rule fires\n" : text;
}

std::string told_share(const fuzzy::FacetShare& share, std::size_t number, std::size_t count,
                       const fuzzy::RuleBase& rules, const fuzzy::VertexReading& reading) {
    std::string text = fmt::format("facet {} of {} (number {}): n = {}\n", number, count, share.facet,
                                   vector_text(share.normal));
    text += fmt::format("  I_C = v_m . n = {}: {}\n", number_text(share.collision_index),
                        told_terms(rules, share.collision_index));
    if (reading.always_penetration) {
        text += "  no rule is asked: case = \"penetration\"\n";
    } else {
        text +=
            fmt::format("  {}; rules that fire:\n",
                        share.first ? "first facet (C_1 is YES)"
                                    : fmt::format("C_1 is NO, before it {}", weights_text(share.previous)));
        text += told_rules(rules, share);
    }
    text += fmt::format("  {}\n", weights_text(share.weights));
    return text + fmt::format("  I_P v_m - I_S n - I_E v_m = {}\n", vector_text(share.vector));
}

const char* aggregate_told(fuzzy::Aggregate aggregate) {
    switch (aggregate) {
        case fuzzy::Aggregate::sum:
            return "the sum of the facets' vectors";
        case fuzzy::Aggregate::last:
            return "the last facet's vector";
        case fuzzy::Aggregate::mean_normal:
            break;
    }
    return "the last facet's weights with the mean normal";
}

}  // namespace

VertexStory story_of(const fuzzy::RuleBase& rules, const fuzzy::VertexReading& reading, const Vec3& motion,
                     std::span<const fuzzy::FacetNormal> facets) {
    VertexStory story{.motion = motion, .shares = {}, .vector = {}, .direction = {}};
    const fuzzy::Inference inference(rules);
    story.vector = fuzzy::vertex_vector(inference, reading, motion, facets, &story.shares);
    story.direction = fuzzy::direction_of(story.vector, facets.size());
    return story;
}

std::string told(const VertexStory& story, const fuzzy::RuleBase& rules,
                 const fuzzy::VertexReading& reading) {
    std::string text = fmt::format("v_m = {}\n\n", vector_text(story.motion));
    for (std::size_t k = 0; k < story.shares.size(); ++k) {
        text += told_share(story.shares[k], k + 1, story.shares.size(), rules, reading) + "\n";
    }
    text += fmt::format("d = {} = {}, |d| = {}\n", aggregate_told(reading.aggregate),
                        vector_text(story.vector), number_text(story.vector.norm()));
    return text + (story.direction ? fmt::format("direction d / |d| = {}\n", vector_text(*story.direction))
                                   : std::string("d is too short to name a direction\n"));
}

}  // namespace trocar
