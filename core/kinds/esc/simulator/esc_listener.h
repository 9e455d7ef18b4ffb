// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <optional>

namespace codewheel {

// How a simulated ESC encoder hears: finds <ESC> text <CR><LF> in what passes on the line. It ignores
// whatever comes before an ESC, and an ESC starts anew.
class EscListener
{
public:
    // The text of the request that this byte completes: "03GP00005200".
    std::optional<QByteArray> hear(char byte);
    // A byte it cannot read: wrong baud rate or collision.
    void hearJunk() { m_isListening = false; }

private:
    static constexpr qsizetype longest = 16; // no request is longer

    QByteArray m_text;
    bool m_isListening = false;
};

} // namespace codewheel
