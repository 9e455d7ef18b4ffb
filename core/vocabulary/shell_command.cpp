// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/shell_command.h"

#include "vocabulary/sentence.h"

#include <QRegularExpression>

#include <algorithm>

namespace codewheel {
namespace {

QString shellWord(const QString &part)
{
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_./:@%+=,][A-Za-z0-9_./:@%+=,-]*$"));
    if (plain.match(part).hasMatch())
        return part;
    QString quoted = part;
    quoted.replace(QStringLiteral("'"), QStringLiteral("'\\''"));
    return u'\'' + quoted + u'\'';
}

// Nor taken for an option.
bool isShown(const QString &part)
{
    return !part.startsWith(u'-') && std::ranges::all_of(part, [](QChar one) { return one.isPrint(); });
}

} // namespace

QString shellCommand(const QString &pattern, const QStringList &parts)
{
    QStringList words;
    for (const QString &part : parts)
        words << shellWord(part);
    return std::ranges::all_of(parts, isShown) ? sentence(pattern, words) : QString();
}

} // namespace codewheel
