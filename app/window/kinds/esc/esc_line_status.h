// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

class EscLineSession;
class RoleLabel;
class StatusLine;

// What the status line shows of a serial line: port, baud rate, and who answers. Used by EscLineViews.
class EscLineStatus
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineStatus)
    Q_DISABLE_COPY_MOVE(EscLineStatus)

public:
    explicit EscLineStatus(StatusLine &line);
    ~EscLineStatus();

    void show(const EscLineSession *line); // null, or not open: nothing

private:
    RoleLabel *m_label;
};

} // namespace codewheel
