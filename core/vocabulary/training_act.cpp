// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/training_act.h"

#include "vocabulary/sentence.h"
#include "vocabulary/texts_of_kinds.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr char trainingContext[] = "codewheel::TrainingAct";
constexpr std::array actsOfEveryBus{
    TrainingActRow{"startedAfresh", QT_TRANSLATE_NOOP("codewheel::TrainingAct",
                                                      "Started afresh: everything simulated is as at the "
                                                      "start, with factory values and without faults.")},
};

QString partOfAct(const RefusalArgument &argument, int decimals)
{
    if (const auto *number = std::get_if<double>(&argument))
        return QLocale().toString(*number, 'f', decimals);
    return argumentText(argument);
}

} // namespace

std::optional<QString> sentenceOf(const TrainingAct &act, std::span<const TrainingActRow> rows,
                                  const char *context)
{
    const auto row = std::ranges::find_if(
        rows, [&](const TrainingActRow &one) { return keyOf(act) == QLatin1String(one.key); });
    if (row == rows.end())
        return std::nullopt;
    QStringList parts;
    for (const RefusalArgument &argument : std::span(act).subspan(1))
        parts << partOfAct(argument, row->decimals);
    return sentence(QCoreApplication::translate(context, row->text), parts);
}

QString keyOf(const TrainingAct &act)
{
    const auto *key = act.empty() ? nullptr : std::get_if<QString>(&act.front());
    return key != nullptr ? *key : QString();
}

TrainingAct startedAfresh()
{
    return {QString::fromLatin1(actsOfEveryBus.front().key)};
}

QString trainingActText(const TrainingAct &act)
{
    if (const auto text = sentenceOf(act, actsOfEveryBus, trainingContext))
        return *text;
    return textOfTrainingAct(act).value_or(argumentTexts(act).join(QStringLiteral(", ")));
}

} // namespace codewheel
