// Properties that hold for every metric: where the scene stands in the world, and how its organ is numbered,
// is nothing that a figure may depend on.

#include <cmath>
#include <numeric>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "judged_steps.h"

namespace trocar {
namespace {

using Positions = std::vector<Vec3>;

/// Wide enough for edges of the organ to lie inside.
Tool make_tool(int kind) {
    if (kind == 0) return make_prism(12, 12, 80);
    return kind == 1 ? make_pointed_prism(6, {.radius = 15, .length = 60, .tip_length = 20})
                     : make_grasper({.radius = 8, .length = 80, .jaw_length = 40, .opening = 25});
}

/// A case of two steps, made up: the vertices near the tool are thrown about, the others tremble.
struct MadeUp {
    SurfaceMesh rest;
    int tool;
    Pose start;
    std::vector<Pose> poses;
    std::vector<Positions> found, handled, deformed;  // by step
    std::vector<Index> region;
};

class Randomness {
  public:
    explicit Randomness(std::uint64_t seed) : engine_(seed) {}
    double operator()(double low, double high) { return low + (high - low) * uniform_(engine_); }
    Vec3 in_cube(double half) { return {(*this)(-half, half), (*this)(-half, half), (*this)(-half, half)}; }
    Mat3 rotation(double most) {
        return Eigen::AngleAxisd((*this)(-most, most), in_cube(1).normalized()).toRotationMatrix();
    }
    std::vector<Index> order(std::size_t count) {
        std::vector<Index> numbers(count);
        std::iota(numbers.begin(), numbers.end(), 0);
        std::ranges::shuffle(numbers, engine_);
        return numbers;
    }

