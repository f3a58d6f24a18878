#include <array>
#include <csignal>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <poll.h>
#include <rapidcheck/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "common/process/child.h"
#include "common/process/messages.h"

namespace trocar {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Both ends of a line within this process.
class Line {
  public:
    Line() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data()), 0); }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;
    ~Line() {
        close(ends_[0]);
        close_other();
    }

    [[nodiscard]] int end() const { return ends_[0]; }
    void close_other() { close(std::exchange(ends_[1], -1)); }

    /// All bytes that were sent from end().
    std::string received() {
        std::string bytes(1000, '\0');
        bytes.resize(static_cast<std::size_t>(read(ends_[1], bytes.data(), bytes.size())));
        return bytes;
    }

  private:
    std::array<int, 2> ends_{};
};

/// A message as it goes through a line, written down by hand: the least significant byte of the length first.
std::string in_a_line(char letter, const std::string& text) {
    std::string bytes{letter};
    for (unsigned shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(text.size() >> shift & 0xFFU);
    return bytes + text;
}

std::vector<std::string> texts_of(MessageCutter& cutter) {
    std::vector<std::string> texts;
    while (const auto message = cutter.next()) texts.push_back(message->letter + message->text);
    return texts;
}

/// Until there is something to read, or nobody left to write; false after 10 s without.
bool wait_for_something(int descriptor) {
    pollfd waiting{.fd = descriptor, .events = POLLIN, .revents = 0};
    return poll(&waiting, 1, 10'000) == 1;
}

/// All that a child says until it lets go of the line.
std::vector<Message> everything_from(Child& child) {
    std::vector<Message> all;
    while (!child.closed()) {
        wait_for_something(child.line());
        for (Message& message : child.messages()) all.push_back(std::move(message));
    }
    return all;
}

/// What a child that does only this has said, as letter and text, and how it ended.
std::pair<std::vector<std::string>, Ending> outcome_of(const Child::Life& life) {
    Child child(life);
    std::vector<std::string> texts;
    for (const Message& message : everything_from(child)) texts.push_back(message.letter + message.text);
    return {texts, child.end()};
}

TEST(Messages, AreALetterTheLengthAndTheText) {
    Line line;
    const std::string text("a\0b\xff", 4);
    EXPECT_TRUE(send_message(line.end(), 'x', text));
    EXPECT_EQ(line.received(), in_a_line('x', text));
    EXPECT_TRUE(send_message(line.end(), 'y', ""));
    EXPECT_EQ(line.received(), in_a_line('y', ""));
}

TEST(Messages, ThatNobodyListensToRaiseNoSignal) {
    Line line;
    line.close_other();
    EXPECT_FALSE(send_message(line.end(), 'x', "text"));
    EXPECT_FALSE(send_bytes(line.end(), "text"));
}

TEST(Messages, OneThatIsCutInTwoComesWhenItIsWhole) {
    const std::string bytes = in_a_line('x', "text");
    for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
        MessageCutter cutter;
        cutter.append(bytes.substr(0, cut));
        EXPECT_FALSE(cutter.next()) << cut;
        cutter.append(bytes.substr(cut));
        EXPECT_THAT(texts_of(cutter), ElementsAre("xtext")) << cut;
    }
}

TEST(Messages, OneThatClaimsMoreThanThereIsNeverComes) {
    MessageCutter cutter;
    cutter.append(std::string(1, 'x') + std::string(8, '\xff') + "text");
    EXPECT_FALSE(cutter.next());
}

RC_GTEST_PROP(Messages, AreTheSameHoweverTheyAreCut,
              (const std::vector<std::pair<char, std::string>>& said)) {
    std::string bytes;
    std::vector<std::string> expected;
    for (const auto& [letter, text] : said) {
        bytes += in_a_line(letter, text);
        expected.push_back(letter + text);
    }
    MessageCutter cutter;
    std::vector<std::string> found;
    while (!bytes.empty()) {
        const auto count = *rc::gen::inRange<std::size_t>(1, bytes.size() + 1);
        cutter.append(bytes.substr(0, count));
        bytes.erase(0, count);
        for (std::string& text : texts_of(cutter)) found.push_back(std::move(text));
    }
    RC_ASSERT(found == expected);
}

TEST(Child, SaysMessagesOfAnyLength) {
    const std::string long_text(3'000'000, 'x');
    const auto [texts, ending] = outcome_of([&](int line) {
        send_message(line, 'a', "");
        send_message(line, 'b', long_text);
        send_message(line, 'c', "");
    });
    EXPECT_THAT(texts, ElementsAre("a", "b" + long_text, "c"));
    EXPECT_EQ(ending.text, "exit code 0");
    EXPECT_EQ(ending.signal, 0);
}

TEST(Child, IsSpokenToThroughTheSameLine) {
    Child child([](int line) {
        char letter = 0;
        if (read(line, &letter, 1) == 1) send_message(line, letter, "heard");
    });
    EXPECT_THAT(child.messages(), IsEmpty()) << "it waits";
    EXPECT_TRUE(send_bytes(child.line(), "q"));
    const auto messages = everything_from(child);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages.front().letter, 'q');
    EXPECT_EQ(messages.front().text, "heard");
}

