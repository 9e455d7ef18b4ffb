// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/nmt_texts.h"

#include "kinds/canopen/protocol/canopen_address.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// The translation context of these texts.
struct NmtText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::NmtAction)
};

constexpr auto nmtActionRows = std::to_array<NmtAction>({
    {canopen::NmtCommand::start, "nmtStart", QT_TRANSLATE_NOOP("codewheel::NmtAction", "Start"),
     QT_TRANSLATE_NOOP("codewheel::NmtAction",
                       "Sends the chosen node to operational: it sends its PDOs then"),
     QT_TRANSLATE_NOOP("codewheel::NmtAction", "Start node %1? It sends its PDOs then.")},
    {canopen::NmtCommand::stop, "nmtStop", QT_TRANSLATE_NOOP("codewheel::NmtAction", "Stop"),
     QT_TRANSLATE_NOOP("codewheel::NmtAction",
                       "Stops the chosen node: it answers nothing until it is started again"),
     QT_TRANSLATE_NOOP("codewheel::NmtAction",
                       "Stop node %1? It sends no position and answers nothing until it is started again.")},
    {canopen::NmtCommand::preOperational, "nmtPreOperational",
     QT_TRANSLATE_NOOP("codewheel::NmtAction", "Pre-operational"),
     QT_TRANSLATE_NOOP(
         "codewheel::NmtAction",
         "Sends the chosen node to pre-operational: it sends no PDOs, and takes what a running one does not"),
     QT_TRANSLATE_NOOP("codewheel::NmtAction",
                       "Set node %1 to pre-operational? It sends no PDOs until it is started again.")},
    {canopen::NmtCommand::resetNode, "nmtReset", QT_TRANSLATE_NOOP("codewheel::NmtAction", "Reset"),
     QT_TRANSLATE_NOOP("codewheel::NmtAction",
                       "Resets the chosen node: it begins anew with what it has stored"),
     QT_TRANSLATE_NOOP("codewheel::NmtAction",
                       "Reset node %1? What is not stored is lost, and it has to be started again.")},
});

} // namespace

QString NmtAction::label() const
{
    return NmtText::tr(itsLabel);
}

QString NmtAction::toolTip() const
{
    return NmtText::tr(itsToolTip);
}

QString NmtAction::question(int node) const
{
    return sentence(NmtText::tr(itsQuestion), {CanopenAddress{node}.shown()});
}

std::span<const NmtAction> nmtActions()
{
    return nmtActionRows;
}

const NmtAction &nmtAction(canopen::NmtCommand command)
{
    return *std::ranges::find(nmtActionRows, command, &NmtAction::command);
}

} // namespace codewheel
