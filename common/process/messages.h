#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace trocar {

/// What one process says to another.
struct Message {
    char letter = 0;   ///< what kind of message; the two agree on what it means
    std::string text;  ///< any bytes, any number of them
};

/// Sends all of the bytes through a socket.
/// @returns false when nobody listens any more; no signal is raised then
bool send_bytes(int line, std::string_view bytes);

/// Sends a message through a socket: the letter, the length of the text (8 bytes, as this machine orders
/// them), the text.
/// @returns false when nobody listens any more
bool send_message(int line, char letter, std::string_view text);

/// Cuts what comes through a line into the messages that it is made of.
class MessageCutter {
  public:
    /// What came next, wherever it was cut.
    void append(std::string_view bytes);

    /// Takes out the next message; nothing while it is not there to its end.
    std::optional<Message> next();

  private:
    std::string bytes_;
    std::size_t start_ = 0;  // of what was not taken out yet
};

}  // namespace trocar
