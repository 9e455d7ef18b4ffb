// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto canRefusalRows = std::to_array<SentenceRow>({
    {CanRefusalId::linkNotUnderstood, "canLinkNotUnderstood",
     QT_TRANSLATE_NOOP("Refusal", "\"%1\" is no link to a CAN bus. Write can:can0 for an interface of the "
                                  "system, or slcan:ttyACM0,rate=250000 for a serial adapter.")},
    {CanRefusalId::settingUnknown, "canSettingUnknown",
     QT_TRANSLATE_NOOP("Refusal", "A serial CAN adapter has no setting \"%1\". It has the rate of the bus "
                                  "and that of its port, as slcan:ttyACM0,rate=250000,baud=115200.")},
    {CanRefusalId::baudRateWrong, "canBaudRateWrong",
     QT_TRANSLATE_NOOP("Refusal", "\"%1\" is not a rate of a serial port. Give it in Bd, as baud=115200.")},
    {CanRefusalId::rateWrong, "canRateWrong",
     QT_TRANSLATE_NOOP("Refusal",
                       "\"%1\" is not a rate that serial CAN adapters have. Give one of these, in Bd: %2.")},
    {CanRefusalId::rateMissing, "canRateMissing",
     QT_TRANSLATE_NOOP(
         "Refusal",
         "The link \"%1\" does not say at which rate its bus runs. Add it in Bd, as rate=250000.")},
    {CanRefusalId::rateBySystem, "canRateBySystem",
     QT_TRANSLATE_NOOP("Refusal",
                       "The rate of %1 is set in the system, not here. Leave it out; \"ip link\" sets it.")},
    {CanRefusalId::logEmpty, "canLogEmpty",
     QT_TRANSLATE_NOOP("Refusal",
                       "There is no CAN frame in %1. See with codewheel-cli frames what is in it.")},
    {CanRefusalId::logHasNoTimes, "canLogHasNoTimes",
     QT_TRANSLATE_NOOP("Refusal", "The frames in %1 have no times, so it is not known when they came. "
                                  "codewheel-cli frames lists them.")},
    {CanRefusalId::logHasNotThat, "canLogHasNotThat",
     QT_TRANSLATE_NOOP("Refusal", "There is no frame of %2 in %1. Name another interface, or leave it out "
                                  "for that of the first frame.")},
    {CanRefusalId::watchNotSure, "canWatchNotSure",
     QT_TRANSLATE_NOOP("Refusal", "%1 is not set to listen only, so it acknowledges what others send. Set it "
                                  "so with \"%2\", or agree that it acknowledges. Nothing was opened."),
     QT_TRANSLATE_NOOP("Refusal",
                       "The adapter at %1 is not known to be able to listen only, so it may acknowledge what "
                       "others send. Agree to that, or use another adapter. Nothing was opened.")},
    {CanRefusalId::rateRefused, "canRateRefused",
     QT_TRANSLATE_NOOP("Refusal", "The adapter at %1 did not take the rate %2 Bd, so the bus was not opened. "
                                  "Choose another rate, or plug the adapter in again.")},
    {CanRefusalId::openingRefused, "canOpeningRefused",
     QT_TRANSLATE_NOOP("Refusal",
                       "The adapter at %1 refused to open the bus. Plug it in again, then open it again.")},
    {CanRefusalId::adapterSilent, "canAdapterSilent",
     QT_TRANSLATE_NOOP("Refusal", "Nothing at %1 answers as a serial CAN adapter. Check that it is the right "
                                  "port, that its adapter speaks SLCAN, and the rate of the port.")},
    {CanRefusalId::openingNotKnown, "canOpeningNotKnown",
     QT_TRANSLATE_NOOP("Refusal",
                       "The adapter at %1 did not answer when it was to open the bus: it is not known "
                       "whether it has. Unplug it to be sure that it has not, then try again.")},
    {CanRefusalId::rateMayBe750, "canRateMayBe750",
     QT_TRANSLATE_NOOP("Refusal", "The adapter at %1 is asked for 800 kBd, but adapters of this kind may run "
                                  "at 750 kBd then. If only errors come in, use another adapter.")},
    {CanRefusalId::onlyWatches, "canOnlyWatches",
     QT_TRANSLATE_NOOP("Refusal", "%1 was opened to watch: nothing is sent. Switch to Operate first.")},
    {CanRefusalId::busOff, "canBusOff",
     QT_TRANSLATE_NOOP("Refusal",
                       "%1 has left the bus after too many errors (bus off): the rate or the wiring is "
                       "wrong, or nobody else is there. Check these, then start it again: %2"),
     QT_TRANSLATE_NOOP("Refusal",
                       "%1 has left the bus after too many errors (bus off): the rate or the wiring is "
                       "wrong, or nobody else is there. Check these, then open it again.")},
    {CanRefusalId::interfaceMissing, "canInterfaceMissing",
     QT_TRANSLATE_NOOP("Refusal", "There is no CAN interface %1. Plug its adapter in, and see with \"ip "
                                  "link\" which interfaces there are.")},
    {CanRefusalId::interfaceDown, "canInterfaceDown",
     QT_TRANSLATE_NOOP("Refusal",
                       "The CAN interface %1 is switched off. Switch it on with the rate of the bus: %2")},
    {CanRefusalId::interfaceLost, "canInterfaceLost",
     QT_TRANSLATE_NOOP("Refusal", "The CAN interface %1 has gone: its adapter was unplugged, or the "
                                  "interface switched off. Bring it back, then connect again.")},
    {CanRefusalId::notInKernel, "canNotInKernel",
     QT_TRANSLATE_NOOP("Refusal", "%1 cannot be opened: this system has no CAN. Load it with \"sudo modprobe "
                                  "can_raw\", or use a serial adapter.")},
    {CanRefusalId::pluginMissing, "canPluginMissing",
     QT_TRANSLATE_NOOP("Refusal",
                       "Qt's plugin for CAN interfaces is missing. Install the package libqt6serialbus6.")},
    {CanRefusalId::onlyLogged, "canOnlyLogged",
     QT_TRANSLATE_NOOP(
         "Refusal", "%1 is a log: what is in it is over, and nobody can be asked or told anything there.")},
});

static_assert(areInOrder(canRefusalRows, &SentenceRow::id, CanRefusalId::onlyLogged));

QString canRefusalText(const Refusal &refusal)
{
    const SentenceRow &row = refusal.id.row();
    const bool isBare = row.textWithoutArguments != nullptr && refusal.arguments.size() < 2;
    return sentence(refusalPattern(isBare ? row.textWithoutArguments : row.text),
                    argumentTexts(refusal.arguments));
}

} // namespace

constinit const RefusalFamily canRefusals{canRefusalRows, canRefusalText};

} // namespace codewheel
