// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/pseudo_terminal.h"

#include "cli/call/texts.h"

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <poll.h>
#include <sys/inotify.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace codewheel {
namespace {

constexpr int none = -1;

int openTerminal(const char *path)
{
    return ::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC); // NOLINT(cppcoreguidelines-pro-type-vararg)
}

int watchOf(const char *path)
{
    const int watch = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    if (watch >= 0)
        ::inotify_add_watch(watch, path, IN_OPEN | IN_CLOSE);
    return watch;
}

// Bytes pass unchanged; 19200 Bd until somebody sets another rate.
void setRaw(int terminal)
{
    termios settings = {};
    ::tcgetattr(terminal, &settings);
    ::cfmakeraw(&settings);
    ::cfsetspeed(&settings, B19200);
    ::tcsetattr(terminal, TCSANOW, &settings);
}

} // namespace

std::optional<PseudoTerminal> PseudoTerminal::make()
{
    const int ours = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    if (ours < 0)
        return std::nullopt;
    std::array<char, 128> path{};
    const bool isReady =
        ::grantpt(ours) == 0 && ::unlockpt(ours) == 0 && ::ptsname_r(ours, path.data(), path.size()) == 0;
    const int theirs = isReady ? openTerminal(path.data()) : none;
    if (theirs < 0) {
        ::close(ours);
        return std::nullopt;
    }
    setRaw(theirs);
    return PseudoTerminal(ours, theirs, watchOf(path.data()), QString::fromLocal8Bit(path.data()));
}

PseudoTerminal::PseudoTerminal(int ours, int theirs, int watch, QString path)
    : m_ours(ours)
    , m_theirs(theirs)
    , m_watch(watch)
    , m_path(std::move(path))
{}

PseudoTerminal::PseudoTerminal(PseudoTerminal &&other) noexcept
    : m_ours(std::exchange(other.m_ours, none))
    , m_theirs(std::exchange(other.m_theirs, none))
    , m_watch(std::exchange(other.m_watch, none))
    , m_clients(other.m_clients)
    , m_path(std::move(other.m_path))
{}

PseudoTerminal::~PseudoTerminal()
{
    for (const int end : {m_theirs, m_ours, m_watch})
        if (end >= 0)
            ::close(end);
}

int PseudoTerminal::baudRate() const
{
    constexpr std::array<std::pair<speed_t, int>, 9> rates{{{B1200, 1'200},
                                                            {B2400, 2'400},
                                                            {B4800, 4'800},
                                                            {B9600, 9'600},
                                                            {B19200, 19'200},
                                                            {B38400, 38'400},
                                                            {B57600, 57'600},
                                                            {B115200, 115'200},
                                                            {B230400, 230'400}}};
    termios settings = {};
    ::tcgetattr(m_theirs, &settings);
    const auto found = std::ranges::find(rates, ::cfgetospeed(&settings), &std::pair<speed_t, int>::first);
    return found == rates.end() ? 0 : found->second;
}

void PseudoTerminal::wait(int wake, std::chrono::microseconds atMost) const
{
    using namespace std::chrono;
    const timespec timeOut{duration_cast<seconds>(atMost).count(), nanoseconds(atMost % seconds(1)).count()};
    std::array<pollfd, 3> waited{{{m_ours, POLLIN, 0}, {m_watch, POLLIN, 0}, {wake, POLLIN, 0}}};
    ::ppoll(waited.data(), waited.size(), &timeOut, nullptr);
}

bool PseudoTerminal::clientLeft()
{
    bool left = false;
    inotify_event event = {}; // about a file, not a folder: it has no name
    while (::read(m_watch, &event, sizeof event) == sizeof event) {
        m_clients = std::max(0, m_clients + ((event.mask & IN_OPEN) != 0 ? 1 : -1));
        left = left || m_clients == 0;
    }
    return left;
}

void PseudoTerminal::dropUnfetched()
{
    ::tcflush(m_theirs, TCIFLUSH);
}

QByteArray PseudoTerminal::read()
{
    std::array<char, 1'024> bytes{};
    const auto count = ::read(m_ours, bytes.data(), bytes.size());
    return count > 0 ? QByteArray(bytes.data(), count) : QByteArray();
}

qsizetype PseudoTerminal::write(const QByteArray &bytes)
{
    const auto count = ::write(m_ours, bytes.constData(), static_cast<std::size_t>(bytes.size()));
    return std::max(qsizetype{count}, qsizetype{0});
}

Complaint noPseudoTerminal()
{
    return complaintAbout(
        {RefusalKind::link,
         RefusalId::linkFailed,
         {CommandLine::tr("This computer gives no pseudo terminal. Close programs that use some.")}});
}

} // namespace codewheel
