// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/device_description.h"
#include "cli/call/subcommand.h"
#include "cli/call/texts.h"
#include "cli/encoder/jobs.h"
#include "cli/kinds/esc/device_on_line.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "cli/kinds/esc/esc_line_account.h"
#include "cli/kinds/esc/esc_line_figures_text.h"
#include "cli/kinds/esc/esc_line_trace.h"
#include "cli/kinds/esc/scan_line.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/links/project_adapter.h"
#include "kinds/esc/protocol/esc_bits.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "links/serial_port_link.h"
#include "vocabulary/hex.h"
#include "vocabulary/parameter.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// What is done before values are written to an encoder on a serial line.

// Reads what is about to be written.
Checked<void> readWhatIsWritten(const Call &call, EncoderSession &encoder, const ParameterValues &wanted)
{
    ReadParameters read;
    for (const ParameterValue &value : wanted)
        if (const ParameterDescription *its = encoder.device().find(value.parameter); its && its->canBeRead)
            read.parameters.push_back(value.parameter);
    for (const Parameter scale : {Parameter::revolutions, Parameter::measuringRange, Parameter::scaling})
        if (std::ranges::count(read.parameters, scale) == 0)
            read.parameters.push_back(scale);
    const FinishedJob job = runToEnd(call, {encoder, std::move(read)});
    if (job.wasCancelled)
        return tl::unexpected(aboutCancelling());
    if (!job.outcome.result)
        return tl::unexpected(complaintAboutJob(call, encoder.place(), job.outcome.result.error()));
    return {};
}

// Whether nobody answers at the address the encoder is to be given, in either reading of its digits: whoever
// is there would answer along with it.
Checked<void> checkAddressIsFree(const Call &call, EscLineAccess &line, const EncoderSession &encoder,
                                 const ParameterValues &wanted)
{
    const auto address = valueOf(wanted, Parameter::lineAddress);
    if (!address || *address < 1 || *address > EscLineAddress::last)
        return {};
    for (const EscLineAddress reading : escReadingsOf({static_cast<std::uint8_t>(*address)})) {
        if (reading == EscLineAddress::of(encoder.place().node))
            continue;
        const auto there = whoIsAt(call, line, reading);
        if (!there)
            return tl::unexpected(there.error());
        if (*there)
            return tl::unexpected(complaintAbout(
                {RefusalKind::badInput,
                 RefusalId::lineAddressTaken,
                 {reading.shown(), sentence(CommandLine::tr("an encoder with the serial number %1"),
                                            {serialNumberText((*there)->serialNumber.value_or(0))})}}));
    }
    return {};
}

// What a serial line does not have.
struct Missing
{
    const char *command;
    const char *why;
};
constexpr auto missing = std::to_array<Missing>({
    {"words",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "Encoders on a serial line have no words of process data. "
                                                 "Send commands with codewheel-cli terminal.")},
    {"cams", QT_TRANSLATE_NOOP("codewheel::CommandLine", "Encoders on a serial line have no cams.")},
    {"velocity",
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "Encoders on a serial line have no velocity mode.")},
    {"reset", QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                "Encoders on a serial line have no command that resets them to factory "
                                "settings. Write the values with codewheel-cli write.")},
    {"master", QT_TRANSLATE_NOOP("codewheel::CommandLine", "A serial line has no master.")},
});

// What went over the line; with several encoders each has the requests to its address.
class RequestTrace final : public JobTrace
{
public:
    RequestTrace(const EscLineAccess &line, bool isOfOne)
        : m_line(line)
        , m_isOfOne(isOfOne)
        , m_trace(line.line())
    {}

    QString text(Place place) const override { return lineTraceText(rowsOf(place), m_line.explainOptions()); }
    QJsonArray json(Place place) const override
    {
        return lineTraceJson(rowsOf(place), m_line.explainOptions());
    }

private:
    std::vector<PassedRow> rowsOf(Place place) const
    {
        if (m_isOfOne) // its address may change
            return m_trace.rows();
        std::vector<PassedRow> rows;
        std::ranges::copy_if(m_trace.rows(), std::back_inserter(rows), [place](const PassedRow &row) {
            return row.request && row.request->to == EscLineAddress::of(place.node);
        });
        return rows;
    }

    const EscLineAccess &m_line;
    const bool m_isOfOne;
    const EscLineTrace m_trace;
};

QJsonValue bitsOrNull(esc::Command command, const std::optional<std::uint16_t> &word)
{
    return word ? QJsonValue(bitsJson(command, *word)) : QJsonValue();
}

} // namespace

std::optional<Complaint> EscLineAccess::whyNot(const Subcommand &command) const
{
    const auto found = std::ranges::find(missing, std::string_view(command.name), &Missing::command);
    if (found == missing.end())
        return std::nullopt;
    return badInput("notOnSerialLine", CommandLine::tr(found->why)).value();
}

