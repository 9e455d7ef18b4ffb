// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "cli/bus/places.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/canopen/object_writing.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/kept_identifier.h"
#include "kinds/canopen/protocol/lss_rates.h"
#include "kinds/canopen/protocol/lss_selection.h"
#include "kinds/canopen/setup/identity_reading.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <QJsonArray>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using canopen::LssOutcome;
using canopen::LssRequest;
using canopen::LssSelection;
using canopen::NodeIdentity;

constexpr const char *lssExamples[] = {"lss scan --link canopen:training", "lss node 9 --yes",
                                       "lss rate 250000 --of can:5", "lss store --alone"};

constexpr std::array lssOptions{
    Option{"--of", "PLACE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "the node there, selected by its identity; else a device without a number")},
    Option{"--alone", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "whoever is there: the device is alone on the bus")},
    Option{"--activate", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "with rate: at once, and the adapter with it; with --alone only")},
    busOption,
    beyondLimitOption,
    ledgerOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "send it without asking")},
};

Complaint aboutNoLssDevice(const Call &call)
{
    if (call.arguments.has("--of"))
        return notDone("lssNotSelected",
                       CommandLine::tr("The node does not take part in LSS. Some makes do so only while "
                                       "they are stopped (codewheel-cli nmt stop), others not at all."));
    if (call.arguments.has("--alone"))
        return notDone("lssNoAnswer",
                       CommandLine::tr("No device answers by LSS, or several at once. Some makes do so "
                                       "only while they are stopped (codewheel-cli nmt stop), others "
                                       "not at all."));
    return notDone("lssNobodyWithoutNumber",
                   CommandLine::tr("No device without a number answers. One that has a number is named "
                                   "with --of PLACE, or, alone on the bus, taken with --alone."));
}

Complaint aboutLssOutcome(const LssOutcome &outcome)
{
    switch (outcome.kind) {
    case LssOutcome::Kind::refused:
        return notDone("lssRefused",
                       sentence(CommandLine::tr("The device refused it (code %1, of the maker %2)."),
                                {QString::number(outcome.code), QString::number(outcome.codeOfMaker)}));
    case LssOutcome::Kind::notSent:
        return notDone("lssNotSent", CommandLine::tr("It could not be sent, so nothing was changed. "
                                                     "Check the CAN bus, then start again."));
    default:
        return notDone("lssNotKnown", CommandLine::tr("The device did not answer: whether it has done it "
                                                      "is not known. Look for it with codewheel-cli "
                                                      "scan --ask."));
    }
}

QString identityText(const NodeIdentity &identity)
{
    return sentence(CommandLine::tr("vendor %1, product %2, revision %3, serial number %4"),
                    {hexNumber(identity.vendor()), hexNumber(identity.product()),
                     hexNumber(identity.revision()), serialNumberText(identity.serial())});
}

QJsonObject identityJson(const NodeIdentity &identity)
{
    return {{QStringLiteral("vendor"), qint64{identity.vendor()}},
            {QStringLiteral("product"), qint64{identity.product()}},
            {QStringLiteral("revision"), qint64{identity.revision()}},
            {QStringLiteral("serialNumber"), qint64{identity.serial()}}};
}

Complaint aboutSeveralByLss()
{
    return notDone("lssSeveral", CommandLine::tr("More than one device answers by LSS. Have one device "
                                                 "alone on the bus."));
}

Complaint aboutOtherByLss()
{
    return notDone("lssIdentityDiffers", CommandLine::tr("The device that was found and the one that "
                                                         "answers are not the same. Nothing was written: "
                                                         "have one device alone on the bus."));
}

// One device by LSS. In configuration it is only from select() to leave(), or to the end of this.
class SelectedDevice
{
public:
    SelectedDevice(const Call &call, CanopenAccess &bus)
        : m_call(call)
        , m_bus(bus)
    {}
    ~SelectedDevice() { static_cast<void>(leave()); }
    SelectedDevice(const SelectedDevice &) = delete;
    SelectedDevice &operator=(const SelectedDevice &) = delete;

