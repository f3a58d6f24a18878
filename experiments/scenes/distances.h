#pragma once

/// Lengths and times that scenes have in common.
namespace trocar::scenes {

inline constexpr double clear = 3;     ///< mm outside the organ at rest, where a tool comes from and goes to
inline constexpr double deep = 12;     ///< mm below the organ's surface at rest
inline constexpr double hold_s = 0.5;  ///< s held still where the way in ends
inline constexpr double rest_s = 1;    ///< s after the tool has left

}  // namespace trocar::scenes
