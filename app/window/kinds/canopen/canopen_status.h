// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

class CanopenSession;
class RoleLabel;
class StatusLine;

// What the status line shows of a CAN bus: interface, rate, load, and who is heard. Used by CanopenViews.
class CanopenStatus
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenStatus)
    Q_DISABLE_COPY_MOVE(CanopenStatus)

public:
    explicit CanopenStatus(StatusLine &line);
    ~CanopenStatus();

    void show(const CanopenSession *bus); // null, or not open: nothing

private:
    RoleLabel *m_label;
};

} // namespace codewheel
