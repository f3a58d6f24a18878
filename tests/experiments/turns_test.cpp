#include "experiments/turns/turns.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "experiments/turns/walks.h"
#include "results/store.h"
#include "strategies/fuzzy/rules_option.h"
#include "strategies/fuzzy/vertex_inference.h"
#include "strategies/motion_vector.h"
#include "strategies/registry.h"
#include "tests/experiments/sweep_folder.h"
#include "tests/experiments/turning_vertex.h"

namespace trocar {
namespace {

constexpr std::int64_t motions = 12 * 180 * 4 + 1;

/// A strategy made up on the spot: where the vertex goes.
class MadeUp final : public Strategy {
  public:
    using Way = std::function<Vec3(const Contact&, const Vec3& motion)>;
    explicit MadeUp(Way way) : way_(std::move(way)) {}

    [[nodiscard]] Promises promises() const override { return {}; }
    void handle(const Contact& contact, Response& response) override {
        const auto motion = motion_vector(contact, contact.positions[0]);
        response.displacements.push_back({0, way_(contact, motion.value())});
    }

  private:
    Way way_;
};

Turns turns_of(const MadeUp::Way& way, const Strength& strength = {}, std::uint64_t seed = 1) {
    MadeUp strategy(way);
    return measure_turns_at(vertex_of(seed), strategy, strength);
}

StrategyChoice choice(const std::string& name) {
    return {
        .name = name, .label = name, .options = resolve_options(find_strategy(name).description.options, {})};
}

TEST(Turns, AStrategyThatFollowsTheMotionTurnsByADegree) {
    const Turns turns = turns_of([](const Contact&, const Vec3& motion) -> Vec3 { return 3 * motion; });
    EXPECT_NEAR(turns.largest_turn, 1, 1e-9);
    EXPECT_NEAR(turns.largest_turn_with_weak, 1, 1e-9);
    EXPECT_EQ(turns.largest_turn_at_switch, 0);
    EXPECT_EQ(turns.weak, 0);
    EXPECT_EQ(turns.inputs, motions);
}

TEST(Turns, AStrategyThatAlwaysAnswersTheSameDoesNotTurn) {
    const Turns turns = turns_of([](const Contact&, const Vec3&) { return Vec3(1, 2, 3); });
    EXPECT_EQ(turns.largest_turn, 0);
    EXPECT_EQ(turns.largest_turn_at_switch, 0);
}

/// Turns by 37° where the motion passes the cone of 70° around +z.
Vec3 flipping(const Contact&, const Vec3& motion) {
    return turned(motion.z() > std::cos(70 * degree) ? 37 : 0);
}

TEST(Turns, AStrategyThatFlipsTurnsByWhatItFlips) {
    for (const std::uint64_t seed : seeds_to(5)) {
        const Turns turns = turns_of(flipping, {}, seed);
        EXPECT_NEAR(turns.largest_turn, 37, 1e-9);
        EXPECT_EQ(turns.largest_turn_at_switch, 0);
        const auto walk = turns::walk_of_motions(vertex_of(seed));
        const Vec3& there = walk.at(static_cast<std::size_t>(turns.at * 4));
        EXPECT_NEAR(angle_between(there, Vec3::UnitZ()), 70, 1);
    }
}

TEST(Turns, LeavesOutWeakInputs) {
    // Weak within 2° of where it flips: what is left lies on one side of it or the other.
    const Strength strength = [](const Contact& contact) {
        const Vec3 motion = motion_vector(contact, contact.positions[0]).value();
        return std::abs(angle_between(motion, Vec3::UnitZ()) - 70) < 2 ? 0.0999 : 0.1;
    };
    const Turns turns = turns_of(flipping, strength);
    EXPECT_EQ(turns.largest_turn, 0);
    EXPECT_NEAR(turns.largest_turn_with_weak, 37, 1e-9);
    std::int64_t weak = 0;
    for (const Vec3& motion : turns::walk_of_motions(vertex_of(1)))
        weak += std::abs(angle_between(motion, Vec3::UnitZ()) - 70) < 2 ? 1 : 0;
    EXPECT_EQ(turns.weak, weak);
    EXPECT_GT(weak, 0);
    EXPECT_EQ(turns.inputs, motions - weak);
}

TEST(Turns, WithoutDisplacementsThereIsNothingToCompare) {
    const Turns turns = turns_of([](const Contact&, const Vec3&) -> Vec3 { return Vec3::Zero(); });
    EXPECT_TRUE(std::isnan(turns.largest_turn));
    EXPECT_TRUE(std::isnan(turns.at));
    EXPECT_TRUE(std::isnan(turns.largest_turn_at_switch));
    EXPECT_EQ(turns.inputs, 0);
}

TEST(Turns, InputsFurtherApartThanADegreeAreNotCompared) {
    // Answers to motions near the cone only, on either side of a gap of 1.5°.
    const auto gapped = [](const Contact& contact, const Vec3& motion) -> Vec3 {
        const double angle = angle_between(motion, Vec3::UnitZ());
        return std::abs(angle - 70) < 0.75 ? Vec3(Vec3::Zero()) : flipping(contact, motion);
    };
    EXPECT_EQ(turns_of(gapped).largest_turn, 0);
}

TEST(Turns, NearestFaceTurnsAtSwitchesByTheAngleBetweenTwoFaces) {
    const std::vector<StrategyChoice> nearest{choice("nearest-face")};
    for (const Turns& row : measure_turns(nearest, seeds_to(20))) {
        EXPECT_EQ(row.largest_turn, 0);
        const double off_a_side = std::abs(row.largest_turn_at_switch - 30);
        const double off_the_end = std::abs(row.largest_turn_at_switch - 90);
        EXPECT_LT(std::min(off_a_side, off_the_end), 1e-6) << row.seed;
    }
}

TEST(Turns, ToolFacetTurnsByItsThreshold) {
    // From the normal to a motion at arccos 0.7071 from it, less the step that goes past the threshold.
    const double threshold = std::acos(0.7071) / degree;
    const std::vector<StrategyChoice> tool_facet{choice("tool-facet")};
    for (const Turns& row : measure_turns(tool_facet, seeds_to(20))) {
        EXPECT_LE(row.largest_turn, threshold + 1e-9);
        EXPECT_GE(row.largest_turn, threshold - 0.25);
        EXPECT_EQ(row.largest_turn_with_weak, row.largest_turn);
    }
}

/// fuzzy_per_vertex.md's bound for two motions so far apart (radians), in the terms of the one whose |d_i| is
/// `strength` |N(i)|: d_i moves by (1.5 δ (N + 1) + turn) N at most, δ = turn / 0.5858.
double allowed_turn(double turn, double strength, std::size_t facets) {
    const double moved = 1.5 * turn / 0.5858 * (static_cast<double>(facets) + 1) + turn;
    return std::asin(std::min(1.0, moved / strength)) / degree;
}

std::vector<fuzzy::FacetNormal> ring_of(const turns::SingleVertex& vertex) {
    std::vector<fuzzy::FacetNormal> facets;
    for (const Index k : vertex.organ.adjacency.ring(0)) facets.push_back({k, vertex.organ.rest_normals[k]});
    return facets;
}

TEST(Turns, FuzzyTurnsByNoMoreThanItsBound) {
    const fuzzy::Inference inference(fuzzy::rules_of(choice("fuzzy-per-vertex").options));
    int bounded = 0;
    for (const std::uint64_t seed : seeds_to(20)) {
        const auto vertex = vertex_of(seed);
        const auto strategy = make_strategy("fuzzy-per-vertex");
        const auto facets = ring_of(vertex);
        const auto walk = turns::walk_of_motions(vertex);
        std::vector<Vec3> answers;
        for (const Vec3& motion : walk) {
            Response response;
            with_contact(vertex, {motion, vertex.organ.rest.positions},
                         [&](const Contact& contact) { strategy->handle(contact, response); });
            answers.push_back(response.displacements.at(0).displacement.normalized());
        }
        for (std::size_t k = 0; k + 1 < walk.size(); ++k) {
            const Vec3 vector = fuzzy::vertex_vector(inference, {}, walk[k], facets);
            const double strength = vector.norm() / static_cast<double>(facets.size());
            if (strength < weak_strength) continue;
            const double allowed = allowed_turn(0.25 * degree, strength, facets.size());
            ASSERT_LE(angle_between(answers[k], answers[k + 1]), allowed);
            if (allowed < 10) ++bounded;
        }
    }
    EXPECT_GT(bounded, 1000);
}

TEST(Turns, OfFuzzyLeavesOutTheInputsWhoseVectorIsShort) {
    const std::vector<StrategyChoice> fuzzy{choice("fuzzy-per-vertex")};
    const fuzzy::Inference inference(fuzzy::rules_of(fuzzy[0].options));
    const std::vector<std::uint64_t> seeds{151, 1};  // a ring that is nearly folded, and one like most
    const auto rows = measure_turns(fuzzy, seeds);
    for (const Turns& row : rows) {
        const auto vertex = vertex_of(row.seed);
        const auto facets = ring_of(vertex);
        std::int64_t weak = 0;
        for (const Vec3& motion : turns::walk_of_motions(vertex)) {
            const Vec3 vector = fuzzy::vertex_vector(inference, {}, motion, facets);
            weak += vector.norm() < 0.1 * static_cast<double>(facets.size()) ? 1 : 0;
        }
        EXPECT_EQ(row.weak, weak);
        EXPECT_EQ(row.inputs, motions - weak);
    }
    EXPECT_GT(rows[0].weak, 0);
    EXPECT_GT(rows[0].largest_turn_with_weak, rows[0].largest_turn);
    EXPECT_EQ(rows[1].largest_turn_with_weak, rows[1].largest_turn);
}

std::vector<StrategyChoice> every_strategy() {
    std::vector<StrategyChoice> choices;
    for (const auto& entry : all_strategies()) choices.push_back(choice(entry.description.name));
    return choices;
}

/// A CSV file's lines, without what stands between its first two quotes: numbers after the label.
std::vector<std::vector<double>> numbers_in(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "label,seed,largest_turn,at,largest_turn_with_weak,weak,largest_turn_at_switch,inputs");
    std::vector<std::vector<double>> rows;
    while (std::getline(in, line)) {
        std::istringstream fields(line.substr(line.rfind('"') + 2));
        auto& row = rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
    }
    return rows;
}

std::vector<double> numbers_of(const Turns& row) {
    return {static_cast<double>(row.seed),
            row.largest_turn,
            row.at,
            row.largest_turn_with_weak,
            static_cast<double>(row.weak),
            row.largest_turn_at_switch,
            static_cast<double>(row.inputs)};
}

TEST(Turns, TheSameSeedsGiveTheSameBitsInTheOrderAsked) {
    const auto strategies = every_strategy();
    const std::vector<std::uint64_t> seeds{7, 3};
    const auto rows = measure_turns(strategies, seeds), again = measure_turns(strategies, seeds);
    ASSERT_EQ(rows.size(), 2 * strategies.size());
    ASSERT_EQ(again.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_EQ(rows[k].label, strategies[k / 2].label);
        EXPECT_EQ(rows[k].seed, seeds[k % 2]);
        EXPECT_EQ(numbers_of(rows[k]), numbers_of(again[k]));
    }
}

TEST(WriteTurns, KeepsEveryBit) {
    const SweepFolder folder;
    const std::vector<StrategyChoice> strategies{choice("tool-facet"), choice("joint-vertex")};
    const auto rows = measure_turns(strategies, seeds_to(2));
    write_turns(folder.path("turns.csv"), rows);
    const auto read = numbers_in(folder.path("turns.csv"));
    ASSERT_EQ(read.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(read[k], numbers_of(rows[k]));
}

TEST(WriteTurns, QuotesLabelsAndWritesNanWhereThereIsNone) {
    const SweepFolder folder;
    const double nan = std::nan("");
    write_turns(folder.path("turns.csv"), {{.label = "a \"b\", c",
                                            .seed = 4,
                                            .largest_turn = nan,
                                            .at = nan,
                                            .largest_turn_with_weak = 0.1,
                                            .weak = 2,
                                            .largest_turn_at_switch = 30,
                                            .inputs = 1}});
    std::ifstream in(folder.path("turns.csv"));
    std::string header, row;
    std::getline(in, header);
    std::getline(in, row);
    EXPECT_EQ(row, R"("a ""b"", c",4,nan,nan,0.10000000000000001,2,30,1)");
}

TEST(WriteTurns, RefusesAFolderThatIsNotThere) {
    const SweepFolder folder;
    EXPECT_THROW(write_turns(folder.path("nowhere/turns.csv"), {}), StoreError);
}

}  // namespace
}  // namespace trocar
