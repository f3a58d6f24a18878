#include "common/process/messages.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include <sys/socket.h>

namespace trocar {
namespace {

constexpr std::size_t head_size = 1 + sizeof(std::uint64_t);

}  // namespace

bool send_bytes(int line, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = send(line, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

bool send_message(int line, char letter, std::string_view text) {
    std::array<char, head_size> head{letter};
    const std::uint64_t length = text.size();
    std::memcpy(&head[1], &length, sizeof(length));
    return send_bytes(line, {head.data(), head.size()}) && send_bytes(line, text);
}

void MessageCutter::append(std::string_view bytes) {
    bytes_.erase(0, start_);
    start_ = 0;
    bytes_ += bytes;
}

std::optional<Message> MessageCutter::next() {
    const std::size_t there = bytes_.size() - start_;
    if (there < head_size) return {};
    std::uint64_t length = 0;
    std::memcpy(&length, &bytes_[start_ + 1], sizeof(length));
    if (there - head_size < length) return {};
    Message message{.letter = bytes_[start_], .text = bytes_.substr(start_ + head_size, length)};
    start_ += head_size + length;
    return message;
}

}  // namespace trocar