    // As the call says; its identity is read from it then. Once more: it must be the same one.
    Checked<void> select();
    // A device without a number takes part with its new one from then on.
    Checked<void> leave();
    Checked<LssOutcome> ask(const LssRequest &request)
    {
        return ask(request, CanopenAccess::WhenStopped::ends);
    }
    // In configuration, or if it has left that, once it is back: it tells the identity that it had.
    bool isStillThere();

    bool hasOthers() const { return m_extraAnswers > 0; } // that answer, too
    std::optional<int> node() const { return m_node; }    // empty: it has none
    std::optional<Place> place() const { return m_place; }
    int numberOnBus() const { return m_of != 0 ? m_of : m_node.value_or(0); } // 0: it has none
    QString text() const;
    QJsonObject json() const;

private:
    Checked<LssOutcome> ask(const LssRequest &request, CanopenAccess::WhenStopped stopped);
    LssSelection::By way() const;
    Complaint aboutTrouble(LssSelection::Trouble trouble) const;
    Checked<void> readWanted(const QString &typed);
    Checked<NodeIdentity> identityAt(const NodeMeant &where);

    const Call &m_call;
    CanopenAccess &m_bus;
    bool m_isSelected = false;
    int m_extraAnswers = 0;
    std::optional<NodeIdentity> m_wanted{}; // as its node, the search or itself has told it
    NodeIdentity m_identity{};
    std::optional<int> m_node{};
    std::optional<Place> m_place{}; // given
    int m_of = 0;                   // likewise
};

Checked<LssOutcome> SelectedDevice::ask(const LssRequest &request, CanopenAccess::WhenStopped stopped)
{
    auto outcome = m_bus.configure(request, stopped);
    // In a search each of them answers.
    if (outcome && request.kind != LssRequest::Kind::fastScan)
        m_extraAnswers += outcome->extraAnswers;
    return outcome;
}

LssSelection::By SelectedDevice::way() const
{
    return m_call.arguments.has("--alone") ? LssSelection::By::alone
           : m_wanted                      ? LssSelection::By::identity
                                           : LssSelection::By::fastScan;
}

Complaint SelectedDevice::aboutTrouble(LssSelection::Trouble trouble) const
{
    using Trouble = LssSelection::Trouble;
    switch (trouble) {
    case Trouble::notSent:
        return aboutLssOutcome({.kind = LssOutcome::Kind::notSent});
    case Trouble::nobody:
        return aboutNoLssDevice(m_call);
    case Trouble::lost:
        return notDone("lssLost", CommandLine::tr("A device without a number answers, but not to the "
                                                  "end of the search: answers were lost or came "
                                                  "late. Check the CAN bus, then search again."));
    case Trouble::notTold:
        return notDone("lssIdentityNotTold",
                       CommandLine::tr("The device was selected, and then does not tell "
                                       "its identity and number, without which nothing is "
                                       "written."));
    case Trouble::isOther:
        return aboutOtherByLss();
    case Trouble::several:
        return aboutSeveralByLss();
    }
    Q_UNREACHABLE();
}

Checked<void> SelectedDevice::select()
{
    if (const auto of = m_call.arguments.value("--of"); of && !m_wanted)
        if (const auto read = readWanted(*of); !read)
            return read;
    m_isSelected = true;
    LssSelection selection(way(), m_wanted);
    while (const auto request = selection.next()) {
        const auto outcome = ask(*request);
        if (!outcome)
            return tl::unexpected(outcome.error());
        selection.take(*outcome);
    }
    if (selection.trouble())
        return tl::unexpected(aboutTrouble(*selection.trouble()));
    m_extraAnswers = 0; // those were of before
    m_wanted = m_identity = selection.identity();
    m_node = selection.node();
    return {};
}

// Its identity, as the node itself tells it.
Checked<void> SelectedDevice::readWanted(const QString &typed)
{
    const auto where = nodeMeant(m_call, typed);
    if (!where)
        return tl::unexpected(where.error());
    m_place = where->place;
    m_of = where->node();
    return identityAt(*where).map([this](const NodeIdentity &identity) { m_wanted = identity; });
}

