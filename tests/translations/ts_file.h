// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QStringList>

#include <vector>

class QIODevice;

namespace codewheel {

// One text of a .ts file. A text with a number (%n) has one translation for each form of the number.
struct TsText
{
    QString context;
    QString source;
    QString comment; // distinguishes texts that read the same in English
    bool hasNumber = false;
    bool isFinished = true;
    QStringList translations;

    // "codewheel::CodeDisc: turn", its name in a failing test
    QString name() const;
};

// In file order. A file that is missing or not well-formed fails the test that reads it.
std::vector<TsText> readTs(QIODevice &device);
std::vector<TsText> readTs(const QString &path);

QSet<QString> namesOf(const std::vector<TsText> &texts);

} // namespace codewheel