std::unique_ptr<JobTrace> EscLineAccess::trace(const std::vector<const EncoderSession *> &encoders)
{
    return std::make_unique<RequestTrace>(*this, encoders.size() == 1);
}

Checked<void> EscLineAccess::readBefore(const Call &call, EncoderSession &encoder,
                                        const ParameterValues &wanted)
{
    if (encoder.latest().state != EncoderState::operation)
        return {};
    return readWhatIsWritten(call, encoder, wanted);
}

Checked<void> EscLineAccess::prepareWrite(const Call &call, EncoderSession &encoder,
                                          const ParameterValues &wanted)
{
    return readWhatIsWritten(call, encoder, wanted).and_then([&] {
        return checkAddressIsFree(call, *this, encoder, wanted);
    });
}

std::unique_ptr<WriteAccount> EscLineAccess::account(const EncoderSession &encoder,
                                                     const ParameterValues &wanted,
                                                     const FinishedJob &job) const
{
    return std::make_unique<EscLineAccount>(encoder, wanted, job);
}

QString EscLineAccess::whereItIsNow(const EncoderSession &encoder, const ParameterValues &wanted) const
{
    const EscLineAddress address = EscLineAddress::of(encoder.place().node);
    QString text;
    if (valueOf(wanted, Parameter::lineAddress) && encoder.known(Parameter::lineAddress))
        text += sentence(CommandLine::tr("The encoder is at %1 now: PLACE %2."),
                         {address.shown(), address.onWire()}) +
                u'\n';
    const auto baudRate = encoder.known(Parameter::baudRate);
    if (baudRate && baudRate->value != m_link.settings.serial.baudRate)
        text += sentence(CommandLine::tr("The encoder has %1 Bd now: give the link as ...,baud=%1."),
                         {baudRate->value.toString()}) +
                u'\n';
    return text;
}

QStringList EscLineAccess::remarks(const Reading &reading) const
{
    QStringList texts = BusAccess::remarks(reading);
    if (reading.alarms)
        texts << esc::bitTexts(esc::Command::alarms, *reading.alarms);
    if (reading.warnings)
        texts << esc::bitTexts(esc::Command::warnings, *reading.warnings);
    return texts;
}

QJsonObject EscLineAccess::remarksJson(const Reading &reading) const
{
    return {{QStringLiteral("alarms"), bitsOrNull(esc::Command::alarms, reading.alarms)},
            {QStringLiteral("warnings"), bitsOrNull(esc::Command::warnings, reading.warnings)}};
}

void EscLineAccess::addFigures(const Call &call, const EncoderSession &encoder, Answer &answer) const
{
    const EscLineFigures figures = m_session->shown(encoder.place())->figures;
    answer.text += u'\n' + figuresText(figures);
    answer.json.insert(QStringLiteral("figures"), figuresJson(figures));
    if (m_session->latest().lowLatency == LowLatency::refused)
        call.terminal.complain(
            messageText({.id = EscMessageId::lowLatencyRefused, .arguments = {m_session->linkName()}}));
}

Checked<void> EscLineAccess::checkScan(const Call &call) const
{
    return checkScanOptions(call, *this);
}

Checked<Answer> EscLineAccess::scan(const Call &call)
{
    auto found = scanLine(call, *this);
    if (!found)
        return tl::unexpected(found.error());
    m_found = std::move(found->encoders);
    return std::move(found->answer);
}

void EscLineAccess::keepFound(const Call &call, Project &project) const
{
    EscLinePlan plan;
    if (const EscLinePlan *before = linePlan(project, bus().id()))
        plan = *before;
    plan.settings = m_link.settings;
    plan.adapter = m_port != nullptr ? lineAdapter(m_port->adapter()) : EscLineAdapter();
    if (m_port != nullptr)
        plan.settings.port = m_port->name();
    setLinePlan(project, bus().id(), plan);
    if (hasFoundNobody())
        return;
    std::vector<ProjectDevice> devices;
    for (const FoundEncoder &found : m_found) {
        const Place place = bus().placeOf(found.address.node());
        const ProjectDevice *before = findDevice(project, place);
        ProjectDevice device = before != nullptr ? *before : ProjectDevice();
        device.standAt(place);
        if (before == nullptr)
            device.participant.deviceKey = deviceOf(call, nullptr);
        if (device.label.serialNumber.isEmpty() && found.serialNumber)
            device.label.serialNumber = hexWord(*found.serialNumber);
        devices.push_back(std::move(device));
    }
    setDevicesOn(project, bus().id(), std::move(devices));
}

} // namespace codewheel
