// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/setup/node_setup_texts.h"

#include "can/can_state.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/protocol/sdo_abort.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace codewheel::node_setup_text {

using canopen::IdentityReading;
using canopen::LssSearch;
using canopen::LssSelection;
using canopen::NodeCheck;
using canopen::NodeSetup;
using canopen::NodeSetupWish;

namespace {

// The translation context of these texts.
struct SetupText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::NodeSetupTexts)
};

QString shownNode(int node)
{
    return CanopenAddress{node}.shown();
}

QString shownRate(const NodeSetupWish &wish)
{
    return wish.rate ? inKilobits(wish.rate->rate) : QString();
}

QString joined(QStringList sentences)
{
    sentences.removeAll(QString());
    return sentences.join(u' ');
}

QString refusedText(const NodeSetup &setup)
{
    if (setup.abortCode() != 0) {
        const QString why = canopen::sdoAbortText(setup.abortCode());
        return why.isEmpty()
                   ? sentence(SetupText::tr("The device refused it (%1)."), {hexNumber(setup.abortCode(), 8)})
                   : sentence(SetupText::tr("The device refused it: %1"), {why});
    }
    return sentence(SetupText::tr("The device refused it (code %1, of the maker %2)."),
                    {QString::number(setup.code()), QString::number(setup.codeOfMaker())});
}

QString troubleText(const NodeSetup &setup)
{
    using Trouble = NodeSetup::Trouble;
    switch (*setup.trouble()) {
    case Trouble::numberTaken:
        return sentence(SetupText::tr("Another device has the number %1 already. Choose another number, or "
                                      "take that device off the bus first."),
                        {shownNode(setup.wish().nodeAfter())});
    case Trouble::numberStopped:
        return sentence(SetupText::tr("Node %1 was stopped, and a stopped node answers nothing: it has to be "
                                      "taken for present. If it is to go, switch it off or take it off the "
                                      "bus. Then Start node %1 in the panel CAN bus, and try again: whoever "
                                      "still has the number answers."),
                        {shownNode(setup.wish().nodeAfter())});
    case Trouble::identityNotTold:
        return SetupText::tr("The device does not tell its whole identity, without which nothing is written. "
                             "Two devices with the same identity may have answered at once.");
    case Trouble::isOther:
        return SetupText::tr("The device that answers is not the one that was read. Read it again.");
    case Trouble::nobody:
        return SetupText::tr("The device does not take part in LSS. Some makes do so only while they are "
                             "stopped (Stop, in the panel CAN bus), others not at all.");
    case Trouble::several:
        return SetupText::tr("More than one device answers. Have one device alone on the bus.");
    case Trouble::refused:
        return refusedText(setup);
    case Trouble::readBackOther:
        return SetupText::tr("The device took the number and shows another one when it is read back.");
    case Trouble::noAnswer:
        return SetupText::tr("The device did not answer.");
    case Trouble::notSent:
        return SetupText::tr("Not all could be sent.");
    case Trouble::cancelled:
        return SetupText::tr("It was cancelled.");
    }
    return {};
}

// Where it is to be looked for while it is not known what it has stored.
QString whereItMayBe(const NodeSetupWish &wish)
{
    if (!wish.changesNode())
        return SetupText::tr("Switch its supply off and on, then look for it at both rates.");
    return wish.nodeBefore
               ? sentence(SetupText::tr("Switch its supply off and on: then it is node %1 or still node %2."),
                          {shownNode(wish.nodeAfter()), shownNode(*wish.nodeBefore)})
               : sentence(SetupText::tr("Switch its supply off and on: then it is node %1 or still without a "
                                        "number."),
                          {shownNode(wish.nodeAfter())});
}

// What the device has now, where not all went well.
QString whatStands(const NodeSetup &setup)
{
    using Fate = NodeSetup::Fate;
    if (setup.isUntouched())
        return SetupText::tr("Nothing was changed.");
    if (setup.store() == Fate::done)
        return setup.isReset() ? QString()
                               : SetupText::tr("It says that it has stored number and rate, which are in "
                                               "force once its supply was off and on.");
    if (setup.store() == Fate::notKnown)
        return SetupText::tr("Whether it has stored is not known.") + u' ' + whereItMayBe(setup.wish());
    if (setup.node() == Fate::notKnown || setup.rate() == Fate::notKnown)
        return SetupText::tr("Whether it has taken it is not known; it was not stored. Switch its supply off "
                             "and on: then it is as before.");
    return SetupText::tr("What it has taken is not stored. Switch its supply off and on: then it is as "
                         "before.");
}

} // namespace

