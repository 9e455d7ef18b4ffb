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

struct CanStateRow
{
    CanState id;
    const char *key;
    const char *text;
};

constexpr std::array canStateRows{
    CanStateRow{CanState::active, "active", QT_TRANSLATE_NOOP("codewheel::CanState", "no errors")},
    CanStateRow{CanState::warning, "warning", QT_TRANSLATE_NOOP("codewheel::CanState", "many errors")},
    CanStateRow{CanState::passive, "passive", QT_TRANSLATE_NOOP("codewheel::CanState", "error passive")},
    CanStateRow{CanState::busOff, "busOff", QT_TRANSLATE_NOOP("codewheel::CanState", "bus off")},
    CanStateRow{CanState::notKnown, "notKnown", QT_TRANSLATE_NOOP("codewheel::CanState", "not known")},
};
static_assert(areInOrder(canStateRows, &CanStateRow::id, CanState::notKnown));

const CanStateRow &rowOf(CanState state)
{
    return canStateRows.at(static_cast<std::size_t>(state));
}

} // namespace

QString canStateKey(CanState state)
{
    return QString::fromLatin1(rowOf(state).key);
}

QString canStateText(CanState state)
{
    return CanStateNames::tr(rowOf(state).text);
}

QString inKilobits(int rate)
{
    constexpr double kilo = 1'000;
    return QLocale().toString(rate / kilo);
}

} // namespace codewheel
