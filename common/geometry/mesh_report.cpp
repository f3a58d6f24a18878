#include <algorithm>

#include <fmt/format.h>

#include "common/geometry/mesh_check.h"

namespace trocar {

std::string describe(const Finding& finding) {
    const char* severity = "note";
    if (finding.severity == Finding::Severity::mended) severity = "mended";
    if (finding.severity == Finding::Severity::refused) severity = "refused";
    return fmt::format("{}: {}{}{}", severity, finding.what, finding.where.empty() ? "" : "; ",
                       finding.where);
}

std::string describe(const MeshReport& report) {
    const Vec3 size = report.box.size();
    const Vec3& low = report.box.low;
    const Vec3& high = report.box.high;
    std::string text = fmt::format("vertices    {}\nedges       {}\nfacets      {}\ncomponents  {}\n",
                                   report.vertices, report.edges, report.facets, report.components);
    text += fmt::format("surface     {}\n", report.closed ? "closed" : "open");
    if (report.genus) text += fmt::format("genus       {}\n", *report.genus);
    text += fmt::format(
        "box         {:.6g} × {:.6g} × {:.6g} mm, from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, "
        "{:.6g})\n",
        size.x(), size.y(), size.z(), low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
    text += fmt::format("edges long  {:.4g} to {:.4g} mm, median {:.4g} mm\n", report.shortest_edge,
                        report.longest_edge, report.median_edge);
    text += fmt::format("area        {:.6g} mm²\n", report.area);
    if (report.volume) text += fmt::format("volume      {:.6g} mm³\n", *report.volume);
    for (const Finding& finding : report.findings) text += describe(finding) + "\n";
    text += report.usable()
                ? "This mesh can be used.\n"
                : "This mesh cannot be used: repair it, for example in MeshLab, and check again.\n";
    return text;
}

}  // namespace trocar
