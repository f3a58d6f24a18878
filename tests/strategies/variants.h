#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "strategies/registry.h"

namespace trocar {

/// A strategy with one choice of its options.
struct Variant {
    std::string name;
    Options options;
    std::string label;
};

inline void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.label; }

/// Every registered strategy: with its defaults, and with each option at each of its other values.
std::vector<Variant> all_variants();

}  // namespace trocar
