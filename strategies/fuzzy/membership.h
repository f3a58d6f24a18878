#pragma once

#include <array>

namespace trocar::fuzzy {

/// The curves that a term's membership may follow, with the meaning of Membership::at. All but the Gaussian
/// are zero outside and one within what they name; they are fuzzylite's terms of the same name.
enum class Curve {
    triangle,   ///< from 0 at a to 1 at b to 0 at c, straight
    trapezoid,  ///< from 0 at a to 1 at b, 1 until c, to 0 at d, straight
    ramp,       ///< from 0 at a to 1 at b, straight; where b < a it falls
    rectangle,  ///< 1 from a to b, both included
    s_shape,    ///< from 0 at a to 1 at b along two parabolas
    z_shape,    ///< from 1 at a to 0 at b along two parabolas
    pi_shape,   ///< s_shape from a to b times z_shape from c to d
    gaussian,   ///< exp(−(x − a)² / 2 b²)
};

/// How much a number belongs to a term.
struct Membership {
    Curve curve = Curve::triangle;
    std::array<double, 4> at{};  ///< a, b, c, d, as many as the curve has
    double height = 1;           ///< where the curve is one
};

/// The degree, in [0, height], to which x belongs to the term.
double degree(const Membership& membership, double x);

}  // namespace trocar::fuzzy
