// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

class LineSession;
class RoleLabel;
class StatusLine;

// What the status line shows of a serial line: port, baud rate, and who answers. Used by LineViews.
class LineStatus
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::LineStatus)
    Q_DISABLE_COPY_MOVE(LineStatus)

public:
    explicit LineStatus(StatusLine &line);
    ~LineStatus();

    void show(const LineSession *line); // null, or not open: nothing

private:
    RoleLabel *m_label;
};

} // namespace codewheel