QString identity(const canopen::NodeIdentity &identity)
{
    return sentence(SetupText::tr("vendor %1, product %2, revision %3, serial number %4"),
                    {hexNumber(identity.vendor()), hexNumber(identity.product()),
                     hexNumber(identity.revision()), serialNumberText(identity.serial())});
}

QString device(std::optional<int> node)
{
    return node ? sentence(SetupText::tr("Node %1"), {shownNode(*node)})
                : SetupText::tr("A device without a number");
}

QString step(NodeSetup::Step step, const NodeSetupWish &wish)
{
    using Step = NodeSetup::Step;
    switch (step) {
    case Step::free:
        return sentence(SetupText::tr("The number %1 is free"), {shownNode(wish.nodeAfter())});
    case Step::identity:
        return SetupText::tr("Its identity is read back (1018h)");
    case Step::select:
        return SetupText::tr("It is selected by LSS, and its identity read back");
    case Step::node:
        return wish.way != NodeSetupWish::Way::object
                   ? sentence(SetupText::tr("It takes the number %1"), {shownNode(wish.nodeAfter())})
                   : sentence(SetupText::tr("The number %1 is written to %2, and read back"),
                              {shownNode(wish.nodeAfter()), wish.nodeObject.text()});
    case Step::rate:
        return sentence(SetupText::tr("It takes the rate %1 kBit/s"), {shownRate(wish)});
    case Step::store:
        return wish.way == NodeSetupWish::Way::lss ? SetupText::tr("It stores number and rate")
                                                   : SetupText::tr("It stores (1010h:1)");
    case Step::leave:
        return SetupText::tr("It leaves the configuration of LSS");
    case Step::reset:
        return SetupText::tr("It is reset");
    }
    return {};
}

QString consequences(const NodeSetupWish &wish)
{
    QStringList sentences;
    if (wish.changesNode() && !wish.nodeBefore)
        sentences << sentence(SetupText::tr("A device without a number becomes node %1."),
                              {shownNode(wish.nodeAfter())});
    else if (wish.changesNode())
        sentences << sentence(SetupText::tr("%1 becomes node %2: a controller that knows it by its number "
                                            "has to know the new one."),
                              {device(wish.nodeBefore), shownNode(wish.nodeAfter())});
    sentences << SetupText::tr("What it gets is stored: one write to its EEPROM.");
    if (wish.rate)
        sentences << sentence(SetupText::tr("%1 kBit/s is in force once its supply was off and on. From then "
                                            "on it is heard at that rate only, so every device of the bus "
                                            "and the adapter have to get it."),
                              {shownRate(wish)});
    else if (wish.isResetAfterwards())
        sentences << SetupText::tr("Then it is reset: it sends no position for a moment, loses values that "
                                   "are not stored, and has to be started again.");
    if (wish.way != NodeSetupWish::Way::lss)
        sentences << SetupText::tr("Storing by 1010h keeps all its other values as they are now, too.");
    return joined(sentences);
}

AtStake ofSearch()
{
    return {SetupText::tr("A device without a number is being looked for by LSS."),
            SetupText::tr("If the bus is left now, the device may stay in the configuration of LSS until its "
                          "supply was off.")};
}

AtStake ofWriting(const NodeSetupWish &wish)
{
    return {
        sentence(SetupText::tr("Number and rate are being written: %1."), {device(wish.nodeBefore)}),
        SetupText::tr("If the bus is left now, nobody knows whether the device has its old number or the "
                      "new one, and whether that is stored; it may stay in the configuration of LSS until "
                      "its supply was off. Broken off, it is left as it should be, but perhaps with half "
                      "of what was to be written.")};
}

AtStake ofChecking(const NodeSetupWish &wish)
{
    return {sentence(SetupText::tr("The device that got the number %1 is being looked for."),
                     {shownNode(wish.nodeAfter())}),
            SetupText::tr("If the bus is left now, its encoder keeps the old number in the bus structure and "
                          "in the project.")};
}

QString end(const NodeSetup &setup)
{
    const QString stays = setup.mayStayInConfiguration()
                              ? SetupText::tr("It may still be in the configuration of LSS: switch its "
                                              "supply off and on.")
                              : QString();
    if (setup.trouble())
        return joined({troubleText(setup), whatStands(setup), stays});
    if (setup.wish().rate)
        return joined({sentence(SetupText::tr("The device says that it has stored %1 kBit/s. Give it to the "
                                              "other devices too, switch the supply of all off and on, and "
                                              "connect the bus at this rate; then check it here."),
                                {shownRate(setup.wish())}),
                       stays});
    return joined({SetupText::tr("The device says that it has stored its number."), stays});
}

