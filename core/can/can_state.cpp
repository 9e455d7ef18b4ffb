// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_state.h"

#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>

namespace codewheel {
namespace {

// The translation context of these texts.
struct CanStateNames
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanState)
};

constexpr auto canStateRows = std::to_array<KeyedText<CanState>>({
    {CanState::active, "active", QT_TRANSLATE_NOOP("codewheel::CanState", "no errors")},
    {CanState::warning, "warning", QT_TRANSLATE_NOOP("codewheel::CanState", "many errors")},
    {CanState::passive, "passive", QT_TRANSLATE_NOOP("codewheel::CanState", "error passive")},
    {CanState::busOff, "busOff", QT_TRANSLATE_NOOP("codewheel::CanState", "bus off")},
    {CanState::notKnown, "notKnown", QT_TRANSLATE_NOOP("codewheel::CanState", "not known")},
});
static_assert(areInOrder(canStateRows, &KeyedText<CanState>::id, CanState::notKnown));

} // namespace

QString canStateKey(CanState state)
{
    return QString::fromLatin1(rowOf(canStateRows, state).key);
}

QString canStateText(CanState state)
{
    return CanStateNames::tr(rowOf(canStateRows, state).text);
}

QString inKilobits(int rate)
{
    constexpr double kilo = 1'000;
    return QLocale().toString(rate / kilo);
}

} // namespace codewheel
