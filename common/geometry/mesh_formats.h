#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trocar {

// CGAL reads the formats. It trusts a file more than is safe, and says only "false" about a bad one. What is
// done about that is here. `file` is only named in messages.

/// What CGAL is given to read.
struct MeshText {
    std::string text;
    std::size_t facets = 0;  ///< so many must come out
};

/// @{
/// Makes of a file's content what CGAL reads safely and rightly. Throws MeshError where nothing here can.
MeshText prepare_off(const std::string& file, std::string_view content);
MeshText prepare_obj(const std::string& file, std::string_view content);
MeshText prepare_stl(const std::string& file, std::string_view content);
MeshText prepare_ply(const std::string& file, std::string_view content);
/// @}

/// @{
/// For a text that CGAL could not read: throws MeshError at its first bad place. Returns when it finds none.
void scan_off(const std::string& file, std::string_view content);
void scan_obj(const std::string& file, std::string_view content);
void scan_stl(const std::string& file, std::string_view content);
/// @}

}  // namespace trocar
