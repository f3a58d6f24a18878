#include "box_organ.h"

#include <array>
#include <map>

namespace trocar {

Organ box_organ(const Vec3& low, const Vec3& high, int cells) {
    SurfaceMesh mesh;
    std::map<std::array<int, 3>, Index> numbers;
    const auto corner = [&](std::array<int, 3> at) {
        const auto [found, fresh] = numbers.emplace(at, static_cast<Index>(mesh.positions.size()));
        if (fresh) {
            Vec3 p;
            for (int k = 0; k < 3; ++k) p[k] = low[k] + (high[k] - low[k]) * at[k] / cells;
            mesh.positions.push_back(p);
        }
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, cells}) {
            for (int i = 0; i < cells; ++i) {
                for (int j = 0; j < cells; ++j) {
                    const auto at = [&](int u, int v) {
                        std::array<int, 3> cell{};
                        cell[axis] = side;
                        cell[(axis + 1) % 3] = u;
                        cell[(axis + 2) % 3] = v;
                        return corner(cell);
                    };
                    const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
                    mesh.facets.push_back(side == 0 ? Facet{a, c, b} : Facet{a, b, c});
                    mesh.facets.push_back(side == 0 ? Facet{a, d, c} : Facet{a, c, d});
                }
            }
        }
    }
    return make_organ("box", mesh);
}

}  // namespace trocar
