// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

struct CanRefusalRows
{
    Q_DECLARE_TR_FUNCTIONS(Refusal)

public:
    static constexpr auto all = std::to_array<SentenceRow>({
        {CanRefusalId::linkNotUnderstood, "canLinkNotUnderstood",
         QT_TR_NOOP("\"%1\" is no link to a CAN bus. Write can:can0 for an interface of the system, or "
                    "slcan:ttyACM0,rate=250000 for a serial adapter.")},
        {CanRefusalId::settingUnknown, "canSettingUnknown",
         QT_TR_NOOP("A serial CAN adapter has no setting \"%1\". It has the rate of the bus and that of its "
                    "port, as slcan:ttyACM0,rate=250000,baud=115200.")},
        {CanRefusalId::baudRateWrong, "canBaudRateWrong",
         QT_TR_NOOP("\"%1\" is not a rate of a serial port. Give it in Bd, as baud=115200.")},
        {CanRefusalId::rateWrong, "canRateWrong",
         QT_TR_NOOP("\"%1\" is not a rate that serial CAN adapters have. Give one of these, in Bd: %2.")},
        {CanRefusalId::rateMissing, "canRateMissing",
         QT_TR_NOOP(
             "The link \"%1\" does not say at which rate its bus runs. Add it in Bd, as rate=250000.")},
        {CanRefusalId::rateBySystem, "canRateBySystem",
         QT_TR_NOOP("The rate of %1 is set in the system, not here. Leave it out; \"ip link\" sets it.")},
        {CanRefusalId::logEmpty, "canLogEmpty",
         QT_TR_NOOP("There is no CAN frame in %1. See with codewheel-cli frames what is in it.")},
        {CanRefusalId::logHasNoTimes, "canLogHasNoTimes",
         QT_TR_NOOP("The frames in %1 have no times, so it is not known when they came. codewheel-cli frames "
                    "lists them.")},
        {CanRefusalId::logHasNotThat, "canLogHasNotThat",
         QT_TR_NOOP("There is no frame of %2 in %1. Name another interface, or leave it out for that of the "
                    "first frame.")},
        {CanRefusalId::watchNotSure, "canWatchNotSure",
         QT_TR_NOOP("%1 is not set to listen only, so it acknowledges what others send. Set it so with "
                    "\"%2\", or agree that it acknowledges. Nothing was opened."),
         QT_TR_NOOP("The adapter at %1 is not known to be able to listen only, so it may acknowledge what "
                    "others send. Agree to that, or use another adapter. Nothing was opened.")},
        {CanRefusalId::rateRefused, "canRateRefused",
         QT_TR_NOOP("The adapter at %1 did not take the rate %2 Bd, so the bus was not opened. Choose "
                    "another rate, or plug the adapter in again.")},
        {CanRefusalId::openingRefused, "canOpeningRefused",
         QT_TR_NOOP("The adapter at %1 refused to open the bus. Plug it in again, then open it again.")},
        {CanRefusalId::adapterSilent, "canAdapterSilent",
         QT_TR_NOOP("Nothing at %1 answers as a serial CAN adapter. Check that it is the right port, that "
                    "its adapter speaks SLCAN, and the rate of the port.")},
        {CanRefusalId::openingNotKnown, "canOpeningNotKnown",
         QT_TR_NOOP("The adapter at %1 did not answer when it was to open the bus: it is not known whether "
                    "it has. Unplug it to be sure that it has not, then try again.")},
        {CanRefusalId::rateMayBe750, "canRateMayBe750",
         QT_TR_NOOP("The adapter at %1 is asked for 800 kBd, but adapters of this kind may run at 750 kBd "
                    "then. If only errors come in, use another adapter.")},
        {CanRefusalId::onlyWatches, "canOnlyWatches",
         QT_TR_NOOP("%1 was opened to watch: nothing is sent. Switch to Operate first.")},
        {CanRefusalId::busOff, "canBusOff",
         QT_TR_NOOP("%1 has left the bus after too many errors (bus off): the rate or the wiring is wrong, "
                    "or nobody else is there. Check these, then start it again: %2"),
         QT_TR_NOOP("%1 has left the bus after too many errors (bus off): the rate or the wiring is wrong, "
                    "or nobody else is there. Check these, then open it again.")},
        {CanRefusalId::interfaceMissing, "canInterfaceMissing",
         QT_TR_NOOP("There is no CAN interface %1. Plug its adapter in, and see with \"ip link\" which "
                    "interfaces there are.")},
        {CanRefusalId::interfaceDown, "canInterfaceDown",
         QT_TR_NOOP("The CAN interface %1 is switched off. Switch it on with the rate of the bus: %2")},
        {CanRefusalId::interfaceLost, "canInterfaceLost",
         QT_TR_NOOP("The CAN interface %1 has gone: its adapter was unplugged, or the interface switched "
                    "off. Bring it back, then connect again.")},
        {CanRefusalId::notInKernel, "canNotInKernel",
         QT_TR_NOOP("%1 cannot be opened: this system has no CAN. Load it with \"sudo modprobe can_raw\", or "
                    "use a serial adapter.")},
        {CanRefusalId::pluginMissing, "canPluginMissing",
         QT_TR_NOOP("Qt's plugin for CAN interfaces is missing. Install the package libqt6serialbus6.")},
        {CanRefusalId::onlyLogged, "canOnlyLogged",
         QT_TR_NOOP("%1 is a log: what is in it is over, and nobody can be asked or told anything there.")},
    });
};

static_assert(areInOrder(CanRefusalRows::all, &SentenceRow::id, CanRefusalId::onlyLogged));

QString canRefusalText(const Refusal &refusal)
{
    const SentenceRow &row = refusal.id.row();
    const bool isBare = row.textWithoutArguments != nullptr && refusal.arguments.size() < 2;
    return sentence(refusalPattern(isBare ? row.textWithoutArguments : row.text),
                    argumentTexts(refusal.arguments));
}

} // namespace

constinit const RefusalFamily canRefusals{CanRefusalRows::all, canRefusalText};

} // namespace codewheel
