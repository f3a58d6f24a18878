// The planes of a convex tool against the search that serves any tool.

#include "common/geometry/general_solid.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/geometry/convex_solid.h"
#include "common/tool/tool_shapes.h"
#include "tests/random_numbers.h"

namespace trocar {
namespace {

using testing_support::random_direction;
using testing_support::random_number;
using testing_support::random_point;

class BothPaths : public testing::TestWithParam<const char*> {
  protected:
    /// A point of the solid's surface: of a facet's inside, of an edge, or a corner.
    [[nodiscard]] Vec3 random_surface_point() const {
        const auto facet = *rc::gen::inRange<Index>(0, static_cast<Index>(mesh_.mesh.facets.size()));
        const Corners c = mesh_.corners(facet);
        const int corners = *rc::gen::inRange(1, 4);
        if (corners == 1) return c[0];
        const double along = random_number(0, 1), across = corners == 3 ? random_number(0, 1 - along) : 0;
        return c[0] + along * (c[1] - c[0]) + across * (c[2] - c[0]);
    }

    SolidMesh mesh_{make_tool_by_formula(GetParam()).mesh};
    ConvexSolid fast_{mesh_};
    GeneralSolid general_{mesh_};
};

TEST_P(BothPaths, AgreeOnWhatIsInside) {
    EXPECT_TRUE(rc::check([&] {
        for (int k = 0; k < 20; ++k) {
            const Vec3 anywhere = random_point(mesh_.box.grown(0.1)), on_surface = random_surface_point();
            RC_ASSERT(fast_.contains(anywhere) == general_.contains(anywhere));
            // As near to the surface as numbers allow, on it or on either side.
            RC_ASSERT(fast_.contains(on_surface) == general_.contains(on_surface));
        }
    }));
    for (const Vec3& corner : mesh_.mesh.positions) {
        EXPECT_FALSE(fast_.contains(corner));
        EXPECT_FALSE(general_.contains(corner));
    }
}

TEST_P(BothPaths, AgreeOnWhichFacetsCross) {
    int crossing = 0;
    EXPECT_TRUE(rc::check([&] {
        for (int k = 0; k < 10; ++k) {
            Corners facet;
            facet[0] =
                *rc::gen::element(0, 1) == 0 ? random_point(mesh_.box.grown(0.5)) : random_surface_point();
            facet[1] = facet[0] + random_number(0.01, 4) * random_direction();
            facet[2] = *rc::gen::element(0, 1) == 0 ? facet[0] + random_number(0.01, 4) * random_direction()
                                                    : random_surface_point();
            RC_ASSERT(fast_.crossed_by(facet) == general_.crossed_by(facet));
            crossing += fast_.crossed_by(facet) ? 1 : 0;
        }
    }));
    EXPECT_GT(crossing, 50);
}

INSTANTIATE_TEST_SUITE_P(ConvexTools, BothPaths,
                         testing::Values("prism-3", "prism-12", "pointed-prism-5", "needle"),
                         [](const auto& tool) {
                             std::string name = tool.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(GeneralSolid, IsCrossedByFacetsThatCrossOneOfItsOwn) {
    const Tool tool = make_grasper();
    const SolidMesh mesh(tool.mesh);
    const GeneralSolid general(mesh);
    EXPECT_TRUE(rc::check([&] {
        Corners facet;
        facet[0] = random_point(Box{{-3, -9, -1}, {3, 9, 20}});
        for (int k = 1; k < 3; ++k) facet[k] = facet[0] + random_number(0.1, 6) * random_direction();
        bool crosses = false;
        for (Index f = 0; f < static_cast<Index>(mesh.mesh.facets.size()); ++f) {
            crosses = crosses || facets_cross(facet, mesh.corners(f), mesh.flat_edges[f]);
        }
        RC_ASSERT(general.crossed_by(facet) == crosses);
    }));
}

}  // namespace
}  // namespace trocar
