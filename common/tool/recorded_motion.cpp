#include "common/tool/recorded_motion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace trocar {
namespace {

constexpr std::array<std::string_view, 8> columns{"t", "x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr double quaternion_tolerance = 1e-3;

using Row = std::array<double, columns.size()>;

/// One line of the text, and where it stands.
struct Line {
    std::string_view text;
    int number;  // from 1
};

[[noreturn]] void refuse(const Line& line, std::size_t column, const std::string& message) {
    throw MotionError(fmt::format("{}:{}: {}", line.number, column + 1, message));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<Line> lines_of(std::string_view text) {
    std::vector<Line> lines;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view content = trimmed(text.substr(0, end));
        if (!content.empty() && !content.starts_with('#')) lines.push_back({text.substr(0, end), number});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// Calls `use(cell, column of the line)` for each comma-separated cell, and demands as many as there are
/// columns.
template <typename Use>
void for_each_cell(const Line& line, const Use& use) {
    std::size_t start = 0;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (start > line.text.size()) {
            refuse(line, line.text.size(),
                   fmt::format("{} values; expected {} ({})", k, columns.size(), fmt::join(columns, ", ")));
        }
        const std::size_t end = std::min(line.text.find(',', start), line.text.size());
        use(k, trimmed(line.text.substr(start, end - start)), start);
        start = end + 1;
    }
    if (start <= line.text.size()) {
        refuse(line, start, fmt::format("more than {} values", columns.size()));
    }
}

void check_header(const Line& line) {
    for_each_cell(line, [&](std::size_t k, std::string_view cell, std::size_t column) {
        if (cell == columns[k]) return;
        refuse(line, column,
               fmt::format("expected the column name {}, found \"{}\"; the first line must be: {}",
                           columns[k], cell, fmt::join(columns, ",")));
    });
}

Row read_row(const Line& line) {
    Row row{};
    for_each_cell(line, [&](std::size_t k, std::string_view cell, std::size_t column) {
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), row[k]);
        if (error == std::errc() && end == cell.data() + cell.size() && std::isfinite(row[k])) return;
        refuse(line, column, fmt::format("{} must be a finite number, found \"{}\"", columns[k], cell));
    });
    return row;
}

Pose pose_of(const Row& row, const Line& line) {
    const Eigen::Quaterniond turn(row[4], row[5], row[6], row[7]);
    if (std::abs(turn.norm() - 1) > quaternion_tolerance) {
        refuse(
            line, 0,
            fmt::format("qw, qx, qy, qz must be a unit quaternion; this one has length {:.6g}", turn.norm()));
    }
    return {.rotation = turn.normalized().toRotationMatrix(), .position = {row[1], row[2], row[3]}};
}

}  // namespace

Pose RecordedMotion::at(double since_start) const {
    const double time = times.front() + since_start;
    const auto after = std::ranges::upper_bound(times, time);
    if (after == times.begin()) return poses.front();
    if (after == times.end()) return poses.back();
    const auto k = static_cast<std::size_t>(after - times.begin());
    const double part = (time - times[k - 1]) / (times[k] - times[k - 1]);
    return between(poses[k - 1], poses[k], part);
}

double RecordedMotion::tip_speed() const {
    double squares = 0;  // integral of the squared speed over time
    for (std::size_t k = 1; k < times.size(); ++k) {
        squares += (poses[k].position - poses[k - 1].position).squaredNorm() / (times[k] - times[k - 1]);
    }
    return std::sqrt(squares / duration());
}

RecordedMotion parse_recorded_motion(std::string_view text) {
    const std::vector<Line> lines = lines_of(text);
    if (lines.empty()) throw MotionError("1:1: no recorded motion; the file is empty");
    check_header(lines.front());
    RecordedMotion motion;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const Row row = read_row(lines[k]);
        if (!motion.times.empty() && row[0] <= motion.times.back()) {
            refuse(lines[k], 0,
                   fmt::format("times must ascend; {} s comes after {} s", row[0], motion.times.back()));
        }
        motion.times.push_back(row[0]);
        motion.poses.push_back(pose_of(row, lines[k]));
    }
    if (motion.times.size() < 2) {
        refuse(lines.back(), 0, "a motion needs at least two poses");
    }
    return motion;
}

}  // namespace trocar
