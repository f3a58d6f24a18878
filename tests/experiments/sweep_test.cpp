#include "experiments/sweep/sweep.h"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/mesh_error.h"
#include "experiments/input_error.h"
#include "sweep_folder.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr const char* tetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST(ReadSweep, ReadsEveryKey) {
    const SweepFolder folder;
    const std::filesystem::path mesh = folder.write("meshes/organ.off", tetrahedron);
    const Sweep sweep = folder.read(R"(
name = "my sweep"
strategies = ["nearest-face", { name = "fuzzy-per-vertex", label = "fuzzy, reference", normals = "reference" }]
organs = ["sphere@10mm", { file = "meshes/organ.off", size = 100 }]
tools = ["prism-12", { shape = "prism", sides = 6, radius = 3, length = 70 }]
scenes = ["penetration"]
speeds = [20, 100.5]
seeds = [3, 1]
[cycle]
rate = 25
clearance = 0.02
release = "step"
[deformation]
density = 1e-3
edge_stiffness = 1000
rest_stiffness = 50
damping = 0
substeps = 7
sleep = false
)");
    EXPECT_EQ(sweep.name, "my sweep");
    ASSERT_THAT(sweep.strategies, SizeIs(2));
    EXPECT_EQ(sweep.strategies[0].label, "nearest-face");
    EXPECT_EQ(sweep.strategies[1].label, "fuzzy, reference");
    EXPECT_EQ(word(sweep.strategies[1].options, "normals"), "reference");
    EXPECT_EQ(word(sweep.strategies[1].options, "aggregate"), "sum") << "an option not given has its default";
    ASSERT_THAT(sweep.organs, SizeIs(2));
    EXPECT_EQ(sweep.organs[0].organ->name, "sphere@10mm");
    EXPECT_NEAR(bounding_box(sweep.organs[1].organ->rest.positions).size().maxCoeff(), 100, 1e-9);
    ASSERT_THAT(sweep.tools, SizeIs(2));
    EXPECT_NEAR(sweep.tools[1].tool->radius, 3, 1e-12);
    ASSERT_EQ(sweep.scenes.size(), 1U);
    EXPECT_EQ(sweep.scenes[0].name, "penetration");
    EXPECT_THAT(sweep.speeds, ElementsAre(20, 100.5));
    EXPECT_THAT(sweep.seeds, ElementsAre(3, 1));
    EXPECT_THAT(sweep.rates, ElementsAre(25));
    EXPECT_EQ(sweep.cycle.clearance, 0.02);
    EXPECT_THAT(sweep.releases, ElementsAre(Release::step));
    EXPECT_EQ(sweep.springs.density, 1e-3);
    EXPECT_EQ(sweep.springs.edge_stiffness, 1000);
    EXPECT_EQ(sweep.springs.rest_stiffness, 50);
    EXPECT_THAT(sweep.stiffnesses, ElementsAre(1));
    EXPECT_EQ(sweep.springs.damping, 0);
    EXPECT_EQ(sweep.springs.substeps, 7);
    EXPECT_FALSE(sweep.springs.sleep);
    EXPECT_TRUE(SpringSettings{}.sleep);
}

TEST(ReadSweep, ACountOfSeedsStandsForTheFirstOnes) {
    const SweepFolder folder;
    EXPECT_THAT(folder.read(replaced(small_sweep, "seeds = 2", "seeds = 4")).seeds, ElementsAre(1, 2, 3, 4));
}

/// The labels of the strategies of a sweep that has `table` instead of nearest-face.
std::vector<std::string> labels_with(std::string_view table) {
    const SweepFolder folder;
    std::vector<std::string> labels;
    for (const StrategyChoice& one :
         folder.read(replaced(small_sweep, "\"nearest-face\"", table)).strategies) {
        labels.push_back(one.label);
    }
    return labels;
}

TEST(ReadSweep, ListsOfOptionsStandForTheirProductWhoseLastChangesFastest) {
    const SweepFolder folder;
    const std::string lists =
        R"({ name = "fuzzy-per-vertex", aggregate = ["last", "mean-normal"], normals = "reference", feedback = [true, false] })";
    const Sweep sweep = folder.read(replaced(small_sweep, "\"nearest-face\"", lists));
    ASSERT_THAT(sweep.strategies, SizeIs(5)) << "the four and the one that follows them";
    for (std::size_t i = 0; i < 4; ++i) {
        const StrategyChoice& one = sweep.strategies[i];
        const std::string aggregate = i < 2 ? "last" : "mean-normal";
        const bool feedback = i % 2 == 0;
        EXPECT_EQ(one.name, "fuzzy-per-vertex");
        EXPECT_EQ(one.label,
                  "fuzzy-per-vertex aggregate=" + aggregate + " feedback=" + (feedback ? "true" : "false"));
        EXPECT_EQ(word(one.options, "aggregate"), aggregate);
        EXPECT_EQ(flag(one.options, "feedback"), feedback);
        EXPECT_EQ(word(one.options, "normals"), "reference") << "an option that is no list is that of all";
        EXPECT_EQ(word(one.options, "order"), "ring") << "and one that is not given has its default";
    }
}

