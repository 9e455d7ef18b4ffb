// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/line_access.h"

#include "catalog/catalog.h"
#include "cli/texts.h"
#include "drivers/esc_driver.h"
#include "encoder/sentence.h"
#include "journal_files.h"
#include "links/project_adapter.h"
#include "links/serial_port_link.h"
#include "simulator/simulated_line_link.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant longestContact = 30s; // of the slowest settings; silence is noticed long before
constexpr Instant longestIdentity = 1s;

std::unique_ptr<ByteLink> linkTo(const LineLink &link)
{
    if (link.isSimulated())
        return std::make_unique<SimulatedLineLink>(std::make_shared<SimulatedLine>());
    LinePlan line;
    line.wish = link.wish;
    line.adapter = link.adapter;
    return std::make_unique<SerialPortLink>(keptAdapterOf(line));
}

// At the master address, where no two reads agree because several answer at once.
Complaint aboutSeveral(LineAddress address)
{
    return {ExitCode::refused,
            QStringLiteral("encoderNotAlone"),
            sentence(CommandLine::tr(
                         "At %1 no encoder tells its serial number twice the same: several may answer at "
                         "once. The address is for an encoder that is alone on its line. codewheel-cli "
                         "scan finds the addresses of all."),
                     {address.shown()}),
            {placeOnLine(address).toString()}};
}

Complaint aboutSilence(LineAddress address, int baudRate)
{
    if (address.isMaster())
        return aboutSeveral(address);
    return {
        ExitCode::refused,
        QStringLiteral("encoderSilent"),
        sentence(CommandLine::tr("No encoder answers at %1 at %2 Bd. Check address, baud rate, wiring and "
                                 "supply; an RS-422 encoder also needs ST (pin 7) at +UB. codewheel-cli "
                                 "scan --all-rates looks for encoders."),
                 {address.shown(), QString::number(baudRate)}),
        {placeOnLine(address).toString(), std::int64_t{baudRate}}};
}

Complaint aboutStrayBytes(LineAddress address, int baudRate, std::uint64_t bytes)
{
    return {
        ExitCode::refused,
        QStringLiteral("noAnswerAmongBytes"),
        sentence(CommandLine::tr("No answer comes from %1 at %2 Bd, but bytes that are no answers: %3 until "
                                 "now. Either another baud rate or format is needed (codewheel-cli scan "
                                 "--all-rates tries the rates), or the wiring is wrong or disturbed (A and "
                                 "B exchanged, no termination), or a device on the line speaks another "
                                 "protocol."),
                 {address.shown(), QString::number(baudRate), QString::number(bytes)}),
        {placeOnLine(address).toString(), std::int64_t{baudRate}, static_cast<std::int64_t>(bytes)}};
}

Complaint aboutOpening(const Refusal &why)
{
    Complaint complaint = complaintAbout(why);
    if (why.id == RefusalId::portNotFound)
        complaint.text += u' ' + presentPortsText();
    return complaint;
}

} // namespace

LineAccess::LineAccess(std::unique_ptr<ByteLink> link, LineLink settings, const Catalog &catalog)
    : m_link(std::move(settings))
    , m_session(std::make_unique<LineSession>(
          std::move(link), catalog, QDateTime::currentDateTime(),
          [settings = m_link.driver()](const DeviceDescription &device, LineAddress address) {
              return std::make_unique<EscDriver>(device, address, settings);
          }))
    , m_lost(
          std::make_shared<Refusal>(Refusal{RefusalKind::link, RefusalId::portLost, {m_session->linkName()}}))
{
    m_session->setFractionBits(m_link.driver().fractionBits);
    QObject::connect(m_session.get(), &LineSession::messaged, m_session.get(),
                     [lost = m_lost](const Message &message) {
                         if (message.refusal && message.refusal->kind == RefusalKind::link)
                             *lost = *message.refusal;
                     });
}

LineAccess LineAccess::to(const LineLink &link, const Catalog &catalog)
{
    return {linkTo(link), link, catalog};
}

Checked<LineSession *> LineAccess::session()
{
    if (!m_session->isOpen())
        if (const auto opened = m_session->open(m_link.wish.line, m_link.wish.timing,
                                                LineSession::Start::watching, LineSession::Drive::byHand);
            !opened)
            return tl::unexpected(aboutOpening(opened.error()));
    return m_session.get();
}

void LineAccess::keepLedger(const std::optional<QString> &file)
{
    m_ledger = std::make_unique<LedgerKeeper>(
        *m_session, file ? DatabasePlace::file(*file) : ledgerPlace(*m_session, userJournalFolder()));
}