QString end(const NodeCheck &check, bool wasWithoutSupply)
{
    using Result = NodeCheck::Result;
    const QString node = shownNode(check.wanted().node);
    switch (*check.result()) {
    case Result::found:
        if (!wasWithoutSupply)
            return sentence(SetupText::tr("The device is there as node %1. Whether it keeps that without "
                                          "supply is sure only once it was without: some makes say that "
                                          "they have stored, and do not. Switch its supply off and on, then "
                                          "check it."),
                            {node});
        if (check.wasOnlyReset())
            return sentence(SetupText::tr("The device is there as node %1. It was reset, not switched off, "
                                          "which proves nothing: switch its supply off and on, then check "
                                          "it again."),
                            {node});
        return check.wasWithoutSupply()
                   ? sentence(SetupText::tr("Proven: it has begun anew, and is still node %1."), {node})
                   : sentence(SetupText::tr("The device is there as node %1, but has not reported since: it "
                                            "was not switched off. Switch its supply off and on, then check "
                                            "it again."),
                              {node});
    case Result::isOther:
        return sentence(SetupText::tr("Another device answers as node %1: its identity is not that of the "
                                      "one that was given the number. Look for both with Search for nodes."),
                        {node});
    case Result::notTold:
        return sentence(SetupText::tr("A device answers as node %1, but does not tell its whole identity: "
                                      "whether it is this one is not known."),
                        {node});
    case Result::doubled:
        return sentence(SetupText::tr("Two devices answer as node %1. Take one of them off the bus, and "
                                      "give it another number."),
                        {node});
    case Result::atOldNumber:
        return sentence(SetupText::tr("It is node %1 again: it said that it had stored, and has not. Some "
                                      "makes store their number by 1010h:1 only, or have switches for it."),
                        {shownNode(*check.wanted().nodeBefore)});
    case Result::silent:
        return sentence(SetupText::tr("Nobody answers as node %1. Check its supply and the rate of the bus, "
                                      "then check it again, or look for it with Search for nodes."),
                        {node});
    case Result::notSent:
        return SetupText::tr("It could not be looked for: nothing is sent now. Check the CAN bus, switch to "
                             "Operate, then check it again.");
    }
    return {};
}

QString end(const LssSearch &search)
{
    using Trouble = LssSelection::Trouble;
    const QString stays = search.mayStayInConfiguration()
                              ? SetupText::tr("A device may still be in the configuration of LSS: switch its "
                                              "supply off and on.")
                              : QString();
    if (search.isCancelled())
        return joined({SetupText::tr("The search was cancelled."), stays});
    switch (search.selection().trouble().value_or(Trouble::nobody)) {
    case Trouble::notSent:
        return joined({SetupText::tr("The search could not be sent. Check the CAN bus, and switch to "
                                     "Operate."),
                       stays});
    case Trouble::several:
        return joined(
            {SetupText::tr("More than one device answers. Have one device alone on the bus."), stays});
    case Trouble::notTold:
    case Trouble::isOther:
        return joined({SetupText::tr("A device was found, and then does not tell its identity. Search again, "
                                     "with that device alone on the bus."),
                       stays});
    case Trouble::lost:
        return joined({SetupText::tr("A device without a number answers, but not to the end of the search: "
                                     "answers were lost or came late. Check the CAN bus, then search again."),
                       stays});
    case Trouble::nobody:
        break;
    }
    return joined({SetupText::tr("No device without a number answers. One that has a number is chosen among "
                                 "the nodes; some makes take no part in LSS."),
                   stays});
}

QString end(const IdentityReading &reading)
{
    const QString node = shownNode(reading.node());
    switch (*reading.result()) {
    case IdentityReading::Result::noAnswer:
        return sentence(SetupText::tr("Node %1 does not answer. Check its supply and the rate of the bus; a "
                                      "node that was stopped answers nothing."),
                        {node});
    case IdentityReading::Result::notTold:
        return sentence(SetupText::tr("Node %1 does not tell its whole identity (1018h), without which "
                                      "nothing is written."),
                        {node});
    case IdentityReading::Result::notSent:
        return SetupText::tr("It could not be read: nothing is sent now. Check the CAN bus, and switch to "
                             "Operate.");
    case IdentityReading::Result::read:
        break;
    }
    return {};
}

} // namespace codewheel::node_setup_text