TEST(ReadSweep, AListedOptionIsTheSameCaseAsTheOptionAlone) {
    const SweepFolder folder;
    const auto choices_of = [&](std::string_view table) {
        return folder.read(replaced(small_sweep, "\"nearest-face\"", table)).strategies;
    };
    const StrategyChoice alone =
        choices_of(R"({ name = "fuzzy-per-vertex", label = "a", order = "strongest-first" })")[0];
    EXPECT_EQ(
        choices_of(R"({ name = "fuzzy-per-vertex", label = "a", order = ["strongest-first"] })")[0].options,
        alone.options);
}

TEST(ReadSweep, ALabelOfATableWithListsIsFollowedByWhatIsListed) {
    EXPECT_THAT(labels_with(R"({ name = "fuzzy-per-vertex", label = "mine", feedback = [false] })"),
                ElementsAre("mine feedback=false", "fuzzy-per-vertex"));
}

/// One edit of the small sweep, and where and how it must be answered.
struct Mistake {
    const char* name;
    const char* from;
    const char* to;
    const char* place;  // line:column
    const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.name; }

class ReadSweepMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ReadSweepMistake, IsAnsweredWithPlaceAndRemedy) {
    const SweepFolder folder;
    const Mistake& mistake = GetParam();
    try {
        static_cast<void>(folder.read(replaced(small_sweep, mistake.from, mistake.to)));
        FAIL() << "was accepted";
    } catch (const InputError& error) {
        const std::string place = folder.path("sweep.toml").string() + ":" + mistake.place + ": ";
        EXPECT_THAT(error.what(), testing::StartsWith(place));
        EXPECT_THAT(error.what(), HasSubstr(mistake.message));
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, ReadSweepMistake,
    testing::Values(
        Mistake{"Syntax", "seeds = 2", "seeds = ", "7:9", "value"},
        Mistake{"UnknownKey", "speeds =", "speed =", "6:1", "did you mean \"speeds\"?"},
        Mistake{"MissingKey", "seeds = 2", "", "1:1", "seeds is missing"},
        Mistake{"UnknownStrategy", "\"nearest-face\"", "\"nearest-fase\"", "2:15",
                "did you mean \"nearest-face\"?"},
        Mistake{"UnknownStrategyInTable", "\"nearest-face\"", "{ name = \"nearest-fase\" }", "2:24",
                "did you mean \"nearest-face\"?"},
        Mistake{"StrategyWithoutName", "\"nearest-face\"", "{ label = \"a\" }", "2:15", "needs the key name"},
        Mistake{"UnknownOption", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", normal = \"current\" }", "2:60", "\"normals\""},
        Mistake{"WrongChoice", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", normals = \"curent\" }", "2:70", "\"current\""},
        Mistake{"OptionOfAnotherKind", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", feedback = 1 }", "2:71", "feedback"},
        Mistake{"SameLabel", "\"nearest-face\"", "{ name = \"fuzzy-per-vertex\", feedback = false }", "2:64",
                "label"},
        Mistake{"SameStrategy", "\"fuzzy-per-vertex\"", "{ name = \"nearest-face\", label = \"again\" }",
                "2:31", "twice"},
        Mistake{"EmptyListOfAnOption", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", feedback = [] }", "2:71", "feedback must have at least one"},
        Mistake{"ListInAListOfAnOption", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", feedback = [true, [false]] }", "2:78", "inner brackets"},
        Mistake{"ValueTwiceInAList", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", order = [\"ring\", \"ring\"] }", "2:77",
                "order lists ring twice"},
        Mistake{"WrongChoiceInAList", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", order = [\"ring\", \"rnig\"] }", "2:77", "\"ring\""},
        Mistake{"TableInAListOfAnOption", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", order = [{ a = 1 }] }", "2:69", "not a table"},
        Mistake{"UnknownOptionWithAList", "\"fuzzy-per-vertex\"",
                "{ name = \"fuzzy-per-vertex\", normal = [\"current\"] }", "2:60", "\"normals\""},
        Mistake{"ListOfNames", "\"fuzzy-per-vertex\"", "{ name = [\"fuzzy-per-vertex\"] }", "2:40",
                "must be a text"},
        Mistake{"ListThatHasAnotherStrategy", "\"nearest-face\"",
                "{ name = \"fuzzy-per-vertex\", feedback = [true, false] }", "2:72",
                "\"fuzzy-per-vertex feedback=true\""},
        Mistake{"UnknownOrgan", "sphere@12mm", "shpere@12mm", "3:11", "did you mean \"sphere\"?"},
        Mistake{"OrganTwice", "\"sphere@12mm\"", "\"sphere@12mm\", \"sphere@12mm\"", "3:26", "twice"},
        Mistake{"OrganFileMissing", "\"sphere@12mm\"", "{ file = \"no.off\" }", "3:20", "no.off"},
        Mistake{"OrganKey", "\"sphere@12mm\"", "{ fil = \"no.off\" }", "3:13", "did you mean \"file\"?"},
        Mistake{"UnknownTool", "prism-6", "prims-6", "4:10", "prism-N"},
        Mistake{"ToolShape", "\"prism-6\"", "{ shape = \"prsim\", sides = 6 }", "4:20",
                "did you mean \"prism\"?"},
        Mistake{"ToolParameter", "\"prism-6\"", "{ shape = \"prism\", sids = 6 }", "4:29",
                "did you mean \"sides\"?"},
        Mistake{"ToolRange", "\"prism-6\"", "{ shape = \"prism\", sides = 2 }", "4:37", "3 to 64"},
        Mistake{"ToolSidesHuge", "\"prism-6\"", "{ shape = \"prism\", sides = 4294967300 }", "4:37",
                "3 to 64"},
        Mistake{"ToolWithoutSides", "\"prism-6\"", "{ shape = \"pointed-prism\" }", "4:10", "the key sides"},
        Mistake{"ToolOfNothing", "\"prism-6\"", "{ radius = 3 }", "4:10", "the key shape"},
        Mistake{"NeedleKey", "\"prism-6\"", "{ shape = \"needle\", tip_angel = 6 }", "4:30",
                "did you mean \"tip_angle\"?"},
        Mistake{"NeedleTip", "\"prism-6\"", "{ shape = \"needle\", length = 10 }", "4:20", "tip is 17.1"},
        Mistake{"GrasperRange", "\"prism-6\"", "{ shape = \"grasper\", opening = 80 }", "4:20",
                "expected 1 to 60 degrees"},
        Mistake{"GrasperParameter", "\"prism-6\"", "{ shape = \"grasper\", radius = -1 }", "4:40", "above 0"},
        Mistake{"ToolFileMissing", "\"prism-6\"", "{ file = \"no.off\", axis = [0, 0, 1] }", "4:19",
                "no.off"},
        Mistake{"UnknownScene", "\"penetration\"", "\"penetraton\"", "5:11", "did you mean \"penetration\"?"},
        Mistake{"SceneParameter", "\"penetration\"", "{ name = \"sliding\", file = \"a.csv\" }", "5:11",
                "no parameters"},
        Mistake{"SceneKey", "\"penetration\"", "{ name = \"recorded\", fil = \"a.csv\" }", "5:32",
                "did you mean \"file\"?"},
        Mistake{"RecordedWithoutFile", "\"penetration\"", "\"recorded\"", "5:11", "file = \"poses.csv\""},
        Mistake{"RecordingMissing", "\"penetration\"", "{ name = \"recorded\", file = \"no.csv\" }", "5:39",
                "no.csv"},
        Mistake{"SpeedZero", "[400]", "[100, 0]", "6:16", "above 0"},
        Mistake{"SpeedNegative", "[400]", "[-5]", "6:11", "above 0"},
        Mistake{"SpeedNotFinite", "[400]", "[inf]", "6:11", "finite"},
        Mistake{"SpeedText", "[400]", "[\"fast\"]", "6:11", "must be a number"},
        Mistake{"SpeedTwice", "[400]", "[400, 400.0]", "6:16", "twice"},
        Mistake{"SpeedsNoList", "[400]", "400", "6:10", "must be a list"},
        Mistake{"NoSpeeds", "[400]", "[]", "6:10", "at least one"},
        Mistake{"NoSeeds", "seeds = 2", "seeds = 0", "7:9", "from 1"},
        Mistake{"SeedsNotWhole", "seeds = 2", "seeds = 1.5", "7:9", "whole number"},
        Mistake{"SeedZero", "seeds = 2", "seeds = [1, 0]", "7:13", "at least 1"},
        Mistake{"CycleKey", "seeds = 2", "seeds = 2\n[cycle]\nrat = 3", "9:1", "did you mean \"rate\"?"},
        Mistake{"RateZero", "seeds = 2", "seeds = 2\n[cycle]\nrate = 0", "9:8", "above 0"},
        Mistake{"ReleaseWord", "seeds = 2", "seeds = 2\n[cycle]\nrelease = \"contct\"", "9:11",
                "did you mean \"contact\"?"},
        Mistake{"RateTwice", "seeds = 2", "seeds = 2\n[cycle]\nrate = [30, 60, 30]", "9:17",
                "rate lists 30 twice"},
        Mistake{"StiffnessZero", "seeds = 2", "seeds = 2\n[deformation]\nstiffness = [1, 0]", "9:17",
                "stiffness"},
        Mistake{"ReleaseTwice", "seeds = 2", "seeds = 2\n[cycle]\nrelease = [\"step\", \"step\"]", "9:20",
                "twice"},
        Mistake{"DeformationKey", "seeds = 2", "seeds = 2\n[deformation]\nsubstep = 3", "9:1",
                "did you mean \"substeps\"?"},
        Mistake{"Substeps", "seeds = 2", "seeds = 2\n[deformation]\nsubsteps = 0", "9:12", "1 to 10000"},
        Mistake{"Sleep", "seeds = 2", "seeds = 2\n[deformation]\nsleep = \"no\"", "9:9", "true or false"},
        Mistake{"Damping", "seeds = 2", "seeds = 2\n[deformation]\ndamping = -1", "9:11", "negative"},
        Mistake{"CompareKey", "seeds = 2", "seeds = 2\n[compare]\nsame_states = 3", "9:1",
                "did you mean \"same_state\"?"},
        Mistake{"SameState", "seeds = 2", "seeds = 2\n[compare]\nsame_state = -1", "9:14", "0 to 1000"},
        Mistake{"Date", "seeds = 2", "seeds = 2009-11-05", "7:9", "dates"}),
    [](const auto& mistake) { return mistake.param.name; });

const std::string two_poses = "t,x,y,z,qw,qx,qy,qz\n0,0,0,3,1,0,0,0\n2,0,0,-5,1,0,0,0\n";

TEST(ReadSweep, ReadsARecordedScene) {
    const SweepFolder folder;
    const auto scene_of = [&](const std::string& keys) {
        return folder.read(replaced(small_sweep, "\"penetration\"", "{ name = \"recorded\", " + keys + " }"))
            .scenes.at(0);
    };
    static_cast<void>(folder.write("a/poses.csv", two_poses));
    static_cast<void>(folder.write("b/other.csv", two_poses));
    static_cast<void>(folder.write("a/faster.csv", replaced(two_poses, "\n2,", "\n1,")));
    const SceneChoice scene = scene_of(R"(file = "a/poses.csv", frame = "entry")");
    EXPECT_EQ(scene.name, "recorded:poses");
    ASSERT_TRUE(scene.recording);
    EXPECT_EQ(scene.recording->frame, Recording::Frame::entry);
    EXPECT_EQ(scene.recording->motion.times.size(), 2U);
    EXPECT_EQ(scene_of(R"(file = "b/other.csv", frame = "entry")").identity, scene.identity);
    EXPECT_NE(scene_of(R"(file = "a/faster.csv", frame = "entry")").identity, scene.identity);
    EXPECT_NE(scene_of(R"(file = "a/poses.csv")").identity, scene.identity) << "in the organ's frame";
}

TEST(ReadSweep, AMistakeInARecordingIsAnsweredWithItsFileAndPlace) {
    const SweepFolder folder;
    const std::filesystem::path file = folder.write("poses.csv", replaced(two_poses, "0,0,-5", "0,x,-5"));
    try {
        static_cast<void>(folder.read(
            replaced(small_sweep, "\"penetration\"", R"({ name = "recorded", file = "poses.csv" })")));
        FAIL() << "was accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith(file.string() + ":3:5: y must be a finite number"));
    }
}

TEST(ReadSweep, ReadsEveryShapeOfTool) {
    const SweepFolder folder;
    const Sweep sweep = folder.read(replaced(small_sweep, "[\"prism-6\"]", R"([
"needle",
{ shape = "prism", sides = 6, radius = 3 },
{ shape = "pointed-prism", sides = 8, tip_length = 12 },
{ shape = "needle", radius = 1, length = 70, tip_angle = 10 },
{ shape = "grasper", radius = 3, length = 60, jaw_length = 15, opening = 25 }])"));
    std::vector<std::string> names, identities;
    for (const ToolChoice& choice : sweep.tools) {
        names.push_back(choice.tool->name);
        identities.push_back(choice.identity);
    }
    EXPECT_THAT(names, ElementsAre("needle", "prism-6 r3 l80", "pointed-prism-8 r4 l80 t12",
                                   "needle r1 l70 a10", "grasper r3 l60 j15 o25"));
    EXPECT_EQ(identities, names);
}

TEST(ReadSweep, ReadsAToolFromAFile) {
    const SweepFolder folder;
    const auto tool_of = [&](const std::string& keys) {
        return folder.read(replaced(small_sweep, "\"prism-6\"", "{ " + keys + " }")).tools.at(0);
    };
    const std::filesystem::path mesh = folder.write("tools/pin.off", tetrahedron);
    const ToolChoice pin = tool_of(R"(file = "tools/pin.off", axis = [2, 0, 0], tip = [0, 0, 0], size = 50)");
    EXPECT_EQ(pin.tool->name, "pin s50");
    EXPECT_EQ(pin.tool->solid.support(Vec3::UnitZ()), Vec3(0, 0, 50));
    EXPECT_EQ(tool_of(R"(file = "tools/pin.off", axis = [0, 0, 1], name = "my pin")").tool->name, "my pin");

    // Neither the path nor the name makes a tool, nor the length of its axis; each other key does.
    static_cast<void>(folder.write("elsewhere/other.off", tetrahedron));
    EXPECT_EQ(
        tool_of(R"(file = "elsewhere/other.off", axis = [1, 0, 0], tip = [0, 0, 0], size = 50, name = "x")")
            .identity,
        pin.identity);
    static_cast<void>(folder.write("tools/turned.off", replaced(tetrahedron, "0 0 1", "0 0 2")));
    for (const char* other : {R"(file = "tools/pin.off", axis = [0, 1, 0], tip = [0, 0, 0], size = 50)",
                              R"(file = "tools/pin.off", axis = [2, 0, 0], tip = [0, 0, 0.1], size = 50)",
                              R"(file = "tools/pin.off", axis = [2, 0, 0], size = 50)",
                              R"(file = "tools/pin.off", axis = [2, 0, 0], tip = [0, 0, 0], size = 51)",
                              R"(file = "tools/pin.off", axis = [2, 0, 0], tip = [0, 0, 0])",
                              R"(file = "tools/turned.off", axis = [2, 0, 0], tip = [0, 0, 0], size = 50)"}) {
        EXPECT_NE(tool_of(other).identity, pin.identity) << other;
    }
}

TEST(ReadSweep, MistakesInAToolFromAFileAreAnsweredWithTheirPlace) {
    const SweepFolder folder;
    const std::filesystem::path mesh = folder.write("pin.off", tetrahedron);
    for (const auto& [keys, answer] : std::vector<std::pair<std::string, std::string>>{
             {"", ":4:10: a tool from a file needs the key axis"},
             {", axis = [0, 0, 0]", ":4:37: axis must be a direction"},
             {", axis = [0, 1]", ":4:37: axis must have three numbers, x, y and z, not 2"},
             {", axis = [0, 1, \"up\"]", ":4:44: axis must be a number"},
             {", axis = [0, 0, 1], tp = [0, 0, 0]", "did you mean \"tip\"?"},
             {", axis = [0, 0, 1], size = 0", ":4:55: size must be above 0"}}) {
        try {
            static_cast<void>(
                folder.read(replaced(small_sweep, "\"prism-6\"", "{ file = \"pin.off\"" + keys + " }")));
            FAIL() << keys << " was accepted";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(answer));
        }
    }
}

TEST(ReadSweep, AMissingFileIsNamed) {
    const SweepFolder folder;
    try {
        read_sweep(folder.path("none.toml"));
        FAIL() << "was accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(folder.path("none.toml").string()));
        EXPECT_THAT(error.what(), HasSubstr("No such file"));
    }
}

TEST(ReadSweep, ABrokenMeshFileIsNamed) {
    const SweepFolder folder;
    const std::filesystem::path mesh = folder.write("cut.off", std::string_view(tetrahedron).substr(0, 40));
    EXPECT_THROW(static_cast<void>(folder.read(
                     replaced(small_sweep, "\"sphere@12mm\"", "{ file = \"cut.off\", size = 50 }"))),
                 MeshError);
}

}  // namespace
}  // namespace trocar