Checked<NodeIdentity> SelectedDevice::identityAt(const NodeMeant &where)
{
    canopen::IdentityReading reading(where.node());
    while (const auto request = reading.next()) {
        const auto told = m_bus.transfer(*request);
        if (!told)
            return tl::unexpected(told.error());
        reading.answered(*told);
    }
    if (reading.result() == canopen::IdentityReading::Result::read)
        return reading.identity();
    return tl::unexpected(notDone(
        "identityNotRead", sentence(CommandLine::tr("Node %1 does not tell its whole identity (1018h), "
                                                    "without which it cannot be selected."),
                                    {CanopenAddress{where.node()}.shown()})));
}

bool SelectedDevice::isStillThere()
{
    constexpr auto goesOn = CanopenAccess::WhenStopped::goesOn;
    const auto isIt = [this] {
        const auto told = ask({.kind = LssRequest::Kind::inquireIdentity}, goesOn);
        return told && told->kind == LssOutcome::Kind::done && told->identity == m_identity;
    };
    return isIt() || (ask({.kind = LssRequest::Kind::configureAll}, goesOn) && isIt());
}

Checked<void> SelectedDevice::leave()
{
    if (!std::exchange(m_isSelected, false))
        return {};
    const auto mayStay =
        notDone("lssNotLeft", CommandLine::tr("The device may still be in LSS configuration. Switch its "
                                              "supply off and on, or start the command again."));
    if (!m_bus.isConnected())
        return tl::unexpected(mayStay);
    const auto left = ask({.kind = LssRequest::Kind::operateAll}, CanopenAccess::WhenStopped::goesOn);
    if (left && left->kind == LssOutcome::Kind::done)
        return {};
    return tl::unexpected(mayStay);
}

QString SelectedDevice::text() const
{
    return sentence(m_node ? CommandLine::tr("Node %2: %1")
                           : CommandLine::tr("A device without a number: %1"),
                    {identityText(m_identity), m_node ? CanopenAddress{*m_node}.shown() : QString()}) +
           u'\n';
}

QJsonObject SelectedDevice::json() const
{
    QJsonObject json = identityJson(m_identity);
    json.insert(QStringLiteral("node"), m_node ? QJsonValue(*m_node) : QJsonValue());
    return json;
}

QString aboutMore(const Call &call)
{
    return call.arguments.has("--alone")
               ? CommandLine::tr("Whether other devices took part as well is not known.")
               : CommandLine::tr("Whether there are more without a number is seen when this one has one.");
}

// What went wrong, and whether the device is left in configuration.
Complaint withWhereItWasLeft(Complaint what, SelectedDevice &device)
{
    if (const auto left = device.leave(); !left)
        what.text += u' ' + left.error().text;
    return what;
}

Checked<void> showByLss(const Call &call, CanopenAccess &bus, SelectedDevice &device)
{
    const CanopenAccess::ByHand byHand(bus);
    if (const auto selected = device.select(); !selected)
        return tl::unexpected(withWhereItWasLeft(selected.error(), device));
    if (const auto left = device.leave(); !left)
        return left;
    if (!call.arguments.has("--json"))
        call.terminal.print(device.text());
    return {};
}

// Everything that has to be agreed to before.
Checked<void> agreeToLss(const Call &call, CanopenAccess &bus, const SelectedDevice &device, bool stores,
                         const QString &question)
{
    if (call.arguments.has("--alone"))
        call.terminal.complain(aboutMore(call));
    if (const auto agreed = consent(
            call, question, CommandLine::tr("Nothing was written: there is nobody to ask. Add --yes."));
        !agreed)
        return agreed;
    const EncoderSession *encoder =
        stores && device.place() ? bus.bus().encoder(device.place()->node) : nullptr;
    if (encoder != nullptr)
        if (const auto may = eepromConsent(call, *encoder, 1, AsksAnyway::yes); !may)
            return tl::unexpected(may.error());
    return bus.listenAgain();
}

