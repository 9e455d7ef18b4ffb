// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/typed_lines.h"

#include <array>
#include <istream>
#include <poll.h>
#include <string>
#include <unistd.h>

namespace codewheel {

std::optional<QString> TypedLines::next(const std::function<bool()> &meanwhile)
{
    if (isStopped())
        return std::nullopt;
    if (m_terminal.inputDescriptor < 0)
        return fromStream();
    while (true) {
        const qsizetype end = m_read.indexOf('\n');
        if (end >= 0 || (m_isEnded && !m_read.isEmpty())) {
            const QByteArray line = end < 0 ? m_read : m_read.first(end);
            m_read.remove(0, line.size() + 1);
            return QString::fromLocal8Bit(line);
        }
        if (m_isEnded)
            return std::nullopt;
        const Input input = wait(!meanwhile);
        if (input == Input::ended)
            return std::nullopt;
        if (input == Input::none && meanwhile && !meanwhile())
            return std::nullopt;
    }
}

TypedLines::Input TypedLines::wait(bool isQuiet)
{
    constexpr int forever = -1;
    std::array<pollfd, 2> waited{{{m_terminal.inputDescriptor, POLLIN, 0}, {m_stop.descriptor(), POLLIN, 0}}};
    ::poll(waited.data(), waited.size(), isQuiet ? forever : 0);
    if (isStopped())
        return Input::ended;
    return waited[0].revents != 0 ? take() : Input::none;
}

TypedLines::Input TypedLines::take()
{
    std::array<char, 1'024> bytes{};
    const auto count = ::read(m_terminal.inputDescriptor, bytes.data(), bytes.size());
    if (count > 0)
        m_read.append(bytes.data(), count);
    m_isEnded = count <= 0;
    return Input::some;
}

std::optional<QString> TypedLines::fromStream()
{
    std::string line;
    if (!std::getline(m_terminal.in, line))
        return std::nullopt;
    return QString::fromStdString(line);
}

} // namespace codewheel
