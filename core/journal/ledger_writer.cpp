// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger_writer.h"

#include <QSysInfo>

namespace codewheel {
namespace {

QString &userOfLedger()
{
    static QString name;
    return name;
}

} // namespace

LedgerWriter ledgerWriter()
{
    return {.computer = QSysInfo::machineHostName(), .user = userOfLedger()};
}

void setLedgerUser(const QString &name)
{
    userOfLedger() = name.simplified().left(longestUserName);
}

} // namespace codewheel
