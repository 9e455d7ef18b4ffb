// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/esc_listener.h"

namespace codewheel {

std::optional<QByteArray> EscListener::hear(char byte)
{
    constexpr char escape = '\x1B';
    if (byte == escape) {
        m_isListening = true;
        m_text.clear();
        return std::nullopt;
    }
    if (!m_isListening)
        return std::nullopt;
    m_text += byte;
    if (m_text.endsWith("\r\n")) {
        m_isListening = false;
        return m_text.chopped(2);
    }
    m_isListening = m_text.size() <= longest;
    return std::nullopt;
}

} // namespace codewheel
