// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/device_error_name.h"
#include "encoder/enumeration_rows.h"
#include "encoder/refusal_text.h"
#include "encoder/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

// %1, %2, ... are the arguments in the order told in encoder/message.h.
struct Row
{
    MessageId id;
    const char *key;
    const char *text;
};

constexpr std::array rows{
    Row{MessageId::refused, "refused", QT_TRANSLATE_NOOP("Message", "Refused.")},
    Row{MessageId::busStarted, "busStarted", QT_TRANSLATE_NOOP("Message", "The bus runs.")},
    Row{MessageId::busStopped, "busStopped", QT_TRANSLATE_NOOP("Message", "The bus is stopped.")},
    Row{MessageId::alarmStop, "alarmStop",
        QT_TRANSLATE_NOOP("Message", "ALARM STOP: all OUT words of the ring were set to 0.")},
    Row{MessageId::operateOn, "operateOn", QT_TRANSLATE_NOOP("Message", "Operate: writing is allowed.")},
    Row{MessageId::watchOn, "watchOn", QT_TRANSLATE_NOOP("Message", "Watch: nothing is sent any more.")},
    Row{MessageId::wordWritten, "wordWritten", QT_TRANSLATE_NOOP("Message", "OUT %1 written.")},
    Row{MessageId::parametersWritten, "parametersWritten",
        QT_TRANSLATE_NOOP("Message", "Written and activated: %3 (parameters: %1, EEPROM writes: %2).")},
    Row{MessageId::parametersRead, "parametersRead", QT_TRANSLATE_NOOP("Message", "Values read: %1.")},
    Row{MessageId::presetDone, "presetDone",
        QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 before, %2 after.")},
    Row{MessageId::wordsSent, "wordsSent", QT_TRANSLATE_NOOP("Message", "Words sent: %1.")},
    Row{MessageId::broughtBack, "broughtBack",
        QT_TRANSLATE_NOOP("Message", "The encoder is in operation again.")},
    Row{MessageId::leftInParameterization, "leftInParameterization",
        QT_TRANSLATE_NOOP("Message", "The encoder was left in parameterization. Send run to bring it back to "
                                     "operation.")},
    Row{MessageId::leftInService, "leftInService",
        QT_TRANSLATE_NOOP("Message", "The encoder was left in service mode: it shows no position. Set OUT to "
                                     "0 to bring it back to normal mode.")},
    Row{MessageId::onlyZeroSinceRun, "onlyZeroSinceRun",
        QT_TRANSLATE_NOOP("Message",
                          "IN has been 00000000 since run: position 0, or an encoder without power. "
                          "Turn the shaft to be sure.")},
    Row{MessageId::deviceFault, "deviceFault",
        QT_TRANSLATE_NOOP("Message", "The encoder reports error %1 (IN %2).")},
    Row{MessageId::deviceFaultGone, "deviceFaultGone",
        QT_TRANSLATE_NOOP("Message", "The encoder reports no error any more.")},
    Row{MessageId::valuesForgotten, "valuesForgotten",
        QT_TRANSLATE_NOOP("Message", "What was known of the encoder may not hold any more: read it again.")},
    Row{MessageId::lateCycles, "lateCycles", QT_TRANSLATE_NOOP("Message", "Bus cycles that came late: %1.")},
    Row{MessageId::modeSwitched, "modeSwitched",
        QT_TRANSLATE_NOOP("Message", "The encoder was switched: %1.")},
    Row{MessageId::resetWaitsForRun, "resetWaitsForRun",
        QT_TRANSLATE_NOOP("Message",
                          "The reset to factory settings waits for run. Run carries it out; switching the "
                          "encoder off drops it.")},
    Row{MessageId::resetDone, "resetDone",
        QT_TRANSLATE_NOOP("Message", "The encoder was reset to factory settings (EEPROM writes: %1).")},
    Row{MessageId::camsRead, "camsRead", QT_TRANSLATE_NOOP("Message", "Cam programs read: %1.")},
    Row{MessageId::camsWritten, "camsWritten",
        QT_TRANSLATE_NOOP("Message", "Cam programs written: %1 (EEPROM writes so far: %2).")},
    Row{MessageId::deviceNamed, "deviceNamed",
        QT_TRANSLATE_NOOP("Message",
                          "This encoder is now taken for: %1. What was known of it is forgotten.")},
    Row{MessageId::training, "training", "%1"},
};

static_assert(areInOrder(rows, &Row::id) && rows.size() == messageCount);

const Row &rowOf(MessageId id)
{
    return rows.at(static_cast<std::size_t>(id));
}

QString pattern(const char *text)
{
    return QCoreApplication::translate("Message", text);
}

// Either position may be missing.
QString presetText(const QStringList &parts)
{
    const QString before = parts.value(0);
    const QString after = parts.value(1);
    if (before.isEmpty() && after.isEmpty())
        return pattern(QT_TRANSLATE_NOOP("Message", "Preset initialised."));
    if (before.isEmpty())
        return sentence(pattern(QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 after.")),
                        {after});
    if (after.isEmpty())
        return sentence(pattern(QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 before.")),
                        {before});
    return sentence(pattern(rowOf(MessageId::presetDone).text), {before, after});
}

} // namespace

QString messageText(const Message &message)
{
    if (message.id == MessageId::refused && message.refusal)
        return refusalText(*message.refusal);
    const QStringList parts = argumentTexts(message.arguments);
    if (message.id == MessageId::presetDone)
        return presetText(parts);
    if (message.id == MessageId::deviceFault && message.refusal)
        return sentence(pattern(QT_TRANSLATE_NOOP("Message", "The encoder reports error %1, %3 (IN %2).")),
                        parts + QStringList{deviceErrorName(message.refusal->id)});
    return sentence(pattern(rowOf(message.id).text), parts);
}

QString messageKey(MessageId id)
{
    return QString::fromLatin1(rowOf(id).key);
}

} // namespace codewheel
