#include "experiments/metrics/paths/paths.h"

#include <algorithm>

#include "experiments/metrics/paths/arc.h"

namespace trocar {
namespace {

/// Whether a way between two points that strays from the straight one by at most `bulge` (mm) may meet the
/// tool.
bool may_meet(const JudgedTool& tool, const Vec3& from, const Vec3& to, double bulge) {
    Box box;
    box.add(from);
    box.add(to);
    return box.grown(bulge).overlaps(tool.box());
}

}  // namespace

Paths::Paths(const JudgedState& start)
    : in_tool_(start.in_tool()), pose_(start.pose()), left_inside_(start.inside()) {}

Passage Paths::passage_of(Index vertex) const {
    const auto found = entries_.find(vertex);
    return found == entries_.end() ? Passage() : Passage{.entry = found->second};
}

void Paths::keep(Index vertex, const Passage& passage) {
    if (passage.entry) {
        entries_[vertex] = *passage.entry;
    } else {
        entries_.erase(vertex);
    }
    if (passage.went_in) went_in_.insert(vertex);
}

void Paths::go_straight(const JudgedState& there) {
    const std::vector<Vec3>& now = there.in_tool();
    for (std::size_t k = 0; k < now.size(); ++k) {
        if (now[k] == in_tool_[k] || !may_meet(there.tool(), in_tool_[k], now[k], 0)) continue;
        const auto vertex = static_cast<Index>(k);
        Passage passage = passage_of(vertex);
        follow(there.tool(), in_tool_[k], now[k], passage);
        keep(vertex, passage);
    }
    in_tool_ = now;
}

void Paths::handle(const JudgedState& handled) {
    go_straight(handled);
    left_inside_ = handled.inside();
    went_in_.clear();
}

void Paths::deform(const JudgedState& deformed) { go_straight(deformed); }

void Paths::move(const JudgedState& before) {
    const JudgedTool& tool = before.tool();
    const Turn turn = Turn::seen_from(pose_, before.pose());
    const std::vector<Vec3>& now = before.in_tool();
    for (std::size_t k = 0; k < now.size(); ++k) {
        if (now[k] == in_tool_[k]) continue;
        const Arc arc(in_tool_[k], now[k], turn);
        if (!may_meet(tool, in_tool_[k], now[k], arc.bulge())) continue;
        const auto vertex = static_cast<Index>(k);
        Passage passage = passage_of(vertex);
        const int chords = arc.chords(arc_error);
        Vec3 here = in_tool_[k];
        for (int chord = 1; chord <= chords; ++chord) {
            const Vec3 next = arc.at(static_cast<double>(chord) / chords);
            follow(tool, here, next, passage);
            here = next;
        }
        keep(vertex, passage);
    }
    in_tool_ = now;
    pose_ = before.pose();
    tunnelled_.clear();
    for (const Index vertex : went_in_) {
        if (std::ranges::binary_search(left_inside_, vertex) || tool.contains(in_tool_[vertex])) continue;
        tunnelled_.push_back(vertex);
    }
}

std::size_t Paths::crossings(const JudgedState& handled) const {
    const std::vector<Vec3>& now = handled.in_tool();
    std::size_t crossings = 0;
    for (std::size_t k = 0; k < now.size(); ++k) {
        if (now[k] == in_tool_[k] || !may_meet(handled.tool(), in_tool_[k], now[k], 0)) continue;
        Passage passage = passage_of(static_cast<Index>(k));
        follow(handled.tool(), in_tool_[k], now[k], passage);
        if (passage.crossed && !handled.tool().contains(now[k])) ++crossings;
    }
    return crossings;
}

}  // namespace trocar
