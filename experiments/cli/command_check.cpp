#include <memory>
#include <optional>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "common/geometry/mesh_check.h"
#include "common/geometry/mesh_input.h"
#include "experiments/cli/commands.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "Exit codes: 0 the mesh can be used; 2 it cannot: the file is not readable, or the surface is refused.\n"
    "Example:\n"
    "  trocar check organ.off --size 100";

int check(const std::string& file, const std::optional<double>& size) {
    SurfaceMesh mesh = read_mesh(file);
    if (size) scale_to_size(mesh, *size);
    const MeshReport report = check_mesh(mesh);
    fmt::print("{}", describe(report));
    return report.usable() ? ExitCode::done : ExitCode::bad_input;
}

}  // namespace

void add_check(CLI::App& app, Program& program) {
    struct CheckOptions {
        std::string file;
        std::optional<double> size;
    };
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command =
        app.add_subcommand("check", "Say whether a mesh file can be an organ, and what it is like");
    command->footer(footer);
    command->add_option("MESH", options->file, "OFF, OBJ, STL or PLY file of triangles")->required();
    command->add_option("--size", options->size,
                        "scale it until its longest side is this long, mm; without it numbers count as mm");
    command->callback([options, &program] { program.exit_code = check(options->file, options->size); });
}

}  // namespace trocar