Checked<EncoderSession *> LineAccess::encoder(LineAddress address, const QString &deviceKey)
{
    const auto line = session();
    if (!line)
        return tl::unexpected(line.error());
    const Place number = placeOnLine(address);
    if ((*line)->encoder(number) == nullptr) {
        if (const auto added = (*line)->add(address, deviceKey); !added)
            return tl::unexpected(complaintAbout(added.error()));
        (*line)->setSwapsWarningBytes(number, explainOptions().swaps(address));
    }
    return contact((*line)->encoder(number));
}

// Of one that shows where it stands already, no time passes.
Checked<EncoderSession *> LineAccess::contact(EncoderSession *encoder)
{
    const Place number = encoder->place();
    const LineAddress address = LineAddress::of(number.node);
    const auto state = [&] { return encoder->latest().state; };
    if (!waitUntil([&] { return state() == EncoderState::operation || state() == EncoderState::silent; },
                   longestContact))
        return tl::unexpected(portLost());
    if (state() != EncoderState::operation)
        return tl::unexpected(noAnswerFrom(address));
    if (!waitUntil([&] { return encoder->known(Parameter::serialNumber).has_value(); }, longestIdentity))
        return tl::unexpected(portLost());
    if (address.isMaster() && !encoder->known(Parameter::serialNumber))
        return tl::unexpected(aboutSeveral(address));
    if (std::exchange(m_link.asksForFractionBits, false))
        if (const auto determined = determineFractionBits(number); !determined)
            return tl::unexpected(determined.error());
    return encoder;
}

QString LineAccess::versionOf(const EncoderSession &encoder)
{
    waitUntil([&] { return !encoder.version().isEmpty(); }, longestIdentity);
    return encoder.version();
}

// What the scaling factor of this encoder fits is used for it from then on.
Checked<void> LineAccess::determineFractionBits(Place number)
{
    std::optional<Result<int>> bits;
    QObject scope;
    QObject::connect(m_session.get(), &LineSession::fractionBitsDetermined, &scope,
                     [&](Place, const Result<int> &determined) { bits = determined; });
    if (const auto asked = m_session->determineFractionBits(number); !asked)
        return tl::unexpected(complaintAbout(asked.error()));
    if (!waitUntil([&] { return bits.has_value(); }, longestContact) || !bits)
        return tl::unexpected(portLost());
    if (!*bits)
        return tl::unexpected(complaint(bits->error()));
    m_link.wish.fractionBits = **bits;
    m_session->setFractionBits(**bits);
    advance(lookInterval);
    return {};
}

// False: the port is gone.
bool LineAccess::waitUntil(const std::function<bool()> &isDone, Instant atMost)
{
    for (Instant waited{}; !isDone() && waited < atMost; waited += lookInterval)
        if (!advance(lookInterval))
            return false;
    return true;
}

bool LineAccess::advance(Instant duration)
{
    m_session->advance(duration);
    return isConnected();
}

QString LineAccess::portKey() const
{
    return m_link.isSimulated() ? QStringLiteral("training") : m_session->linkName();
}

Complaint LineAccess::noAnswerFrom(LineAddress address) const
{
    const int baudRate = m_link.wish.line.baudRate;
    const std::uint64_t bytes = strayBytes();
    return bytes == 0 || address.isMaster() ? aboutSilence(address, baudRate)
                                            : aboutStrayBytes(address, baudRate, bytes);
}

std::uint64_t LineAccess::strayBytes() const
{
    const LineFigures &figures = m_session->latest().figures;
    return figures.garbageBytes + figures.lateBytes;
}

QString LineAccess::strayBytesText() const
{
    const std::uint64_t bytes = strayBytes();
    if (bytes == 0)
        return {};
    return sentence(
        CommandLine::tr("Bytes come that are no answers: %1 until now. The baud rate or the format "
                        "may be another one, the wiring wrong or disturbed, or a device on the "
                        "line speaks another protocol."),
        {QString::number(bytes)});
}

Complaint LineAccess::portLost() const
{
    return complaintAbout(*m_lost);
}

Complaint LineAccess::complaint(const Refusal &why) const
{
    Complaint told = complaintAbout(why);
    if (!isConnected() && why.id != m_lost->id)
        told.text.prepend(portLost().text + u' ');
    if (why.id == RefusalId::escNoAnswer)
        if (const QString stray = strayBytesText(); !stray.isEmpty())
            told.text += u' ' + stray;
    return told;
}

} // namespace codewheel
