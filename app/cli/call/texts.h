// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QStringList>

#include <functional>

namespace codewheel {

// The translation context of what the command line says: CommandLine::tr("..."). Tables of constant texts
// mark theirs with QT_TRANSLATE_NOOP("codewheel::CommandLine", "...").
struct CommandLine
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CommandLine)
};

// "1.0, 2.0": what `text` makes of each.
template <typename Range, typename Text>
QString listed(const Range &range, Text text)
{
    QStringList texts;
    for (const auto &one : range)
        texts << std::invoke(text, one);
    return texts.join(QStringLiteral(", "));
}

} // namespace codewheel
