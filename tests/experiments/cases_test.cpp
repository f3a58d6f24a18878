#include "experiments/sweep/cases.h"

#include <functional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/tool/tool_shapes.h"
#include "experiments/input_error.h"
#include "sweep_folder.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

TEST(ListCases, IsTheFullProductInOrder) {
    const SweepFolder folder;
    const std::vector<CaseInputs> cases =
        list_cases(folder.read(replaced(small_sweep, "[400]", "[100, 400]")));
    ASSERT_THAT(cases, SizeIs(8));
    EXPECT_EQ(cases[0].strategy.name, "nearest-face");
    EXPECT_EQ(cases[0].seed, 1U);
    EXPECT_EQ(cases[1].seed, 2U);
    EXPECT_EQ(cases[2].speed, 400);
    EXPECT_EQ(cases[4].strategy.name, "fuzzy-per-vertex");
    std::set<std::string> ids;
    for (const CaseInputs& inputs : cases) ids.insert(inputs.case_id);
    EXPECT_THAT(ids, SizeIs(8));
    EXPECT_THAT(cases[0].case_id, SizeIs(32));
}

TEST(ListCases, ReleasesAreAListToo) {
    const SweepFolder folder;
    const auto cases = list_cases(folder.read(small_sweep + "[cycle]\nrelease = [\"step\", \"contact\"]\n"));
    ASSERT_THAT(cases, SizeIs(8));
    EXPECT_EQ(cases[0].cycle.release, Release::step);
    EXPECT_EQ(cases[2].cycle.release, Release::contact);
    EXPECT_NE(cases[0].case_id, cases[2].case_id);
    EXPECT_EQ(cases[0].scene_id, cases[2].scene_id) << "the scene is the same";
    EXPECT_EQ(cases[0].scene_id, cases[4].scene_id) << "under every strategy";
    EXPECT_NE(cases[0].scene_id, cases[1].scene_id) << "but not for another seed";
}