TEST(Child, ThatIsKilledInTheMiddleOfAMessage) {
    const auto [texts, ending] = outcome_of([](int line) {
        send_message(line, 'a', "whole");
        send_bytes(line, in_a_line('b', "cut off").substr(0, 12));
        std::raise(SIGKILL);
    });
    EXPECT_THAT(texts, ElementsAre("awhole"));
    EXPECT_EQ(ending.text, "signal 9 (Killed)");
    EXPECT_TRUE(ending.killed());
}

TEST(Child, ThatExitsWithoutAWord) {
    const auto [texts, ending] = outcome_of([](int) { _exit(7); });
    EXPECT_THAT(texts, IsEmpty());
    EXPECT_EQ(ending.text, "exit code 7");
    EXPECT_EQ(ending.signal, 0);
    EXPECT_FALSE(ending.killed());
}

TEST(Child, ThatEndsBySomeOtherSignalWasNotKilled) {
    const auto [texts, ending] = outcome_of([](int) { std::raise(SIGTERM); });
    EXPECT_EQ(ending.signal, SIGTERM);
    EXPECT_EQ(ending.text, "signal 15 (Terminated)");
    EXPECT_FALSE(ending.killed());
}

TEST(Child, ThatThrowsDoesNotGoOnAsItsParent) {
    const auto [texts, ending] = outcome_of([](int) {
        close(STDERR_FILENO);  // what the C++ library says of it
        throw std::runtime_error("no");
    });
    EXPECT_EQ(ending.signal, SIGABRT);
}

TEST(Child, ThatDoesNotEndIsKilled) {
    Child child([](int) {
        while (true) pause();
    });
    EXPECT_EQ(child.end().text, "signal 9 (Killed)");
    EXPECT_EQ(child.process(), -1);
    EXPECT_EQ(child.end().text, "") << "it has said so";
    EXPECT_FALSE(child.closed()) << "not looked yet";
    EXPECT_THAT(child.messages(), IsEmpty());
    EXPECT_TRUE(child.closed());
}

TEST(Child, DiesWithItsObject) {
    pid_t process = 0;
    {
        const Child child([](int) {
            while (true) pause();
        });
        process = child.process();
        EXPECT_EQ(kill(process, 0), 0);
    }
    EXPECT_EQ(kill(process, 0), -1) << "it is waited for";
}

TEST(Child, DiesWithItsParent) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    Child parent([&](int line) {
        const Child grandchild([](int) {
            alarm(20);  // if nobody ends it, it ends all the same
            pause();
        });
        send_message(line, 'a', "made");
        pause();
    });
    close(ends[1]);
    // A message may arrive in pieces.
    std::vector<Message> said;
    while (said.empty() && wait_for_something(parent.line())) said = parent.messages();
    EXPECT_EQ(said.size(), 1U);
    parent.end();
    // The pipe ends when nobody holds its other end any more.
    EXPECT_TRUE(wait_for_something(ends[0])) << "the grandchild lives";
    close(ends[0]);
}

}  // namespace
}  // namespace trocar
