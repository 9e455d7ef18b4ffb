// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recording/log_source.h"

#include "cli/call/texts.h"

#include <QFile>
#include <QFileInfo>

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace codewheel {

// Non-blocking, or a pipe without a writer would be waited for before Ctrl+C is heard.
LogSource::LogSource(const QString &path)
    : m_path(path)
    , m_bytes(most)
{
    m_error = QFileInfo(path).isDir() ? EISDIR : 0;
    if (m_error != 0)
        return;
    m_descriptor =
        ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC); // NOLINT(*-vararg)
    m_error = m_descriptor < 0 ? errno : 0;
}

LogSource::~LogSource()
{
    if (isOpen())
        ::close(m_descriptor);
}

QString LogSource::error() const
{
    return m_error == EISDIR ? CommandLine::tr("It is a folder.") : qt_error_string(m_error);
}

LogSource::State LogSource::read()
{
    m_size = 0;
    const State state = look(0);
    if (state != State::hasMore)
        return state;
    const ssize_t size = ::read(m_descriptor, m_bytes.data(), m_bytes.size());
    if (size < 0) {
        m_error = errno;
        return m_error == EAGAIN || m_error == EINTR ? State::isEmpty : State::failed;
    }
    m_size = static_cast<std::size_t>(size);
    return size == 0 ? State::isAtEnd : State::hasMore;
}

LogSource::State LogSource::wait()
{
    constexpr int forEver = -1;
    return look(forEver);
}

LogSource::State LogSource::look(int timeOut)
{
    std::array<pollfd, 2> waited{pollfd{m_descriptor, POLLIN, 0}, pollfd{m_stop.descriptor(), POLLIN, 0}};
    ::poll(waited.data(), waited.size(), timeOut);
    if (waited[1].revents != 0 && m_stop.came())
        return State::wasStopped;
    return waited[0].revents != 0 ? State::hasMore : State::isEmpty;
}

} // namespace codewheel
