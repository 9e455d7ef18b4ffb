// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/slcan_feeder.h"

#include "can/can_bits.h"
#include "can/slcan_codec.h"
#include "kinds/canopen/protocol/cob_id.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace codewheel::bench {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

std::string answerTo(char command)
{
    switch (command) {
    case 'V':
        return "V1013\r";
    case 'F':
        return "F00\r";
    case 'S':
    case 'O':
    case 'L':
    case 'C':
        return "\r";
    default:
        return "\a";
    }
}

void writeAll(int port, const char *bytes, std::size_t size)
{
    for (std::size_t at = 0; at < size;) {
        const auto written = ::write(port, bytes + at, size - at);
        if (written <= 0)
            ::_exit(1);
        at += static_cast<std::size_t>(written);
    }
}

struct Line
{
    std::size_t end = 0; // in the text of all
    std::int64_t at = 0;
};

// In the child: until it is ended.
class Adapter
{
public:
    Adapter(int port, const std::vector<TimedFrame> &frames, SlcanFeeder::Pace pace)
        : m_port(port)
        , m_pace(pace)
    {
        for (const TimedFrame &one : frames) {
            m_text += slcanCommand(one.frame).toStdString();
            m_lines.push_back({m_text.size(), one.at});
        }
    }

    [[noreturn]] void serve()
    {
        for (;;) {
            obey(m_isOpen && m_next < m_lines.size() ? 0 : 1'000);
            if (m_isOpen && m_next < m_lines.size())
                send();
        }
    }

private:
    void obey(int milliseconds)
    {
        pollfd waited{m_port, POLLIN, 0};
        if (::poll(&waited, 1, milliseconds) != 1)
            return;
        std::array<char, 256> bytes{};
        const auto count = ::read(m_port, bytes.data(), bytes.size());
        for (ssize_t i = 0; i < count; ++i) {
            if (bytes.at(static_cast<std::size_t>(i)) != '\r') {
                m_command += bytes.at(static_cast<std::size_t>(i));
                continue;
            }
            const char letter = m_command.empty() ? '\0' : m_command.front();
            m_command.clear();
            const std::string answer = answerTo(letter);
            writeAll(m_port, answer.data(), answer.size());
            if (letter == 'O' || letter == 'L') {
                m_isOpen = true;
                m_begin = Clock::now() + 500ms;
            } else if (letter == 'C') {
                m_isOpen = false;
            }
        }
    }
    void send()
    {
        constexpr std::size_t atOnce = 100;
        const std::size_t first = m_next == 0 ? 0 : m_lines[m_next - 1].end;
        if (m_pace == SlcanFeeder::Pace::real) {
            const auto now =
                std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - m_begin).count();
            while (m_next < m_lines.size() && m_lines[m_next].at <= now)
                ++m_next;
        } else {
            m_next = std::min(m_next + atOnce, m_lines.size());
        }
        const std::size_t end = m_next == 0 ? 0 : m_lines[m_next - 1].end;
        if (end > first)
            writeAll(m_port, m_text.data() + first, end - first);
        if (m_pace == SlcanFeeder::Pace::real)
            std::this_thread::sleep_for(1ms);
    }

    const int m_port;
    const SlcanFeeder::Pace m_pace;
    std::string m_text;
    std::vector<Line> m_lines;
    std::size_t m_next = 0;
    std::string m_command;
    bool m_isOpen = false;
    Clock::time_point m_begin{};
};

CanFrame pdoOf(int node, int count)
{
    const auto position = static_cast<std::uint32_t>(node * 1'000 + count);
    CanFrame frame{.id = 0x180U + static_cast<std::uint32_t>(node), .length = 4};
    for (int i = 0; i < 4; ++i)
        frame.bytes.at(static_cast<std::size_t>(i)) = static_cast<std::uint8_t>(position >> 8 * i);
    return frame;
}

} // namespace

std::vector<TimedFrame> fullBus(int seconds)
{
    constexpr int nodes = 64;
    constexpr std::int64_t interval = 10'000; // us
    constexpr std::int64_t bitTime = 1;       // us
    constexpr std::int64_t longestFrame = 135 * bitTime;
    std::vector<TimedFrame> frames;
    std::int64_t at = 0;
    const auto add = [&](const CanFrame &frame) {
        at += (canBits(frame) + canIntermission) * bitTime;
        frames.push_back({frame, at});
    };
    for (int cycle = 0; cycle < seconds * 100; ++cycle) {
        at = std::max(at, cycle * interval);
        for (int node = 1; node <= nodes; ++node)
            add(pdoOf(node, cycle));
        const std::int64_t end = (cycle + 1) * interval - longestFrame;
        int other = nodes;
        while (at < end) {
            other = other < canopen::lastNode ? other + 1 : nodes + 1;
            add({.id = 0x280U + static_cast<std::uint32_t>(other),
                 .length = 8,
                 .bytes = {static_cast<std::uint8_t>(cycle), 0x55, 0x12, 0x34, 0xAA, 0xCC, 0x01, 0xFE}});
        }
    }
    return frames;
}

SlcanFeeder::SlcanFeeder(const std::vector<TimedFrame> &frames, Pace pace)
{
    const int ours = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ::grantpt(ours);
    ::unlockpt(ours);
    std::array<char, 128> path{};
    ::ptsname_r(ours, path.data(), path.size());
    m_port = path.data();
    const int theirs = ::open(path.data(), O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT(*-vararg)
    termios settings = {};
    ::tcgetattr(theirs, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(theirs, TCSANOW, &settings);
    m_process = ::fork();
    if (m_process == 0)
        Adapter(ours, frames, pace).serve();
    ::close(theirs); // the child keeps its own
    ::close(ours);
}

SlcanFeeder::~SlcanFeeder()
{
    ::kill(m_process, SIGKILL);
    ::waitpid(m_process, nullptr, 0);
}

} // namespace codewheel::bench
