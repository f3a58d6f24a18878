#include "experiments/run/ring_shifts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/cycle/cycle.h"
#include "experiments/metrics/judge/judge.h"
#include "strategies/registry.h"
#include "tests/strategies/scenes.h"
#include "tests/strategies/single_vertex.h"

namespace trocar {
namespace {

using contract::Scene;

constexpr double rounding = 1e-5;  // degrees

/// A strategy that does what a test tells it to.
class Scripted : public Strategy {
  public:
    explicit Scripted(Handler handler) : handler_(std::move(handler)) {}
    [[nodiscard]] Promises promises() const override { return {}; }
    void handle(const Contact& contact, Response& response) override { handler_(contact, response); }

  private:
    Handler handler_;
};

/// Sends every collided vertex along the normal of the facet at which its ring begins.
void along_first_facet(const Contact& contact, Response& response) {
    for (const Index vertex : contact.collided) {
        const Index first = contact.organ.adjacency.ring(vertex).front();
        response.displacements.push_back(
            {vertex, facet_normal(contact.positions, contact.organ.rest.facets[first])});
    }
}

/// The so-manieth random scene in which several vertices collide.
Scene crowded_scene(int number) {
    for (std::uint64_t seed = 0;; ++seed) {
        Scene scene = contract::random_scene(seed);
        if (scene.detected.collided.size() > 3 && number-- == 0) return scene;
    }
}

ShiftedAnswers ask(Strategy& strategy, const Scene& scene, const Description& description = {}) {
    RingShifts shifts(*scene.organ);
    return scene.with_contact(
        [&](const Contact& contact) { return shifts.ask(strategy, description, contact); });
}

ShiftedAnswers ask(const std::string& strategy, const Scene& scene, const Options& options = {}) {
    return ask(*make_strategy(strategy, options), scene, find_strategy(strategy).description);
}

/// The metric of these answers to the scene.
Measured measured(const std::string& metric, const Scene& scene, const ShiftedAnswers& answers) {
    const JudgedOrgan organ(*scene.organ);
    const JudgedTool tool(*scene.tool);
    Judge judge({organ, tool, scene.positions, scene.before},
                {.metrics = choose_metrics(metric), .region = {}, .every = 1});
    judge.before(scene.positions, scene.after);
    judge.handled(scene.positions, 0, [&] { return answers; });
    return choose_metrics(metric).front()->value(judge.step(), Moment::handled);
}

double order_spread(const std::string& strategy, const Scene& scene, const Options& options = {}) {
    return measured("order_spread", scene, ask(strategy, scene, options)).value;
}

const Vec3 inside(0.3, 0.2, 1.5);

/// A ridge along x, its sides `slope` (radians) below the horizontal; see single_vertex.h.
std::vector<Vec3> ridge(double slope) {
    const double down = -std::tan(slope);
    return {inside + Vec3(1, 0, 0), inside + Vec3(0, 1, down), inside + Vec3(-1, 0, 0),
            inside + Vec3(0, -1, down)};
}

/// The scene with its facets numbered so that the ring of `vertex` begins at `facet`, which becomes the first
/// of all; the others follow in their order.
Scene with_first_facet(const Scene& scene, Index facet) {
    SurfaceMesh rest = scene.organ->rest;
    std::rotate(rest.facets.begin(), rest.facets.begin() + facet, rest.facets.begin() + facet + 1);
    Scene other = scene;
    other.organ = std::make_shared<const Organ>(make_organ(scene.organ->name, std::move(rest)));
    for (std::vector<Index>* list : {&other.detected.crossed, &other.detected.near_facets}) {
        for (Index& entry : *list) entry = entry == facet ? 0 : entry < facet ? entry + 1 : entry;
        std::ranges::sort(*list);
    }
    return other;
}

Vec3 displacement_of(Index vertex, const std::vector<VertexDisplacement>& displacements) {
    return std::ranges::find(displacements, vertex, &VertexDisplacement::vertex)->displacement;
}

/// By Kahan's formula, degrees; not that of the metric.
double angle_between(const Vec3& a, const Vec3& b) {
    const Vec3 one = a.normalized(), other = b.normalized();
    return 2 * std::atan2((one - other).norm(), (one + other).norm()) * 180 / std::numbers::pi;
}

const std::vector<Options>& readings() {
    static const std::vector<Options> all{{},
                                          {{"aggregate", std::string("last")}},
                                          {{"aggregate", std::string("mean-normal")}},
                                          {{"order", std::string("strongest-first")}}};
    return all;
}

TEST(RingShifts, AreWhatNumberingFacetsAnewGives) {
    // The brute-force way: an organ whose facets are numbered so that the ring begins at each of them in
    // turn.
    double widest_seen = 0;
    for (int number = 0; number < 4; ++number) {
        const Scene scene = crowded_scene(number);
        const Options& options = readings()[static_cast<std::size_t>(number)];
        const ShiftedAnswers answers = ask("fuzzy-per-vertex", scene, options);
        ASSERT_EQ(answers.missing, Missing::nothing);
        double widest = 0, sum = 0;
        for (const Index at : scene.detected.collided) {
            const auto ring = scene.organ->adjacency.ring(at);
            std::vector<Vec3> directions;
            for (std::size_t shift = 0; shift < ring.size(); ++shift) {
                const Scene renumbered = with_first_facet(scene, ring[shift]);
                ASSERT_EQ(renumbered.organ->adjacency.ring(at).front(), 0);
                const Response expected = contract::answer_of("fuzzy-per-vertex", renumbered, options);
                directions.push_back(displacement_of(at, expected.displacements));
                EXPECT_EQ(displacement_of(at, answers.displacements[shift]), directions.back());
            }
            double spread = 0;
            for (const Vec3& one : directions) {
                for (const Vec3& other : directions) spread = std::max(spread, angle_between(one, other));
            }
            widest = std::max(widest, spread);
            sum += spread;
        }
        EXPECT_NEAR(measured("order_spread", scene, answers).value, widest, rounding);
        EXPECT_NEAR(measured("order_spread_mean", scene, answers).value,
                    sum / static_cast<double>(scene.detected.collided.size()), rounding);
        widest_seen = std::max(widest_seen, widest);
    }
    EXPECT_GT(widest_seen, 1) << "degrees: nothing was compared";
}

RC_GTEST_PROP(RingShifts, DoNotDependOnHowFacetsAreNumbered, ()) {
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
    const Scene scene = contract::random_scene(seed, "prism-12");
    const Scene renumbered = contract::with_facets_renumbered(scene, seed).scene;
    for (const char* metric : {"order_spread", "order_spread_mean"}) {
        const double value = measured(metric, scene, ask("fuzzy-per-vertex", scene)).value;
        RC_ASSERT(value == measured(metric, renumbered, ask("fuzzy-per-vertex", renumbered)).value);
    }
}

TEST(RingShifts, DoNotMatterToStrategiesThatPromiseSo) {
    for (int number = 0; number < 10; ++number) {
        const Scene scene = crowded_scene(number);
        EXPECT_EQ(order_spread("nearest-face", scene), 0);
        EXPECT_EQ(order_spread("cylinder-axis", scene), 0);
        EXPECT_LT(order_spread("fuzzy-per-vertex", scene, {{"feedback", false}}), rounding);
        EXPECT_LT(order_spread("fuzzy-per-vertex", scene, {{"case", std::string("penetration")}}), rounding);
        EXPECT_LT(order_spread("average-plane", scene), rounding);
        EXPECT_LT(order_spread("joint-vertex", scene), rounding);
    }
}

TEST(RingShifts, MatterToFeedbackOnARidgeAndNotOnFlatGround) {
    const Vec3 motion(0.2, -0.5, -1);
    const Scene flat = contract::single_vertex(inside, contract::flat_base(inside), motion);
    const Scene sharp = contract::single_vertex(inside, ridge(std::numbers::pi / 3), motion);
    EXPECT_LT(order_spread("fuzzy-per-vertex", flat), rounding);
    EXPECT_GT(order_spread("fuzzy-per-vertex", sharp), 5);
    EXPECT_LT(order_spread("fuzzy-per-vertex", sharp, {{"feedback", false}}), rounding);
}

TEST(RingShifts, BeginAtEachFacetInTurn) {
    // The ridge's facets have two normals, 2 · 60° apart.
    const Scene scene = contract::single_vertex(inside, ridge(std::numbers::pi / 3), {0, 0, -1});
    Scripted strategy(along_first_facet);
    const ShiftedAnswers answers = ask(strategy, scene);
    ASSERT_EQ(answers.displacements.size(), 4U);
    for (Index shift = 0; shift < 4; ++shift) {
        const Facet& facet = scene.organ->rest.facets[scene.organ->adjacency.ring(0)[shift]];
        EXPECT_EQ(answers.displacements[shift].at(0).displacement, facet_normal(scene.positions, facet))
            << shift;
    }
    EXPECT_NEAR(measured("order_spread", scene, answers).value, 120, 1e-9);
}

TEST(RingShifts, ChangeNothingElseInTheContact) {
    const Scene scene = crowded_scene(3);
    scene.with_contact([&](const Contact& given) {
        Scripted strategy([&](const Contact& asked, Response&) {
            EXPECT_NE(&asked.organ, &given.organ);
            EXPECT_EQ(asked.organ.rest.facets, given.organ.rest.facets);
            EXPECT_EQ(asked.positions.data(), given.positions.data());
            EXPECT_EQ(asked.velocities.data(), given.velocities.data());
            EXPECT_EQ(&asked.tool, &given.tool);
            EXPECT_EQ(&asked.motion, &given.motion);
            EXPECT_EQ(asked.collided.data(), given.collided.data());
            EXPECT_EQ(asked.crossed.data(), given.crossed.data());
            EXPECT_EQ(asked.near_vertices.data(), given.near_vertices.data());
            EXPECT_EQ(asked.near_facets.data(), given.near_facets.data());
            EXPECT_EQ(asked.clearance, given.clearance);
            EXPECT_EQ(asked.dt, given.dt);
        });
        RingShifts(*scene.organ).ask(strategy, {}, given);
    });
}

TEST(RingShifts, ReachCollidedVerticesAloneAndAreTakenBack) {
    const Scene scene = crowded_scene(3);
    const Adjacency& original = scene.organ->adjacency;
    RingShifts shifts(*scene.organ);
    scene.with_contact([&](Contact contact) {
        const auto all = contact.collided;
        const auto expect_shifted = [&](std::span<const Index> collided) {
            std::size_t shift = 0;
            Scripted strategy([&](const Contact& asked, Response&) {
                for (Index at = 0; static_cast<std::size_t>(at) < scene.positions.size(); ++at) {
                    const auto ring = original.ring(at), now = asked.organ.adjacency.ring(at);
                    const bool is_collided = std::ranges::find(collided, at) != collided.end();
                    EXPECT_EQ(now.front(), ring[is_collided ? shift % ring.size() : 0]) << at;
                }
                ++shift;
            });
            contact.collided = collided;
            shifts.ask(strategy, {}, contact);
        };
        expect_shifted(all);
        expect_shifted(all.first(1));
        Scripted throwing([&](const Contact& asked, Response&) {
            if (asked.organ.adjacency.ring(all[0]).front() == original.ring(all[0])[2])
                throw std::runtime_error("no");
        });
        contact.collided = all;
        EXPECT_EQ(shifts.ask(throwing, {}, contact).missing, Missing::no_answer);
        expect_shifted(all.last(1));
    });
}

TEST(RingShifts, OfAStrategyThatKeepsStateAreNotAsked) {
    int calls = 0;
    Scripted strategy([&](const Contact&, Response&) { ++calls; });
    const Scene scene = crowded_scene(3);
    Description keeping;
    keeping.keeps_state = true;
    const ShiftedAnswers answers = ask(strategy, scene, keeping);
    EXPECT_EQ(answers.missing, Missing::keeps_state);
    EXPECT_EQ(measured("order_spread", scene, answers).missing, Missing::keeps_state);
    EXPECT_EQ(calls, 0);
}

TEST(RingShifts, WithoutCollidedVerticesThereIsNothingToAsk) {
    int calls = 0;
    Scripted strategy([&](const Contact&, Response&) { ++calls; });
    Scene scene = crowded_scene(3);
    scene.detected.collided.clear();
    EXPECT_TRUE(ask(strategy, scene).displacements.empty());
    EXPECT_EQ(calls, 0);
}

TEST(RingShifts, AnAnswerThatIsNoneIsMissing) {
    const Scene scene = contract::single_vertex(inside, contract::flat_base(inside), {0, 0, -1});
    Scripted twice([](const Contact&, Response& response) {
        response.displacements = {{0, Vec3(1, 0, 0)}, {0, Vec3(0, 1, 0)}};
    });
    EXPECT_EQ(ask(twice, scene).missing, Missing::no_answer);
}

}  // namespace
}  // namespace trocar
