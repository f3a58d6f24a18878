#pragma once

namespace trocar {

/// Bytes per second that one core moves between memory and itself: the triad a = b + s c of McCalpin's STREAM
/// on arrays larger than the last cache, best of ten; counted as STREAM does, three numbers of each element.
double triad_bandwidth();

/// Bytes of the last cache; 32 MB where the system does not say.
double last_cache();

/// The least that the deformation of one step must read and write, in bytes, when so many vertices move: of
/// each its position and velocity (both ways), place at rest, mass and stiffness (read), and of each of its
/// three springs two vertex numbers and the length at rest, all numbers of 8 bytes. Once a step where that
/// fits the last cache, otherwise once a substep.
double least_bytes(double moving_vertices, int substeps);

}  // namespace trocar
