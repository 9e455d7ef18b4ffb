// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/sentence.h"

#include "vocabulary/hex.h"
#include "vocabulary/shown_text.h"

#include <QLocale>

namespace codewheel {
namespace {

struct ArgumentText
{
    QString operator()(std::int64_t number) const { return numberText(number); }
    QString operator()(double number) const { return QLocale().toString(number, 'g', 4); }
    QString operator()(Word word) const { return hexWord(word); }
    QString operator()(Parameter parameter) const { return parameterName(parameter); }
    QString operator()(const QString &text) const { return text; }
};

bool isPlace(QStringView text)
{
    return text.size() >= 2 && text[0] == u'%' && text[1] >= u'1' && text[1] <= u'9';
}

} // namespace

QString sentence(const QString &pattern, const QStringList &parts)
{
    QString result;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        if (isPlace(QStringView(pattern).sliced(i)))
            result += shownInLine(parts.value(pattern[++i].digitValue() - 1, QStringLiteral("?")));
        else
            result += pattern[i];
    }
    return result;
}

QString numberText(std::int64_t number)
{
    return QLocale().toString(qlonglong{number});
}

QString plainText(const Value &value)
{
    return value.isText() ? shownInLine(value.toString()) : numberText(value.number());
}

QString argumentText(const RefusalArgument &argument)
{
    return std::visit(ArgumentText(), argument);
}

QStringList argumentTexts(const std::vector<RefusalArgument> &arguments)
{
    QStringList texts;
    for (const RefusalArgument &argument : arguments)
        texts << argumentText(argument);
    return texts;
}

} // namespace codewheel
