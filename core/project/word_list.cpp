// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/word_list.h"

#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace codewheel {

namespace {

QString cellOf(const QString &line)
{
    for (QString cell : line.split(QLatin1Char('\t'))) {
        cell = cell.trimmed();
        if (cell.size() >= 2 && cell.startsWith(QLatin1Char('"')) && cell.endsWith(QLatin1Char('"')))
            cell = cell.sliced(1, cell.size() - 2).trimmed();
        if (!cell.isEmpty())
            return cell;
    }
    return {};
}

} // namespace

Parsed<std::vector<Word>> parseColumn(const QString &text)
{
    static const QRegularExpression lineEnd(QStringLiteral("\r\n|\n|\r"));
    const QStringList lines = text.split(lineEnd);
    std::vector<Word> words;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString cell = cellOf(lines.at(i));
        if (cell.isEmpty())
            continue;
        const std::optional<Word> word = parseHexWord(cell);
        if (!word)
            return tl::unexpected(
                QCoreApplication::translate("Sequence",
                                            "Nothing was pasted: line %1, \"%2\", is not a hexadecimal word. "
                                            "Each line takes up to 8 digits of 0 to 9 and A to F.")
                    .arg(QString::number(i + 1), cell.left(40)));
        words.push_back(*word);
    }
    if (words.empty())
        return tl::unexpected(QCoreApplication::translate(
            "Sequence", "There is no word to paste. Copy a column of hexadecimal words first."));
    if (words.size() > WordList::mostWords)
        return tl::unexpected(
            QCoreApplication::translate("Sequence", "Nothing was pasted: a sequence has at most %1 words.")
                .arg(numberText(std::int64_t{WordList::mostWords})));
    return words;
}

} // namespace codewheel
