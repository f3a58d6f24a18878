#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/store.h"

// libhdf5 1.10.8 crashes on some damaged files, and others ask it for any amount of memory or time. So
// whatever reads a file does it in a child process, which can end as it likes.
namespace trocar {

/// A file whose reader crashed, hung or asked for too much.
struct DamagedFile : StoreError {
    using StoreError::StoreError;
};

/// Runs `read` in a child process, with HDF5 to itself (see hdf5::Session), and returns what it returns.
/// `read` calls now_reading before it turns to a file, and from time to time.
/// @param files  what it reads: the memory and the time that it may use grow with their size
/// Throws StoreError: what `read` threw; or DamagedFile, naming the file that was being read, that the child
/// was ended by a signal, used more memory or processor time than it may, or gave no sign of life for two
/// minutes.
std::string supervised(std::span<const std::filesystem::path> files,
                       const std::function<std::string()>& read);

/// Tells the supervising process, if there is one, that all is well and which file is being read.
void now_reading(const std::filesystem::path& file);

/// In the child: hands its parent this message of a StoreError and ends the child here. Elsewhere does
/// nothing. libhdf5 1.10.8 crashes when a file is closed that it could not write to, as unwinding would do.
void end_with_error(const std::string& message);

/// @{
/// A list of texts as one text, to be handed from the child to its parent.
std::string joined_texts(std::span<const std::string> texts);
std::vector<std::string> split_texts(std::string_view joined);  ///< throws StoreError when it is no such text
/// @}

}  // namespace trocar
