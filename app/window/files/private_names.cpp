// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/private_names.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSysInfo>

namespace codewheel {
namespace {

QString wholeWord(const QString &name)
{
    return QStringLiteral("(?<![\\w-])%1(?![\\w-])").arg(QRegularExpression::escape(name));
}

} // namespace

PrivateNames PrivateNames::ofThisComputer()
{
    const QString user = QFileInfo(QDir::homePath()).owner();
    const QString host = QSysInfo::machineHostName();
    return {QDir::homePath(), user, host == QStringLiteral("localhost") ? QString() : host};
}

// A name that is also a word, such as "root" or "crane", stays if it is within a sentence.
QString withoutPrivateNames(QString text, const PrivateNames &names)
{
    if (names.home.size() > 1)
        text.replace(
            QRegularExpression(QRegularExpression::escape(names.home) + QStringLiteral("(?![\\w-])")),
            QStringLiteral("~"));
    if (!names.user.isEmpty())
        text.replace(QRegularExpression(QStringLiteral("(?<=/)%1(?=/|$|[\\s\"',;:)]|\\.(\\s|$))")
                                            .arg(QRegularExpression::escape(names.user))),
                     QStringLiteral("user"));
    if (!names.host.isEmpty())
        text.replace(QRegularExpression(wholeWord(names.host)), QStringLiteral("computer"));
    return text;
}

} // namespace codewheel
