// SPDX-License-Identifier: GPL-3.0-or-later
// What only a CAN bus with CANopen tells of its encoders, and how what was found on it is kept.
#include "cli/call/texts.h"
#include "cli/kinds/canopen/canopen_access.h"
#include "cli/kinds/canopen/canopen_scan.h"
#include "cli/kinds/canopen/canopen_trace.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "kinds/canopen/protocol/encoder_bits.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/sentence.h"

#include <QLocale>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// What a CAN bus does not have.
struct MissingOnCan
{
    const char *command;
    const char *why;
};
constexpr std::array missingOnCan{
    MissingOnCan{"words",
                 QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                   "Encoders on CANopen have no words of process data. Read and write "
                                   "objects with codewheel-cli od.")},
    MissingOnCan{"velocity",
                 QT_TRANSLATE_NOOP("codewheel::CommandLine", "Encoders on CANopen have no velocity mode.")},
    MissingOnCan{"master", QT_TRANSLATE_NOOP("codewheel::CommandLine", "A CAN bus has no master to set.")},
};

// CiA 406: the first four octets of TPDO1.
std::uint32_t assumedPosition(const CanFrame &pdo)
{
    return canopen::numberOf(pdo.data().first(std::min<std::size_t>(4, pdo.data().size())));
}

QString loadText(double load)
{
    return QLocale().toString(load * 100, 'f', 1);
}

} // namespace

std::optional<Complaint> CanopenAccess::whyNot(const Subcommand &command) const
{
    const auto found =
        std::ranges::find(missingOnCan, std::string_view(command.name), &MissingOnCan::command);
    if (found == missingOnCan.end())
        return std::nullopt;
    return badInput("notOnCanBus", CommandLine::tr(found->why)).value();
}

std::unique_ptr<JobTrace> CanopenAccess::trace(const std::vector<const EncoderSession *> &)
{
    return std::make_unique<CanopenTrace>(*m_session);
}

// The reading that an encoder shows at this moment.
int CanopenAccess::showing(const Reading &reading) const
{
    for (const Place place : m_session->places())
        if (&m_session->encoder(place)->latest() == &reading)
            return CanopenAddress::of(place.node).node;
    return 0;
}

QStringList CanopenAccess::remarks(const Reading &reading) const
{
    QStringList texts = BusAccess::remarks(reading);
    const int number = showing(reading);
    if (const auto *node = m_session->latest().heard(number)) {
        if (const QString state = nodeStateText(*node); !state.isEmpty())
            texts << state;
        if (const QString errors = nodeTroubles(*node).join(QStringLiteral("; ")); !errors.isEmpty())
            texts << errors;
    }
    if (const CanFrame *pdo = m_firstPdos.of(number); pdo != nullptr && !reading.position)
        texts << sentence(CommandLine::tr("PDO1 %1, which is position %2 if it is mapped as CiA 406 has it"),
                          {octetsText(pdo->data()), QString::number(assumedPosition(*pdo))});
    const EncoderSession *encoder = m_session->encoder(CanopenAddress{number}.place());
    if (encoder != nullptr && reading.alarms)
        texts << canopen::encoderBitTexts(encoder->device(), canopen::object::alarms.index, *reading.alarms);
    if (encoder != nullptr && reading.warnings)
        texts << canopen::encoderBitTexts(encoder->device(), canopen::object::warnings.index,
                                          *reading.warnings);
    return texts;
}

QJsonObject CanopenAccess::remarksJson(const Reading &reading) const
{
    const int number = showing(reading);
    const auto *node = m_session->latest().heard(number);
    QJsonObject json{
        {QStringLiteral("nmt"), node != nullptr ? nmtStateJson(node->state) : QJsonValue()},
        {QStringLiteral("alarms"), reading.alarms ? QJsonValue(*reading.alarms) : QJsonValue()},
        {QStringLiteral("warnings"), reading.warnings ? QJsonValue(*reading.warnings) : QJsonValue()}};
    if (const CanFrame *pdo = m_firstPdos.of(number); pdo != nullptr && !reading.position) {
        json.insert(QStringLiteral("pdo1"), octetsText(pdo->data()));
        json.insert(QStringLiteral("positionIfUsual"), qint64{assumedPosition(*pdo)});
    }
    return json;
}

void CanopenAccess::addFigures(const Call &, const EncoderSession &, Answer &answer) const
{
    const CanopenFigures &figures = m_session->latest().figures;
    answer.text += u'\n' +
                   sentence(CommandLine::tr("Frames received: %1. Sent: %2. Error frames: %3. Load: %4 %."),
                            {QString::number(figures.received), QString::number(figures.sent),
                             QString::number(figures.errorFrames), loadText(figures.load)}) +
                   u'\n';
    answer.json.insert(QStringLiteral("figures"),
                       QJsonObject{{QStringLiteral("received"), static_cast<qint64>(figures.received)},
                                   {QStringLiteral("sent"), static_cast<qint64>(figures.sent)},
                                   {QStringLiteral("errorFrames"), static_cast<qint64>(figures.errorFrames)},
                                   {QStringLiteral("load"), figures.load}});
}

Checked<void> CanopenAccess::checkScan(const Call &call) const
{
    return timeToListen(call, *this).map([](Instant) {});
}

Checked<Answer> CanopenAccess::scan(const Call &call)
{
    auto scanned = scanCan(call, *this);
    if (!scanned)
        return tl::unexpected(scanned.error());
    m_found = std::move(scanned->nodes);
    return std::move(scanned->answer);
}

// What is planned stays, whether it was found or not.
void CanopenAccess::keepFound(const Call &call, Project &project) const
{
    CanopenPlan plan;
    if (const CanopenPlan *before = canopenPlan(project, bus().id()))
        plan = *before;
    plan.settings = m_link.settings;
    plan.settings.rate = m_session->rate();
    setCanopenPlan(project, bus().id(), plan);
    std::vector<ProjectDevice> devices;
    for (const ProjectDevice &planned : devicesOn(project, bus().id()))
        devices.push_back(planned);
    for (const NodeOnBus &found : m_found) {
        const Place place = bus().placeOf(CanopenAddress{found.heard.node}.place());
        const QString type = found.asked
                                 ? deviceOfNode(call.catalog, found.asked->deviceType, found.asked->identity)
                                 : QString();
        const bool isOtherDevice = found.asked && found.asked->deviceType && type.isEmpty();
        if (findDevice(project, place) != nullptr || isOtherDevice)
            continue;
        ProjectDevice device;
        device.standAt(place);
        const auto named = deviceOnNode(call, place);
        device.participant.deviceKey = named && !named->isEmpty() ? *named
                                       : type.isEmpty()           ? usualDeviceOnNode()
                                                                  : type;
        if (found.asked && found.asked->identity.back())
            device.label.serialNumber = QString::number(*found.asked->identity.back());
        devices.push_back(std::move(device));
    }
    std::ranges::sort(devices, {}, [](const ProjectDevice &one) { return one.place(); });
    setDevicesOn(project, bus().id(), std::move(devices));
}

} // namespace codewheel
