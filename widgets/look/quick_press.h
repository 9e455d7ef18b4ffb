// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QElapsedTimer>

namespace codewheel {

// The second of two quick presses is meant for what the first one has led away from, not for the button that
// has just come in its place.
class QuickPress
{
public:
    void begin() { m_since.start(); } // something else is there now
    // Whether a press now is the second.
    bool isSecond() const
    {
        return m_since.isValid() && m_since.elapsed() < QApplication::doubleClickInterval();
    }

private:
    QElapsedTimer m_since;
};

} // namespace codewheel
