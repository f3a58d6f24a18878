#include "common/detection/patch_tree.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_number;
using testing_support::random_point;

Box random_box(double longest) {
    const Vec3 low = random_point({Vec3::Constant(-50), Vec3::Constant(50)});
    return {low, low + random_point({Vec3::Zero(), Vec3::Constant(longest)})};
}

RC_GTEST_PROP(PatchTree, FindsWhatTestingEveryBoxFindsHoweverBoxesMove, ()) {
    std::vector<Box> boxes;
    for (int k = static_cast<int>(random_number(1, 200)); k > 0; --k) boxes.push_back(random_box(10));
    PatchTree tree(boxes);
    for (int round = 0; round < 10; ++round) {
        for (int k = 0; k < 5; ++k) {
            const auto number =
                static_cast<std::uint32_t>(random_number(0, static_cast<double>(boxes.size() - 1)));
            boxes[number] = random_box(30);
            tree.set(number, boxes[number]);
        }
        const Box query = random_box(40);
        std::vector<std::uint32_t> found, expected;
        tree.find(query, found);
        for (std::uint32_t k = 0; k < boxes.size(); ++k) {
            if (boxes[k].overlaps(query)) expected.push_back(k);
        }
        std::ranges::sort(found);
        RC_ASSERT(found == expected);
    }
}

TEST(PatchTree, TouchingBoxesMeet) {
    const PatchTree tree(std::vector<Box>{{{0, 0, 0}, {1, 1, 1}}, {{3, 0, 0}, {4, 1, 1}}});
    std::vector<std::uint32_t> found;
    tree.find({{1, 1, 1}, {2, 2, 2}}, found);
    EXPECT_EQ(found, std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace trocar
