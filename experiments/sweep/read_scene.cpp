#include <array>
#include <string>

#include <fmt/format.h>

#include "common/nearest_name.h"
#include "experiments/input_error.h"
#include "experiments/sweep/entries.h"
#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

const SceneEntry& known_scene(const ConfigValue& name) {
    try {
        return find_scene(as_text(name, "a scene"));
    } catch (const std::invalid_argument& unknown) {
        throw PlacedError(name.place, unknown.what());
    }
}

Recording::Frame read_frame(const ConfigTable& table) {
    static const std::array<std::string, 2> words{"organ", "entry"};
    const ConfigValue* value = find(table, "frame");
    if (value == nullptr) return Recording::Frame::organ;
    const std::string& word = as_text(*value, "frame");
    if (word == words[0]) return Recording::Frame::organ;
    if (word == words[1]) return Recording::Frame::entry;
    throw PlacedError(value->place, unknown_name("frame", word, words));
}

SceneChoice from_recording(const SceneEntry& entry, const ConfigTable& table, Place place,
                           const std::filesystem::path& folder) {
    const ConfigValue* file_value = find(table, "file");
    if (file_value == nullptr) {
        throw PlacedError(place, fmt::format("the scene {} needs the key file: a CSV of poses", entry.name));
    }
    const std::filesystem::path file = folder / as_text(*file_value, "file");
    const Recording::Frame frame = read_frame(table);
    try {
        const std::string bytes = read_bytes(file);
        auto recording = std::make_shared<const Recording>(
            Recording{.motion = parse_recorded_motion(bytes), .frame = frame});
        return {.entry = &entry,
                .name = fmt::format("{}:{}", entry.name, file.stem().string()),
                .identity = fmt::format("{}, {}, frame {}", entry.name, hash_of(bytes),
                                        frame == Recording::Frame::entry ? "entry" : "organ"),
                .recording = std::move(recording)};
    } catch (const MotionError& error) {
        throw InputError(fmt::format("{}:{}", file.string(), error.what()));
    } catch (const InputError& error) {
        throw PlacedError(file_value->place,
                          fmt::format("{}; paths are relative to the sweep file", error.what()));
    }
}

SceneChoice from_table(const ConfigTable& table, Place place, const std::filesystem::path& folder) {
    static const std::array<std::string, 3> keys{"name", "file", "frame"};
    check_keys(table, "key of a scene", keys);
    const ConfigValue* name = find(table, "name");
    if (name == nullptr) throw PlacedError(place, "a scene's table needs the key name");
    const SceneEntry& entry = known_scene(*name);
    if (!entry.needs_recording) {
        throw PlacedError(
            place, fmt::format("the scene {} has no parameters; write \"{}\"", entry.name, entry.name));
    }
    return from_recording(entry, table, place, folder);
}

}  // namespace

SceneChoice read_scene_entry(const ConfigValue& entry, const std::filesystem::path& folder) {
    if (const auto* table = std::get_if<ConfigTable>(&entry.content)) {
        return from_table(*table, entry.place, folder);
    }
    const SceneEntry& scene = known_scene(entry);
    if (scene.needs_recording) {
        throw PlacedError(entry.place, fmt::format("the scene {} needs a file: {{ name = \"{}\", file = "
                                                   "\"poses.csv\", frame = \"entry\" }}",
                                                   scene.name, scene.name));
    }
    return {.entry = &scene, .name = scene.name, .identity = scene.name, .recording = nullptr};
}

}  // namespace trocar
