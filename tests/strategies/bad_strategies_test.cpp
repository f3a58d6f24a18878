#include <atomic>
#include <limits>
#include <thread>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/strategies/contract.h"
#include "tests/strategies/scenes.h"

/// The contract has to find out each of these.
namespace trocar::contract {
namespace {

using Script = std::function<void(const Contact&, Response&)>;

/// A strategy that does to each contact what it is told, and promises everything.
class Scripted final : public Strategy {
  public:
    explicit Scripted(Script script) : script_(std::move(script)) {}
    [[nodiscard]] Promises promises() const override {
        return {.clears_convex_tools = true, .clears_any_tool = true, .facet_order_free = true};
    }
    void handle(const Contact& contact, Response& response) override { script_(contact, response); }

  private:
    Script script_;
};

Subject scripted(Script script) {
    return {{}, [script = std::move(script)] { return std::make_unique<Scripted>(script); }};
}

/// Every collided vertex goes by what `displacement(contact, vertex)` says.
template <typename Displacement>
Subject moving(const Displacement& displacement) {
    return scripted([displacement](const Contact& contact, Response& response) {
        for (const Index vertex : contact.collided) {
            response.displacements.push_back({vertex, displacement(contact, vertex)});
        }
    });
}

/// The same answer to every contact.
Subject displacing(const std::vector<VertexDisplacement>& answer) {
    return scripted([answer](const Contact&, Response& response) { response.displacements = answer; });
}
Subject pushing(const std::vector<VertexForce>& answer) {
    return scripted([answer](const Contact&, Response& response) { response.forces = answer; });
}
Subject confining(const std::vector<HalfSpace>& answer) {
    return scripted([answer](const Contact&, Response& response) { response.half_spaces = answer; });
}

/// A scene in which many vertices are collided, but not all.
Scene crowded_scene() {
    for (std::uint64_t seed = 0;; ++seed) {
        Scene scene = random_scene(seed, "prism-12");
        if (scene.detected.collided.size() >= 5) return scene;
    }
}

constexpr double infinite = std::numeric_limits<double>::infinity();
const Vec3 sideways(1, 0, 0);

TEST(TheContract, FindsOutWhatIsNotFinite) {
    const Scene scene = crowded_scene();
    for (const Vec3& bad : {Vec3(0, std::nan(""), 0), Vec3(infinite, 0, 0)}) {
        EXPECT_NE(violation_of_well_formed(displacing({{0, bad}}), scene), "");
        EXPECT_NE(violation_of_well_formed(pushing({{0, bad}}), scene), "");
        EXPECT_NE(violation_of_well_formed(confining({{0, bad, sideways}}), scene), "");
    }
    EXPECT_NE(violation_of_well_formed(confining({{0, sideways, Vec3(2, 0, 0)}}), scene), "")
        << "a normal that is no unit vector";
}

TEST(TheContract, FindsOutWhatNamesAVertexTwiceOrOneThatIsNot) {
    const Scene scene = crowded_scene();
    const auto beyond = static_cast<Index>(scene.positions.size());
    EXPECT_NE(violation_of_well_formed(displacing({{0, sideways}, {0, sideways}}), scene), "");
    EXPECT_NE(violation_of_well_formed(pushing({{3, sideways}, {3, sideways}}), scene), "");
    for (const Index bad : {beyond, -1}) {
        EXPECT_NE(violation_of_well_formed(displacing({{bad, sideways}}), scene), "");
        EXPECT_NE(violation_of_well_formed(pushing({{bad, sideways}}), scene), "");
        EXPECT_NE(violation_of_well_formed(confining({{bad, sideways, sideways}}), scene), "");
    }
    const Subject negative = scripted([](const Contact&, Response& response) { response.fallbacks = -1; });
    EXPECT_NE(violation_of_well_formed(negative, scene), "");
}

TEST(TheContract, FindsOutWhatActsWithoutContact) {
    const std::vector<Subject> bad = {displacing({{0, sideways}}), pushing({{0, sideways}}),
                                      confining({{0, sideways, sideways}})};
    for (const Subject& subject : bad) {
        for (const auto& [name, scene] : scenes_without_contact()) {
            EXPECT_NE(violation_of_quiet_without_contact(subject, scene), "") << name;
        }
    }
}

TEST(TheContract, LetsSweptContactActNearTheSweepOnly) {
    Subject swept = displacing({{0, sideways}});
    swept.description.swept_contact = true;
    int allowed = 0, forbidden = 0;
    for (const auto& [name, scene] : scenes_without_contact()) {
        const bool quiet = violation_of_quiet_without_contact(swept, scene).empty();
        EXPECT_EQ(quiet, !scene.detected.near_vertices.empty()) << name;
        ++(quiet ? allowed : forbidden);
    }
    EXPECT_GT(allowed, 0);
    EXPECT_GT(forbidden, 0);
}

TEST(TheContract, FindsOutWhatLeavesVerticesInTheTool) {
    const Subject lazy = displacing({});
    const Subject too_near = moving([](const Contact& contact, Index vertex) -> Vec3 {
        const NearestFace nearest = contact.tool.nearest_face(contact.positions[vertex]);
        return (0.1 * contact.clearance - nearest.signed_distance) * nearest.normal;
    });
    const Scene scene = crowded_scene();
    EXPECT_NE(violation_of_clearing(lazy, scene), "");
    EXPECT_NE(violation_of_clearing(too_near, scene), "");
}

TEST(TheContract, FindsOutWhatTouchesOthers) {
    const Scene scene = crowded_scene();
    Index other = 0;
    while (std::ranges::binary_search(scene.detected.collided, other)) ++other;
    EXPECT_NE(violation_of_leaving_others(displacing({{other, sideways}}), scene), "");
    EXPECT_NE(violation_of_leaving_others(pushing({{other, sideways}}), scene), "");
    EXPECT_NE(violation_of_leaving_others(confining({{other, sideways, sideways}}), scene), "");
}

TEST(TheContract, FindsOutWhatIsNotEquivariantUnderRigidMotion) {
    const Scene scene = crowded_scene();
    const Pose turned{.rotation = Eigen::AngleAxisd(1.5, Vec3::UnitY()).toRotationMatrix()};
    const Pose shifted{.position = {5, 0, 0}};
    const auto to_the_origin = [](const Contact& contact, Index vertex) -> Vec3 {
        return -contact.positions[vertex];
    };
    EXPECT_NE(violation_of_rigid_equivariance(moving([](auto&, Index) { return sideways; }), scene, turned),
              "");
    EXPECT_NE(violation_of_rigid_equivariance(moving(to_the_origin), scene, shifted), "");
    EXPECT_NE(violation_of_rigid_equivariance(pushing({{0, sideways}}), scene, turned), "");
    const Subject turned_wall = confining({{0, Vec3::Zero(), sideways}});
    const Subject fixed_wall = confining({{0, Vec3(9, 9, 9), sideways}});
    EXPECT_NE(violation_of_rigid_equivariance(turned_wall, scene, turned), "");
    EXPECT_NE(violation_of_rigid_equivariance(fixed_wall, scene, shifted), "");
}

TEST(TheContract, FindsOutWhatIsNotEquivariantUnderScaling) {
    const Scene scene = crowded_scene();
    EXPECT_NE(violation_of_scale_equivariance(moving([](auto&, Index) { return sideways; }), scene, 2), "");
    EXPECT_EQ(violation_of_scale_equivariance(pushing({{0, sideways}}), scene, 2), "") << "forces are exempt";
}

TEST(TheContract, FindsOutWhatDependsOnVertexNumbers) {
    const Subject by_number =
        moving([](const Contact&, Index vertex) -> Vec3 { return static_cast<double>(vertex) * sideways; });
    const Subject first_only = scripted([](const Contact& contact, Response& response) {
        if (!contact.collided.empty()) response.displacements = {{contact.collided.front(), sideways}};
    });
    EXPECT_NE(violation_of_vertex_numbering(by_number, crowded_scene(), 7), "");
    EXPECT_NE(violation_of_vertex_numbering(first_only, crowded_scene(), 7), "");
}

TEST(TheContract, FindsOutWhatDependsOnFacetNumbers) {
    const Subject by_first_facet = moving([](const Contact& contact, Index vertex) -> Vec3 {
        const Index first = contact.organ.adjacency.ring(vertex).front();
        return facet_normal(contact.positions, contact.organ.rest.facets[first]);
    });
    EXPECT_NE(violation_of_facet_numbering(by_first_facet, crowded_scene(), 7), "");
}

TEST(TheContract, FindsOutWhatRemembersUnlessDeclared) {
    class Counting final : public Strategy {
      public:
        [[nodiscard]] Promises promises() const override { return {}; }
        void handle(const Contact&, Response& response) override { response.fallbacks = ++calls_; }

      private:
        int calls_ = 0;
    };
    Subject counting{{}, [] { return std::make_unique<Counting>(); }};
    EXPECT_NE(violation_of_repeatability(counting, crowded_scene(), random_scene(2)), "");
    counting.description.keeps_state = true;
    EXPECT_EQ(violation_of_repeatability(counting, crowded_scene(), random_scene(2)), "");
}

TEST(TheContract, FindsOutWhatInstancesShare) {
    auto calls = std::make_shared<std::atomic<int>>(0);
    Subject sharing = moving([calls](const Contact&, Index) -> Vec3 { return ++*calls * sideways; });
    EXPECT_NE(violation_of_repeatability(sharing, crowded_scene(), random_scene(2)), "");
    sharing.description.keeps_state = true;
    EXPECT_NE(violation_of_repeatability(sharing, crowded_scene(), random_scene(2)), "");
}

TEST(TheContract, FindsOutWhatDependsOnTheThread) {
    const auto home = std::this_thread::get_id();
    const Subject bad = moving([home](const Contact&, Index) -> Vec3 {
        return std::this_thread::get_id() == home ? sideways : Vec3(2 * sideways);
    });
    EXPECT_NE(violation_of_repeatability(bad, crowded_scene(), random_scene(2)), "");
}

}  // namespace
}  // namespace trocar::contract
