// Once warm, neither a strategy nor any other phase of a step asks for memory.

#include <algorithm>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "experiments/scenes/prepared_scene.h"
#include "tests/allocation_count.h"
#include "tests/experiments/stage.h"
#include "tests/strategies/variants.h"

namespace trocar {
namespace {

using testing_support::AllocationCount;

TEST(AllocationCount, CountsWhatIsAskedFor) {
    const AllocationCount count;
    EXPECT_EQ(count.so_far(), 0);
    const auto one = std::make_unique<int>(1);
    EXPECT_EQ(count.so_far(), 1);
    struct alignas(128) Wide {
        std::int64_t number = 0;
    };
    const std::vector<Wide> others(3);
    EXPECT_EQ(count.so_far(), 2);
}

/// What a strategy was given and asked for, over a run of a scene.
struct Handled {
    std::size_t most_collided = 0;
    std::int64_t allocations = 0;
};

/// @param answer keeps its memory from one run to the next
Handled run(const Stage& stage, const PreparedScene& scene, Strategy& strategy, Response& answer) {
    Handled handled;
    Cycle cycle(stage.organ, stage.tool, scene.start, CycleSettings{}, SpringSettings{});
    for (const Pose& pose : scene.poses) {
        cycle.move(pose);
        cycle.detect();
        cycle.handle([&](const Contact& contact, Response& response) {
            answer.clear();
            const AllocationCount count;
            strategy.handle(contact, answer);
            handled.allocations += count.so_far();
            handled.most_collided = std::max(handled.most_collided, contact.collided.size());
            response = answer;
        });
        cycle.deform();
    }
    return handled;
}

class WarmStrategy : public testing::TestWithParam<Variant> {
  protected:
    static void handles_without_memory(const Stage& stage) {
        const PreparedScene scene = prepare_scene(find_scene("penetration"), stage.inputs(400, 1));
        const auto strategy = make_strategy(GetParam().name, GetParam().options);
        Response answer;
        EXPECT_GT(run(stage, scene, *strategy, answer).allocations, 0) << "or the count is not of it";
        const Handled again = run(stage, scene, *strategy, answer);
        EXPECT_GE(again.most_collided, 5);
        EXPECT_EQ(again.allocations, 0);
    }
};

TEST_P(WarmStrategy, AsksForNoMemoryOnAConvexTool) {
    static const Stage stage("sphere@3mm", "prism-12");
    handles_without_memory(stage);
}

TEST_P(WarmStrategy, AsksForNoMemoryOnAToolThatIsNotConvex) {
    static const Stage stage("sphere@1.5mm", "grasper");
    handles_without_memory(stage);
}

/// What the steps of one more run of the scene ask for, in a cycle that goes on.
std::int64_t allocations_of_a_run(Cycle& cycle, const PreparedScene& scene, const Handler& handler) {
    const AllocationCount count;
    for (const Pose& pose : scene.poses) {
        cycle.move(pose);
        cycle.detect();
        cycle.handle(handler);
        cycle.deform();
    }
    return count.so_far();
}

TEST_P(WarmStrategy, AWholeStepAsksForNoMemory) {
    static const Stage stage("sphere@3mm", "prism-12");
    const PreparedScene scene = prepare_scene(find_scene("penetration"), stage.inputs(100, 1));
    const auto strategy = make_strategy(GetParam().name, GetParam().options);
    const Handler handler = [&](const Contact& contact, Response& response) {
        strategy->handle(contact, response);
    };
    for (const bool sleep : {true, false}) {
        SpringSettings springs;
        springs.sleep = sleep;
        Cycle cycle(stage.organ, stage.tool, scene.start, CycleSettings{}, springs);
        EXPECT_GT(allocations_of_a_run(cycle, scene, handler), 0) << "or the count is not of it";
        allocations_of_a_run(cycle, scene, handler);
        EXPECT_EQ(allocations_of_a_run(cycle, scene, handler), 0) << "sleep: " << sleep;
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, WarmStrategy, testing::ValuesIn(all_variants()), [](const auto& variant) {
    std::string name = variant.param.label;
    std::ranges::replace(name, '-', '_');
    return name;
});

}  // namespace
}  // namespace trocar