// The device takes the rate it was given, and so do we. It waits before, and is silent as long after.
std::optional<Complaint> activateByLss(CanopenAccess &bus, SelectedDevice &device, int rate)
{
    constexpr std::chrono::milliseconds delay{500};
    constexpr std::chrono::milliseconds margin{100};
    const auto sent =
        device.ask({.kind = LssRequest::Kind::activate, .number = static_cast<int>(delay.count())});
    if (!sent)
        return sent.error();
    if (sent->kind != LssOutcome::Kind::done)
        return aboutLssOutcome(*sent);
    bus.advance(delay);
    if (const auto changed = bus.changeRate(rate); !changed)
        return changed.error();
    bus.advance(delay + margin);
    if (device.isStillThere())
        return std::nullopt;
    return notDone("lssNotAtRate",
                   sentence(CommandLine::tr("The device does not answer at %1 Bd. It may still have the "
                                            "rate of before; after its supply was switched off and on "
                                            "it has that which is stored."),
                            {QString::number(rate)}));
}

// Its end, with what is known of it. `activated`: the rate that is to be in force; 0: none.
std::optional<Complaint> sendByLss(CanopenAccess &bus, SelectedDevice &device, const LssRequest &request,
                                   int activated)
{
    const auto outcome = device.ask(request);
    std::optional<Complaint> complaint;
    if (!outcome) {
        complaint = outcome.error();
        if (complaint->key != aboutCancelling().key) // then it was not sent
            complaint->text += u' ' + aboutLssOutcome({}).text;
    } else if (outcome->kind != LssOutcome::Kind::done) {
        complaint = aboutLssOutcome(*outcome);
        if (!bus.isConnected())
            complaint->text = bus.linkLost().text + u' ' + complaint->text;
    } else if (activated != 0) {
        complaint = activateByLss(bus, device, activated);
    }
    const auto left = device.leave();
    if (!left && !complaint)
        complaint = left.error();
    else if (!left)
        complaint->text += u' ' + left.error().text;
    if (device.hasOthers() && !complaint)
        complaint = aboutSeveralByLss();
    return complaint;
}

// What is to be written, asked for after the device was shown. While that is asked it is in no configuration.
Checked<Answer> writeByLss(const Call &call, CanopenAccess &bus, const LssRequest &request,
                           const QString &question, int activated = 0)
{
    SelectedDevice device(call, bus);
    if (const auto shown = showByLss(call, bus, device); !shown)
        return tl::unexpected(shown.error());
    const bool stores = request.kind == LssRequest::Kind::store;
    if (const auto agreed = agreeToLss(call, bus, device, stores, question); !agreed)
        return tl::unexpected(agreed.error());
    const CanopenAccess::ByHand byHand(bus);
    if (const auto selected = device.select(); !selected)
        return tl::unexpected(withWhereItWasLeft(selected.error(), device));
    const bool hadNone = !device.node();
    LssRequest asked = request;
    if (stores)
        asked.number = device.numberOnBus();
    Answer answer{.json = {{QStringLiteral("device"), device.json()}}};
    addBus(answer.json, bus);
    answer.complaint = sendByLss(bus, device, asked, activated);
    if (answer.complaint)
        return answer;
    if (stores)
        answer.text = CommandLine::tr("The device says that it has stored number and rate. Some makes say so "
                                      "and do not: it is sure when they are there after its supply was "
                                      "switched off and on.") +
                      u'\n';
    else if (activated != 0)
        answer.text =
            sentence(CommandLine::tr("The device and this adapter have %1 Bd now: from here on, give "
                                     "rate=%1 behind the link. Without supply the device has its "
                                     "rate of before until this one is stored (codewheel-cli lss "
                                     "store)."),
                     {QString::number(activated)}) +
            u'\n';
    else if (request.kind == LssRequest::Kind::setRate)
        answer.text = CommandLine::tr("The device has taken the rate. It is in force once it was stored "
                                      "(codewheel-cli lss store) and its supply switched off and on.") +
                      u'\n';
    else if (!hadNone)
        answer.text = CommandLine::tr("The device has taken the number. It is in force after a reset "
                                      "(codewheel-cli nmt reset), and lost without supply until it is "
                                      "stored (codewheel-cli lss store).") +
                      u'\n';
    return answer;
}

