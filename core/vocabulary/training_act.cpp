// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/training_act.h"

#include "vocabulary/sentence.h"
#include "vocabulary/texts_of_kinds.h"

#include <QLocale>

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
    const TrainingActRow *row = rowByKey(rows, keyOf(act));
    if (row == nullptr)
        return std::nullopt;
    QStringList parts;
    for (const RefusalArgument &argument : std::span(act).subspan(1))
        parts << partOfAct(argument, row->decimals);
    return sentence(QCoreApplication::translate(context, row->text), parts);
}

TrainingAct actOf(std::span<const TrainingActRow> rows, std::size_t row,
                  const std::vector<RefusalArgument> &its)
{
    TrainingAct act{QString::fromLatin1(rows[row].key)};
    act.insert(act.end(), its.begin(), its.end());
    return act;
}

TrainingAct conditionAct(const QString &act, const char *condition, bool isSo)
{
    return {act, QString::fromLatin1(condition), std::int64_t{isSo ? 1 : 0}};
}

QString conditionText(const TrainingAct &act, const QString &name)
{
    const bool isSo = act.back() == RefusalArgument(std::int64_t{1});
    const char *text = isSo ? QT_TRANSLATE_NOOP("codewheel::TrainingAct", "%1: yes.")
                            : QT_TRANSLATE_NOOP("codewheel::TrainingAct", "%1: no.");
    return sentence(QCoreApplication::translate(trainingContext, text), {name});
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