  private:
    std::mt19937_64 engine_;
    std::uniform_real_distribution<double> uniform_{0, 1};
};

MadeUp make_up(std::uint64_t seed) {
    Randomness random(seed);
    static const std::vector<std::string> organs{"sphere@8mm", "sheet@8mm", "gallbladder@8mm"};
    MadeUp scene{.rest = make_organ_by_formula(organs[seed % organs.size()]).rest,
                 .tool = static_cast<int>(seed / organs.size() % 3),
                 .start = {},
                 .poses = {},
                 .found = {},
                 .handled = {},
                 .deformed = {},
                 .region = {}};
    const Vec3 entry = scene.rest.positions[scene.rest.positions.size() / 2];
    scene.start = {.rotation = random.rotation(3), .position = entry + random.in_cube(3)};
    Pose pose = scene.start;
    Positions now = scene.rest.positions;
    for (int step = 0; step < 2; ++step) {
        pose = {.rotation = random.rotation(0.2) * pose.rotation,
                .position = pose.position + random.in_cube(4)};
        scene.poses.push_back(pose);
        scene.found.push_back(now);
        for (Vec3& position : now) {
            // Some are thrown far enough to come out on the tool's other side.
            const double reach = random(0, 1) < 0.3 ? 30 : 6;
            if ((position - pose.position).norm() < 15) position += random.in_cube(reach);
        }
        scene.handled.push_back(now);
        for (Vec3& position : now) position += random.in_cube(0.5);
        scene.deformed.push_back(now);
    }
    for (std::size_t vertex = 0; vertex < now.size(); vertex += 2)
        scene.region.push_back(static_cast<Index>(vertex));
    return scene;
}

MadeUp moved(MadeUp scene, const Pose& to) {
    const auto move_all = [&](Positions& positions) {
        for (Vec3& position : positions) position = to.to_world(position);
    };
    const auto move_pose = [&](Pose& pose) {
        pose = {.rotation = to.rotation * pose.rotation, .position = to.to_world(pose.position)};
    };
    move_all(scene.rest.positions);
    for (auto* steps : {&scene.found, &scene.handled, &scene.deformed}) {
        for (Positions& positions : *steps) move_all(positions);
    }
    move_pose(scene.start);
    for (Pose& pose : scene.poses) move_pose(pose);
    return scene;
}

MadeUp renumbered(MadeUp scene, std::uint64_t seed) {
    Randomness random(seed);
    const std::vector<Index> number = random.order(scene.rest.positions.size());  // old → new
    const auto permute = [&](Positions& positions) {
        Positions in_new_order(positions.size());
        for (std::size_t k = 0; k < positions.size(); ++k) in_new_order[number[k]] = positions[k];
        positions = std::move(in_new_order);
    };
    permute(scene.rest.positions);
    for (auto* steps : {&scene.found, &scene.handled, &scene.deformed}) {
        for (Positions& positions : *steps) permute(positions);
    }
    std::vector<Facet> facets;
    for (const Index old : random.order(scene.rest.facets.size())) {
        const auto& [a, b, c] = scene.rest.facets[old];
        facets.push_back({number[b], number[c], number[a]});  // another corner first, the same sense
    }
    scene.rest.facets = std::move(facets);
    for (Index& vertex : scene.region) vertex = number[vertex];
    std::ranges::sort(scene.region);
    return scene;
}

/// What a made-up strategy answers to the step: a collided vertex goes along the normal of the
/// facet at which its ring begins.
ShiftedAnswers along_first_facet(const Judged& step) {
    const Organ& organ = step.organ().organ();
    ShiftedAnswers answers{.displacements = {}, .missing = Missing::nothing};
    for (const Index vertex : step.collided()) {
        const auto ring = organ.adjacency.ring(vertex);
        if (answers.displacements.size() < ring.size()) answers.displacements.resize(ring.size());
        for (std::size_t shift = 0; shift < ring.size(); ++shift) {
            const Facet& facet = organ.rest.facets[ring[shift]];
            answers.displacements[shift].push_back(
                {vertex, facet_area_vector(step.at(Moment::before).positions(), facet)});
        }
    }
    return answers;
}

std::vector<Measured> judged(const MadeUp& scene) {
    const JudgedSteps steps(make_organ("made up", scene.rest), make_tool(scene.tool));
    Judge judge(steps.state(scene.rest.positions, scene.start),
                {.metrics = choose_metrics("all"),
                 .region = region_of(steps.judged_organ(), scene.region),
                 .every = 1});
    std::vector<Measured> values;
    for (std::size_t step = 0; step < scene.poses.size(); ++step) {
        judge.before(scene.found[step], scene.poses[step]);
        judge.handled(scene.handled[step], 3, [&] { return along_first_facet(judge.step()); });
        judge.deformed(scene.deformed[step]);
        for (const Measured& value : judge.values()) values.push_back(value);
    }
    for (const Measured& value : judge.values_at_end()) values.push_back(value);
    return values;
}

void expect_same(const std::vector<Measured>& one, const std::vector<Measured>& other) {
    const std::vector<Reading> readings = readings_of(choose_metrics("all"));
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        const Reading& reading = readings[k % readings.size()];
        const std::string name = series_name(*reading.metric, reading.moment);
        EXPECT_EQ(one[k].missing, other[k].missing) << name;
        if (one[k].missing != Missing::nothing) continue;
        // A small volume is what is left of large ones: its rounding is not smaller than theirs.
        const bool count = one[k].value == std::floor(one[k].value);
        EXPECT_NEAR(one[k].value, other[k].value, count ? 1e-11 : 1e-9 * std::abs(one[k].value) + 1e-11)
            << name;
    }
}

RC_GTEST_PROP(EveryMetric, IsTheSameWhereverTheSceneStands, ()) {
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
    Randomness random(seed);
    const Pose to{.rotation = random.rotation(3), .position = random.in_cube(100)};
    const MadeUp scene = make_up(seed);
    expect_same(judged(scene), judged(moved(scene, to)));
    RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(EveryMetric, IsTheSameHoweverTheOrganIsNumbered, ()) {
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
    const MadeUp scene = make_up(seed);
    expect_same(judged(scene), judged(renumbered(scene, seed)));
    RC_ASSERT(!testing::Test::HasFailure());
}

TEST(EveryMetric, HasAValueInTheMadeUpScenes) {
    // What never comes out of them is not held to their properties.
    const std::vector<Reading> readings = readings_of(choose_metrics("all"));
    std::vector<bool> seen(readings.size());
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const std::vector<Measured> values = judged(make_up(seed));
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (values[k].missing == Missing::nothing && values[k].value != 0)
                seen[k % readings.size()] = true;
        }
    }
    for (std::size_t k = 0; k < readings.size(); ++k) {
        EXPECT_TRUE(seen[k]) << series_name(*readings[k].metric, readings[k].moment);
    }
}

}  // namespace
}  // namespace trocar
