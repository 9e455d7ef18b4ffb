// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/master_text.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

struct BitRow
{
    const char *name;
    const char *text;
};
constexpr std::array<BitRow, diagnosticBits> bits{{
    {"USER", QT_TRANSLATE_NOOP("Master", "A user error: a service was called wrongly.")},
    {"PF", QT_TRANSLATE_NOOP("Master", "A device reports a peripheral fault, until it is confirmed.")},
    {"BUS", QT_TRANSLATE_NOOP("Master", "The bus has failed: no data cycles run.")},
    {"CTRL", QT_TRANSLATE_NOOP("Master", "The master itself is faulty.")},
    {"DETECT", QT_TRANSLATE_NOOP("Master", "The master is looking for the place of a fault.")},
    {"RUN", QT_TRANSLATE_NOOP("Master", "Data cycles run.")},
    {"ACTIVE", QT_TRANSLATE_NOOP("Master", "A configuration is active.")},
    {"READY", QT_TRANSLATE_NOOP("Master", "The master is ready for services.")},
    {"BSA", QT_TRANSLATE_NOOP("Master", "A segment is switched off.")},
    {"SYSFAIL", QT_TRANSLATE_NOOP("Master", "The controller above the master has failed.")},
    {"RESULT", QT_TRANSLATE_NOOP("Master", "A service ended with a negative result.")},
    {"SY-RESULT", QT_TRANSLATE_NOOP("Master", "Synchronizing ended with a negative result.")},
    {"DC-RESULT", QT_TRANSLATE_NOOP("Master", "A data cycle was faulty.")},
    {"WARNING", QT_TRANSLATE_NOOP("Master", "A time that was waited for has passed.")},
    {"QUALITY", QT_TRANSLATE_NOOP("Master", "Too many data cycles are faulty.")},
    {"SDSI", QT_TRANSLATE_NOOP("Master", "A message waits in the master.")},
}};

QString masterWord(const char *text)
{
    return QCoreApplication::translate("Master", text);
}

} // namespace

QString masterStateName(MasterState state)
{
    switch (state) {
    case MasterState::ready:
        break;
    case MasterState::active:
        return masterWord(QT_TRANSLATE_NOOP("Master", "ACTIVE"));
    case MasterState::run:
        return masterWord(QT_TRANSLATE_NOOP("Master", "RUN"));
    case MasterState::busFail:
        return masterWord(QT_TRANSLATE_NOOP("Master", "BUS FAIL"));
    }
    return masterWord(QT_TRANSLATE_NOOP("Master", "READY"));
}

QString masterServiceName(MasterService service)
{
    switch (service) {
    case MasterService::loadConfiguration:
        break;
    case MasterService::readConfiguration:
        return masterWord(QT_TRANSLATE_NOOP("Master", "reading the configuration (030B)"));
    case MasterService::startDataTransfer:
        return masterWord(QT_TRANSLATE_NOOP("Master", "starting data transfer (0701)"));
    case MasterService::stopDataTransfer:
        return masterWord(QT_TRANSLATE_NOOP("Master", "stopping data transfer (0702)"));
    case MasterService::createConfiguration:
        return masterWord(QT_TRANSLATE_NOOP("Master", "reading in the ring (0710)"));
    case MasterService::activateConfiguration:
        return masterWord(QT_TRANSLATE_NOOP("Master", "activating the configuration (0711)"));
    case MasterService::deactivateConfiguration:
        return masterWord(QT_TRANSLATE_NOOP("Master", "deactivating the configuration (0712)"));
    case MasterService::switchSegment:
        return masterWord(QT_TRANSLATE_NOOP("Master", "switching a segment (0713)"));
    case MasterService::confirmDiagnostics:
        return masterWord(QT_TRANSLATE_NOOP("Master", "confirming the diagnostics (0760)"));
    case MasterService::alarmStop:
        return masterWord(QT_TRANSLATE_NOOP("Master", "alarm stop (1303)"));
    }
    return masterWord(QT_TRANSLATE_NOOP("Master", "downloading the configuration"));
}

QString diagnosticBitName(int bit)
{
    return QString::fromLatin1(bits.at(static_cast<std::size_t>(bit)).name);
}

QString diagnosticBitText(int bit)
{
    return masterWord(bits.at(static_cast<std::size_t>(bit)).text);
}

QString masterFaultText(const MasterStatus &status)
{
    if (status.isFaulty())
        return status.faultText();
    return masterWord(status.state == MasterState::ready
                          ? QT_TRANSLATE_NOOP("Master", "not looked for in READY")
                          : QT_TRANSLATE_NOOP("Master", "none"));
}

} // namespace codewheel