// Which identifiers the node has that are not those of its number: some makes keep stored ones.
void tellKeptIdentifiers(CanopenAccess &bus, int node, Answer &answer)
{
    std::vector<canopen::SdoObject> objects(canopen::identifierObjects.begin(),
                                            canopen::identifierObjects.end());
    std::ranges::copy(canopen::identifierObjectsOfTpdos, std::back_inserter(objects));
    QJsonArray told;
    for (const canopen::SdoObject object : objects) {
        const auto outcome = bus.transfer({.node = node, .object = object});
        if (!outcome || outcome->kind == canopen::SdoOutcome::Kind::noAnswer)
            break;
        const auto kept = outcome->kind == canopen::SdoOutcome::Kind::read
                              ? canopen::keptIdentifier(object, canopen::numberOf(outcome->value), node)
                              : std::nullopt;
        if (!kept)
            continue;
        told.append(QJsonObject{{QStringLiteral("object"), object.text()},
                                {QStringLiteral("identifier"), qint64{kept->identifier}},
                                {QStringLiteral("predefined"), qint64{kept->predefined}}});
        answer.text += messageText(kept->message()) + u'\n';
    }
    answer.json.insert(QStringLiteral("keptIdentifiers"), told);
}

// Whether a device that had no number reports with its new one.
void tellNewNode(CanopenAccess &bus, int node, Answer &answer)
{
    constexpr Instant longestBootOfNew = std::chrono::seconds(2);
    const CanopenAccess::ByHand byHand(bus);
    const bool isThere =
        bus.waitUntil([&] { return bus.session().latest().heard(node) != nullptr; }, longestBootOfNew);
    answer.json.insert(QStringLiteral("isThere"), isThere);
    if (isThere)
        answer.text += sentence(CommandLine::tr("Node %1 has reported. Its number is lost without supply "
                                                "until it is stored: codewheel-cli lss store --of %2."),
                                {CanopenAddress{node}.shown(), CanopenAddress{node}.place().toString()}) +
                       u'\n';
    if (isThere)
        tellKeptIdentifiers(bus, node, answer);
    else if (!answer.complaint)
        answer.complaint = notDone(
            "lssNotBack", sentence(CommandLine::tr("The device has taken the number, but node %1 has not "
                                                   "reported. Look for it with codewheel-cli scan --ask."),
                                   {CanopenAddress{node}.shown()}));
}

Checked<Answer> lssNode(const Call &call, CanopenAccess &bus)
{
    const QString typed = call.arguments.rest.value(1);
    const auto number = parseNumber(typed);
    if (!number || *number < 1 || *number > canopen::lastNode)
        return tl::unexpected(bus.notAPlace(typed));
    const int node = static_cast<int>(*number);
    const auto there = bus.transfer({.node = node, .object = {0x1000, 0}});
    if (!there)
        return tl::unexpected(there.error());
    if (there->kind != canopen::SdoOutcome::Kind::noAnswer || bus.session().latest().heard(node) != nullptr)
        return badInput("nodeNumberTaken",
                        CommandLine::tr("Another device has the number %1 already. Choose another number."),
                        {CanopenAddress{node}.shown()});
    if (bus.session().latest().isStopped(node))
        return badInput("nodeNumberStopped",
                        CommandLine::tr("Node %1 was stopped, and a stopped node answers nothing: it has to "
                                        "be taken for present. Switch it off if it is to go, start the "
                                        "number (codewheel-cli nmt start), and try again."),
                        {CanopenAddress{node}.shown()});
    auto answer =
        writeByLss(call, bus, {.kind = LssRequest::Kind::setNode, .number = node},
                   sentence(CommandLine::tr("Give it the number %1?"), {CanopenAddress{node}.shown()}));
    if (answer && !answer->complaint && answer->json[u"device"][u"node"].isNull())
        tellNewNode(bus, node, *answer);
    return answer;
}

// The numbers that stand for rates, and whose they are.
struct RateTable
{
    std::vector<NumberedRate> rates{};
    std::optional<canopen::SdoObject> object{}; // of the maker, at `where`; empty: they are those of LSS
    NodeMeant where{};

    const NumberedRate *find(long long rate) const
    {
        const auto found = std::ranges::find(rates, rate, &NumberedRate::rate);
        return found != rates.end() ? &*found : nullptr;
    }
};

