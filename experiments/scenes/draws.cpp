#include "experiments/scenes/draws.h"

#include <cmath>

#include <Random123/philox.h>

namespace trocar {

std::array<double, 4> draw(std::uint64_t seed, std::uint64_t counter) {
    const r123::Philox4x64::ctr_type words = r123::Philox4x64()({{counter, 0, 0, 0}}, {{seed, 0}});
    std::array<double, 4> uniform{};
    for (std::size_t k = 0; k < uniform.size(); ++k) {
        uniform[k] = std::ldexp(static_cast<double>(words[k] >> 11U), -53);  // the upper 53 bits
    }
    return uniform;
}

}  // namespace trocar
