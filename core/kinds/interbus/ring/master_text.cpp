// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/master_text.h"

#include "vocabulary/enumeration_rows.h"

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

constexpr auto serviceRows = std::to_array<TextOf<MasterService>>({
    {MasterService::readConfiguration, QT_TRANSLATE_NOOP("Master", "reading the configuration (030B)")},
    {MasterService::startDataTransfer, QT_TRANSLATE_NOOP("Master", "starting data transfer (0701)")},
    {MasterService::stopDataTransfer, QT_TRANSLATE_NOOP("Master", "stopping data transfer (0702)")},
    {MasterService::createConfiguration, QT_TRANSLATE_NOOP("Master", "reading in the ring (0710)")},
    {MasterService::activateConfiguration,
     QT_TRANSLATE_NOOP("Master", "activating the configuration (0711)")},
    {MasterService::deactivateConfiguration,
     QT_TRANSLATE_NOOP("Master", "deactivating the configuration (0712)")},
    {MasterService::switchSegment, QT_TRANSLATE_NOOP("Master", "switching a segment (0713)")},
    {MasterService::confirmDiagnostics, QT_TRANSLATE_NOOP("Master", "confirming the diagnostics (0760)")},
    {MasterService::alarmStop, QT_TRANSLATE_NOOP("Master", "alarm stop (1303)")},
});

// In the order of MasterState.
constexpr std::array stateTexts{QT_TRANSLATE_NOOP("Master", "READY"), QT_TRANSLATE_NOOP("Master", "ACTIVE"),
                                QT_TRANSLATE_NOOP("Master", "RUN"), QT_TRANSLATE_NOOP("Master", "BUS FAIL")};

QString masterWord(const char *text)
{
    return QCoreApplication::translate("Master", text);
}

} // namespace

QString masterStateName(MasterState state)
{
    return masterWord(rowOf(stateTexts, state));
}

QString masterServiceName(MasterService service)
{
    return masterWord(
        textFor(serviceRows, service, QT_TRANSLATE_NOOP("Master", "downloading the configuration")));
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
