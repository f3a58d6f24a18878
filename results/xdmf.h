#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace trocar {

/// Writes an XDMF file through which ParaView opens the replays of the result file `campaign`: for each case
/// the deformed organ and the placed tool over time, with the positions before and after handling as vectors
/// on the organ's vertices. It refers to the result file by a relative path: keep the two together. Throws
/// StoreError when the result file cannot be read or holds no replay.
/// @param only_case the id of the one case to show; none for all that have a replay
void write_xdmf(const std::filesystem::path& campaign, const std::filesystem::path& out_xdmf,
                const std::optional<std::string>& only_case = std::nullopt);

}  // namespace trocar