// Those of CiA 305, and what the description of the node that --of names has of its own.
Checked<RateTable> rateTable(const Call &call, CanopenAccess &bus)
{
    RateTable table;
    for (const canopen::LssRate &one : canopen::lssRates)
        table.rates.push_back({one.rate, one.place});
    const auto of = call.arguments.value("--of");
    if (!of)
        return table;
    const auto where = nodeMeant(call, *of);
    if (!where)
        return tl::unexpected(where.error());
    const auto told = bus.identityOf(call, where->node());
    if (!told)
        return tl::unexpected(told.error());
    const DeviceDescription *device = canopen::describedNode(call.catalog.devices(), *told);
    const CanopenDevice its = device != nullptr ? canopenDevice(*device) : CanopenDevice();
    table.object = its.rateObject;
    table.where = *where;
    if (its.rateObject)
        table.rates.clear();
    for (const NumberedRate &one : its.rates) {
        std::erase_if(table.rates, [&](const NumberedRate &other) {
            return other.number == one.number || other.rate == one.rate;
        });
        table.rates.push_back(one);
    }
    return table;
}

Checked<Answer> writeRateObject(const Call &call, const RateTable &table, const NumberedRate &rate)
{
    if (!call.arguments.has("--json"))
        call.terminal.print(
            sentence(CommandLine::tr("Its maker has the rate in %1: %2 stands for %3 Bd."),
                     {table.object->text(), QString::number(rate.number), QString::number(rate.rate)}) +
            u'\n');
    const ObjectArgument what{.object = *table.object,
                              .value = QString::number(rate.number),
                              .type = canopen::ObjectType::u8,
                              .parameter = nullptr};
    auto answer = writeObject(call, table.where, what);
    if (!answer)
        return answer;
    answer->json.insert(QStringLiteral("rate"), rate.rate);
    addPlace(answer->json, call, table.where.place);
    if (!answer->complaint)
        answer->text += sentence(CommandLine::tr("The rate is in force once it was stored (codewheel-cli od "
                                                 "%1 write 1010:1=save) and the supply switched off and on."),
                                 {table.where.place.node.toString()}) +
                        u'\n';
    return answer;
}

Checked<Answer> lssRate(const Call &call, CanopenAccess &bus)
{
    const auto table = rateTable(call, bus);
    if (!table)
        return tl::unexpected(table.error());
    const auto rate = parseNumber(call.arguments.rest.value(1));
    const NumberedRate *row = table->find(rate.value_or(0));
    const auto rateText = [](const NumberedRate &one) { return QString::number(one.rate); };
    if (row == nullptr && table->object)
        return badInput("lssRateWrong",
                        CommandLine::tr("\"%1\" is not a rate of this device. Give one of these, in Bd: %2."),
                        {call.arguments.rest.value(1), listed(table->rates, rateText)});
    if (row == nullptr)
        return badInput("lssRateWrong",
                        CommandLine::tr("\"%1\" is not a rate of CiA 305. Give one of these, in Bd: %2."),
                        {call.arguments.rest.value(1), listed(table->rates, rateText)});
    if (table->object)
        return writeRateObject(call, *table, *row);
    const bool activates = call.arguments.has("--activate");
    if (activates && !call.arguments.has("--alone"))
        return badInput(
            "lssActivateNotAlone",
            CommandLine::tr("--activate changes the rate of the device and of the adapter at once, "
                            "which disturbs all others on the bus: it needs --alone."));
    if (activates && !bus.canChangeRate())
        return badInput(
            "lssActivateNotHere",
            CommandLine::tr("The rate of this link cannot change along with the device: it is not "
                            "that of a serial adapter. Store the rate (codewheel-cli lss store), "
                            "switch the supply of the device off and on, and set the rate of the "
                            "interface."));
    return writeByLss(call, bus, {.kind = LssRequest::Kind::setRate, .number = row->number},
                      sentence(CommandLine::tr("Give it the rate %1 Bd?"), {QString::number(row->rate)}),
                      activates ? row->rate : 0);
}

Checked<Answer> lssStore(const Call &call, CanopenAccess &bus)
{
    if (!call.arguments.has("--of"))
        return writeByLss(call, bus, {.kind = LssRequest::Kind::store},
                          CommandLine::tr("Store its number and rate? It writes to its EEPROM."));
    // Whose EEPROM it is.
    return nodeMeant(call, *call.arguments.value("--of"))
        .and_then([&](const NodeMeant &where) { return bus.encoder(call, where.place.node, false); })
        .and_then([&](const EncoderSession *) {
            return writeByLss(call, bus, {.kind = LssRequest::Kind::store},
                              CommandLine::tr("Store its number and rate? It writes to its EEPROM."));
        });
}

