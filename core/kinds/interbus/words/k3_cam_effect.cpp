// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_effect.h"

#include "kinds/interbus/words/k3_cam_word.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel::k3 {
namespace {

QString translated(const char *text)
{
    return QCoreApplication::translate("Refusal", text);
}

} // namespace

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

} // namespace codewheel::k3
