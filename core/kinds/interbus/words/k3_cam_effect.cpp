// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_effect.h"

#include "kinds/interbus/words/k3_cam_word.h"
#include "kinds/interbus/words/k3_word.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel::k3 {
namespace {

QString translated(const char *text)
{
    return QCoreApplication::translate("Refusal", text);
}

// "sets the start of cam 0 to 0"
QString camModeEffect(Word word)
{
    const QString cam = argumentText(std::int64_t{k3::number(word)});
    const QString position = argumentText(std::int64_t{k3::data(word)});
    if (k3::isCamStart(word))
        return sentence(translated(QT_TRANSLATE_NOOP("Refusal", "sets the start of cam %1 to %2")),
                        {cam, position});
    if (k3::isCamStop(word))
        return sentence(translated(QT_TRANSLATE_NOOP("Refusal", "sets the stop of cam %1 to %2")),
                        {cam, position});
    if (k3::isCamShift(word))
        return sentence(translated(QT_TRANSLATE_NOOP("Refusal", "sets the shift to %1")),
                        {argumentText(std::int64_t{word & 0xFF})});
    if (k3::isProgramWord(word))
        return sentence(translated(QT_TRANSLATE_NOOP("Refusal", "switches to cam program %1")),
                        {argumentText(std::int64_t{word & 0xF})});
    if (k3::isCamConfiguration(word))
        return translated(QT_TRANSLATE_NOOP("Refusal", "changes which cams are active"));
    return translated(QT_TRANSLATE_NOOP("Refusal", "is a wrong command"));
}

} // namespace

QStringList camWordTexts(const std::vector<RefusalArgument> &arguments)
{
    QStringList parts = argumentTexts(arguments);
    const auto *word = arguments.empty() ? nullptr : std::get_if<Word>(&arguments.front());
    parts.resize(std::max<qsizetype>(parts.size(), 1));
    parts.insert(1, camModeEffect(word != nullptr ? *word : initialisePreset));
    return parts;
}

} // namespace codewheel::k3
