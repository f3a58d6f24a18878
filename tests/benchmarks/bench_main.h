#pragma once

namespace trocar {

/// The rest of a benchmark's main(): says in the output's context on which machine and from which commit and
/// compiler it is, then runs what was registered. Returns the program's exit code.
int run_benchmarks(int argc, char** argv);

}  // namespace trocar
