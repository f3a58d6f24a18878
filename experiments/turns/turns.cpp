#include "experiments/turns/turns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "common/tool/tool_shapes.h"
#include "experiments/turns/walks.h"
#include "strategies/fuzzy/rules_option.h"
#include "strategies/fuzzy/vertex_inference.h"
#include "strategies/motion_vector.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

using turns::SingleVertex;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr const char* tool_name = "prism-12";
constexpr std::size_t switch_stride = 30 * turns::steps_a_degree;  // of the motions asked at a switch

/// What a strategy made of one motion.
struct Answer {
    Vec3 direction = Vec3::Zero();  // of the displacement; zero where there is none
    bool weak = false;

    [[nodiscard]] bool counts(bool with_weak) const {
        return direction != Vec3::Zero() && (with_weak || !weak);
    }
};

/// Of two answers, and how far on the walk it was.
struct LargestTurn {
    double degrees = none, at = none;

    void offer(const Vec3& one, const Vec3& other, double where) {
        const double turn = std::atan2(one.cross(other).norm(), one.dot(other)) * 180 / std::numbers::pi;
        if (turn <= degrees) return;
        degrees = turn;
        at = where;
    }
};

Answer ask(const Contact& contact, Strategy& strategy, const Strength& strength) {
    Response response;
    strategy.handle(contact, response);
    Answer answer;
    const auto moved = std::ranges::find(response.displacements, 0, &VertexDisplacement::vertex);
    if (moved != response.displacements.end() && moved->displacement.norm() > 0)
        answer.direction = moved->displacement.normalized();
    answer.weak = strength && strength(contact) < weak_strength;
    return answer;
}

std::vector<Answer> ask_all(const SingleVertex& vertex, const std::vector<Vec3>& motions, Strategy& strategy,
                            const Strength& strength) {
    std::vector<Answer> answers;
    answers.reserve(motions.size());
    for (const Vec3& motion : motions) {
        answers.push_back(with_contact(vertex, {motion, vertex.organ.rest.positions},
                                       [&](const Contact& c) { return ask(c, strategy, strength); }));
    }
    return answers;
}

LargestTurn largest_turn(const std::vector<Answer>& answers, bool with_weak) {
    LargestTurn largest;
    for (std::size_t k = 0; k < answers.size(); ++k) {
        if (!answers[k].counts(with_weak)) continue;
        const std::size_t end = std::min(k + turns::steps_a_degree + 1, answers.size());
        for (std::size_t next = k + 1; next < end; ++next) {
            if (!answers[next].counts(with_weak)) continue;
            const double where = turns::step * static_cast<double>(k + next) / 2;
            largest.offer(answers[k].direction, answers[next].direction, where);
        }
    }
    return largest;
}

double largest_turn_at_switch(const SingleVertex& vertex, const std::vector<Vec3>& motions,
                              Strategy& strategy) {
    LargestTurn largest;
    for (const turns::Switch& one : turns::find_switches(vertex)) {
        for (std::size_t k = 0; k < motions.size(); k += switch_stride) {
            const auto asked = [&](const std::vector<Vec3>& positions) {
                return with_contact(vertex, {motions[k], positions},
                                    [&](const Contact& c) { return ask(c, strategy, {}); });
            };
            const Answer here = asked(one.positions[0]), next = asked(one.positions[1]);
            if (here.counts(true) && next.counts(true)) largest.offer(here.direction, next.direction, 0);
        }
    }
    return largest.degrees;
}

/// Of fuzzy-per-vertex, from its own inference; none for other strategies.
Strength strength_of(const StrategyChoice& choice) {
    if (choice.name != "fuzzy-per-vertex") return {};
    const auto inference = std::make_shared<const fuzzy::Inference>(fuzzy::rules_of(choice.options));
    const fuzzy::VertexReading reading = fuzzy::vertex_reading_of(choice.options);
    return [inference, reading](const Contact& contact) {
        const Index vertex = contact.collided.front();
        const auto motion = motion_vector(contact, contact.positions[vertex]);
        if (!motion) return 0.0;
        std::vector<fuzzy::FacetNormal> facets;
        fuzzy::gather_facets(contact, vertex, *motion, reading, facets);
        const Vec3 vector = fuzzy::vertex_vector(*inference, reading, *motion, facets);
        return vector.norm() / static_cast<double>(facets.size());
    };
}

}  // namespace

Turns measure_turns_at(const SingleVertex& vertex, Strategy& strategy, const Strength& strength) {
    const std::vector<Vec3> motions = turns::walk_of_motions(vertex);
    const std::vector<Answer> answers = ask_all(vertex, motions, strategy, strength);
    const LargestTurn largest = largest_turn(answers, false);
    const auto compared = [](const Answer& answer) { return answer.counts(false); };
    return {.label = {},
            .seed = 0,
            .largest_turn = largest.degrees,
            .at = largest.at,
            .largest_turn_with_weak = largest_turn(answers, true).degrees,
            .weak = std::ranges::count_if(answers, &Answer::weak),
            .largest_turn_at_switch = largest_turn_at_switch(vertex, motions, strategy),
            .inputs = std::ranges::count_if(answers, compared)};
}

std::vector<Turns> measure_turns(std::span<const StrategyChoice> strategies,
                                 std::span<const std::uint64_t> seeds) {
    const auto tool = std::make_shared<const Tool>(make_tool_by_formula(tool_name));
    std::vector<Turns> rows;
    for (const StrategyChoice& choice : strategies) {
        const Strength strength = strength_of(choice);
        for (const std::uint64_t seed : seeds) {
            const auto strategy = make_strategy(choice.name, choice.options);
            Turns row = measure_turns_at(turns::draw_single_vertex(tool, seed), *strategy, strength);
            row.label = choice.label;
            row.seed = seed;
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

}  // namespace trocar