TEST(ListCases, RatesAndStiffnessesMayBeLists) {
    const SweepFolder folder;
    const auto cases = list_cases(folder.read(
        small_sweep +
        "[cycle]\nrate = [30, 1000]\n[deformation]\nedge_stiffness = 1000\nstiffness = [0.1, 10]\n"));
    ASSERT_EQ(cases.size(), 16U);
    EXPECT_EQ(cases[0].cycle.rate, 30);
    EXPECT_EQ(cases[0].springs.edge_stiffness, 100);
    EXPECT_EQ(cases[0].springs.rest_stiffness, 10);
    EXPECT_EQ(cases[2].springs.edge_stiffness, 10'000);
    EXPECT_EQ(cases[2].cycle.rate, 30);
    EXPECT_EQ(cases[4].cycle.rate, 1000);
    EXPECT_EQ(cases[4].springs.edge_stiffness, 100);
    const std::vector<std::string> filters{"rate=1000", "edge_stiffness=10000"};
    EXPECT_EQ(only(cases, filters).size(), 4U);
}

TEST(ListCases, ARecordingHasItsOwnSpeed) {
    const SweepFolder folder;
    static_cast<void>(folder.write("poses.csv", "t,x,y,z,qw,qx,qy,qz\n0,0,0,3,1,0,0,0\n2,0,0,-5,1,0,0,0\n"));
    const std::string recorded =
        replaced(small_sweep, "\"penetration\"", R"({ name = "recorded", file = "poses.csv" })");
    const auto cases = list_cases(folder.read(replaced(recorded, "[400]", "[20, 100, 400]")));
    ASSERT_THAT(cases, SizeIs(4)) << "strategies and seeds";
    EXPECT_DOUBLE_EQ(cases[0].speed, 4);
}

TEST(Suited, LeavesOutScenesThatHaveNoPlaceAndSaysWhy) {
    const SweepFolder folder;
    const SuitedCases left = suited(
        list_cases(folder.read(replaced(small_sweep, "\"penetration\"", R"("penetration", "cutting")"))));
    ASSERT_THAT(left.cases, SizeIs(4));
    for (const CaseInputs& inputs : left.cases) EXPECT_EQ(inputs.scene.name, "penetration");
    ASSERT_THAT(left.left_out, SizeIs(1));
    EXPECT_THAT(left.left_out[0], testing::AllOf(HasSubstr("cutting on sphere@12mm with prism-6 (4 cases)"),
                                                 HasSubstr("cleft")));
}

TEST(CaseId, ChangesWithEachInput) {
    const SweepFolder folder;
    const CaseInputs base = list_cases(folder.read(small_sweep)).front();
    const std::vector<std::function<void(CaseInputs&)>> changes{
        [](CaseInputs& inputs) { inputs.strategy.name = "fuzzy-per-vertex"; },
        [](CaseInputs& inputs) { inputs.strategy.options["feedback"] = false; },
        [](CaseInputs& inputs) { inputs.strategy.options["feedback"] = true; },
        [](CaseInputs& inputs) { inputs.organ.identity = "sphere@4mm"; },
        [](CaseInputs& inputs) { inputs.tool.identity = "prism-6 r4.5 l80"; },
        [](CaseInputs& inputs) { inputs.scene.identity = "sliding"; },
        [](CaseInputs& inputs) { inputs.speed = 400.00000000000006; },
        [](CaseInputs& inputs) { inputs.seed = 3; },
        [](CaseInputs& inputs) { inputs.cycle.rate = 40; },
        [](CaseInputs& inputs) { inputs.cycle.clearance = 0.02; },
        [](CaseInputs& inputs) { inputs.cycle.release = Release::step; },
        [](CaseInputs& inputs) { inputs.springs.density *= 2; },
        [](CaseInputs& inputs) { inputs.springs.edge_stiffness *= 2; },
        [](CaseInputs& inputs) { inputs.springs.rest_stiffness *= 2; },
        [](CaseInputs& inputs) { inputs.springs.damping *= 2; },
        [](CaseInputs& inputs) { inputs.springs.substeps *= 2; },
        [](CaseInputs& inputs) { inputs.springs.sleep = false; },
    };
    std::set<std::string> ids{case_id_of(base)};
    for (const auto& change : changes) {
        CaseInputs changed = base;
        change(changed);
        ids.insert(case_id_of(changed));
    }
    EXPECT_THAT(ids, SizeIs(changes.size() + 1));
}

TEST(CaseId, DoesNotDependOnTheLabel) {
    const SweepFolder folder;
    CaseInputs inputs = list_cases(folder.read(small_sweep)).front();
    inputs.strategy.label = "another";
    EXPECT_EQ(case_id_of(inputs), inputs.case_id);
}

TEST(CaseId, FollowsAMeshFilesBytesAndSizeButNotItsPath) {
    const SweepFolder folder;
    const std::string mesh = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    const auto id = [&](std::string_view file, std::string_view text, std::string_view size) {
        const std::filesystem::path written = folder.write(file, text);
        const std::string organ =
            "{ file = \"" + std::string(file) + "\", size = " + std::string(size) + " }";
        return list_cases(folder.read(replaced(small_sweep, "\"sphere@12mm\"", organ))).front().case_id;
    };
    const std::string original = id("organ.off", mesh, "100");
    EXPECT_EQ(id("elsewhere/other.off", mesh, "100"), original);
    EXPECT_NE(id("organ.off", mesh, "101"), original);
    EXPECT_NE(id("organ.off", replaced(mesh, "1 0 0", "1 0 0.25"), "100"), original);
}

std::size_t count_only(const std::vector<std::string>& filters) {
    const SweepFolder folder;
    const std::string text = replaced(small_sweep, "[400]", "[20, 100, 400]");  // 2 strategies, 2 seeds
    return only(list_cases(folder.read(text)), filters).size();
}

TEST(Only, ValuesOfOneKeyAreAlternativesAndKeysMustAllMatch) {
    EXPECT_EQ(count_only({}), 12U);
    EXPECT_EQ(count_only({"speed=100"}), 4U);
    EXPECT_EQ(count_only({"speed=100", "speed=20"}), 8U);
    EXPECT_EQ(count_only({"speed=100", "speed=20", "seed=2"}), 4U);
    EXPECT_EQ(count_only({"strategy=nearest-face", "organ=sphere@12mm", "tool=prism-6", "scene=penetration"}),
              6U);
}

TEST(Only, ByAnOptionKeepsTheCasesOfStrategiesThatHaveThatValue) {
    const SweepFolder folder;
    const std::string listed =
        R"({ name = "fuzzy-per-vertex", order = ["ring", "strongest-first"], feedback = [true, false] })";
    const std::vector<CaseInputs> cases =
        list_cases(folder.read(replaced(small_sweep, "\"fuzzy-per-vertex\"", listed)));
    ASSERT_THAT(cases, SizeIs(10)) << "those, and nearest-face, which has neither option, with two seeds";
    const auto labels = [&](const std::vector<std::string>& filters) {
        std::set<std::string> found;
        for (const CaseInputs& inputs : only(cases, filters)) found.insert(inputs.strategy.label);
        return found;
    };
    EXPECT_THAT(labels({"feedback=false"}),
                ElementsAre("fuzzy-per-vertex order=ring feedback=false",
                            "fuzzy-per-vertex order=strongest-first feedback=false"));
    EXPECT_THAT(labels({"order=ring", "feedback=true"}),
                ElementsAre("fuzzy-per-vertex order=ring feedback=true"));
    EXPECT_THAT(labels({"order=ring", "order=strongest-first"}), SizeIs(4));
    EXPECT_THAT(labels({"strategy=fuzzy-per-vertex order=ring feedback=true"}), SizeIs(1));
}

TEST(Only, AMistakeNamesTheNearestWord) {
    const auto message = [](const std::string& filter) -> std::string {
        try {
            count_only({filter});
            return "was accepted";
        } catch (const InputError& error) {
            return error.what();
        }
    };
    EXPECT_THAT(message("speed"), HasSubstr("expected key=value"));
    EXPECT_THAT(message("sped=100"), HasSubstr("did you mean \"speed\"?"));
    EXPECT_THAT(message("strategy=nearest-fase"), HasSubstr("did you mean \"nearest-face\"?"));
    EXPECT_THAT(message("speed=30"), HasSubstr("400"));
    EXPECT_THAT(message("feedbak=true"), HasSubstr("did you mean \"feedback\"?"));
    EXPECT_THAT(message("feedback=ture"), HasSubstr("did you mean \"true\"?"));
}

}  // namespace
}  // namespace trocar