// `scan`: that without a number. `show`: the one that the call names.
Checked<Answer> lssShow(const Call &call, CanopenAccess &bus)
{
    const bool scans = call.arguments.rest.front() == QStringLiteral("scan");
    if (scans && (call.arguments.has("--of") || call.arguments.has("--alone")))
        return badInput("lssScanOfAll",
                        CommandLine::tr("scan looks for devices without a number. Leave --of and --alone "
                                        "out, or write show."));
    const CanopenAccess::ByHand byHand(bus);
    SelectedDevice device(call, bus);
    if (const auto selected = device.select(); !selected)
        return tl::unexpected(withWhereItWasLeft(selected.error(), device));
    if (const auto left = device.leave(); !left)
        return tl::unexpected(left.error());
    Answer answer{device.text(), {{QStringLiteral("device"), device.json()}}};
    addBus(answer.json, bus);
    if (!call.arguments.has("--of"))
        answer.text += aboutMore(call) + u'\n';
    if (device.numberOnBus() != 0)
        tellKeptIdentifiers(bus, device.numberOnBus(), answer);
    return answer;
}

struct LssAction
{
    const char *name;
    int arguments;
    Checked<Answer> (*run)(const Call &call, CanopenAccess &bus);
};
constexpr std::array lssActions{LssAction{"show", 0, lssShow}, LssAction{"scan", 0, lssShow},
                                LssAction{"node", 1, lssNode}, LssAction{"rate", 1, lssRate},
                                LssAction{"store", 0, lssStore}};

Checked<Answer> runLss(const Call &call)
{
    const QStringList &words = call.arguments.rest;
    const auto action = std::ranges::find(lssActions, words[0],
                                          [](const LssAction &one) { return QString::fromLatin1(one.name); });
    if (action == lssActions.end())
        return badInput("lssActionWrong", CommandLine::tr("\"%1\" is not possible. Write one of: %2."),
                        {words[0], listed(lssActions, [](const LssAction &one) {
                             return QString::fromLatin1(one.name);
                         })});
    if (words.size() - 1 != action->arguments)
        return badInput("lssArgumentsWrong",
                        action->arguments == 0 ? CommandLine::tr("%1 stands alone.")
                                               : CommandLine::tr("Give one number behind %1."),
                        {words[0]});
    if (call.arguments.has("--of") && call.arguments.has("--alone"))
        return badInput("lssOfAndAlone",
                        CommandLine::tr("--of and --alone exclude each other. Leave one of them out."));
    const auto bus = canBusMeant(call);
    if (!bus)
        return tl::unexpected(bus.error());
    if (const auto opened = (*bus)->openToSend(call); !opened)
        return tl::unexpected(opened.error());
    return action->run(call, **bus);
}

} // namespace

const Subcommand lssCommand{
    .name = "lss",
    .usage = "show|scan|node|rate|store [NUMBER] [--of PLACE | --alone [--activate]] [--bus BUS] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "give a device on CANopen its node number and rate by LSS"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Of a device without a number, which is looked for (some seconds); with --of PLACE of the node "
        "there;\n"
        "with --alone of whoever is there, where one device is alone on the bus. scan and show tell its\n"
        "identity and number; node 9 gives it a number, rate 250000 a rate in Bd, and store keeps both.\n"
        "Where the description of the node has the object of the rate, or other numbers for rates than CiA "
        "305,\n"
        "rate with --of goes by them.\n"
        "\n"
        "Before anything is written its identity is read from it and shown, and it is asked for; where "
        "nobody\n"
        "can be asked, --yes is needed. A number that another node has is refused. Storing writes to the\n"
        "EEPROM."),
    .examples = lssExamples,
    .options = lssOptions,
    .arguments = {1, 2},
    .needsBus = true,
    .textIsAccount = true,
    .run = runLss,
};

} // namespace codewheel
