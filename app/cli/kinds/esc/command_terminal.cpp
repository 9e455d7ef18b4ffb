// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/call/typed_lines.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/kinds/esc/allowed_request.h"
#include "cli/kinds/esc/device_on_line.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "cli/kinds/esc/esc_line_figures_text.h"
#include "cli/kinds/esc/esc_line_link_kind.h"
#include "cli/kinds/esc/esc_line_trace.h"
#include "kinds/esc/line/typed_request.h"
#include "kinds/esc/line/write_question.h"
#include "vocabulary/sentence.h"

#include <QJsonDocument>
#include <QScopedValueRollback>

#include <array>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr const char *terminalExamples[] = {"terminal 05P 05N", "terminal 03GP00005200 03P --yes",
                                            "terminal 05P --json"};

constexpr std::array terminalOptions{
    deviceOption,
    busOption,
    beyondLimitOption,
    ledgerOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "send what writes without asking")},
};

// A row with widths of its own, since the rows to come are not known.
QString terminalRow(const PassedRow &passed, const esc::ExplainOptions &explain)
{
    constexpr int timeWidth = 9;
    constexpr int kindWidth = 8;
    constexpr int textWidth = 24; // <1B>03GP00005200<0D><0A>
    constexpr int bytesWidth = 44;
    const QString space = QStringLiteral("  ");
    return rowTime(passed.row.at).rightJustified(timeWidth) + space +
           rowKindWord(passed.row.kind).leftJustified(kindWidth) + space +
           controlText(passed.row.bytes, ControlCharacters::numbers).leftJustified(textWidth) + space +
           byteText(passed.row.bytes).leftJustified(bytesWidth) + space + rowMeaning(passed, explain) + u'\n';
}

Complaint aboutNobodyKnown()
{
    return notDone(
        "encodersNotKnown",
        CommandLine::tr("What is written to the address 00 goes into the EEPROM of every encoder of the "
                        "line, and it is not known which there are. Nothing was sent. Write to each by "
                        "its own address (codewheel-cli scan finds them), or name the project that has "
                        "them with --project."));
}

// One call in progress.
class TypedCall
{
public:
    TypedCall(const Call &call, EscLineAccess &access);

    // Sends what was typed and waits for its answer. False: nothing more is to be sent.
    bool take(const QString &typed);
    bool listen() { return m_access.advance(m_access.lookInterval()) && goesOn(); }
    TypedLines &lines() { return m_lines; }
    Answer answer() const;

private:
    struct Written
    {
        QString request;
        bool isAnswered = false;
    };

    bool isAnswered() const { return m_call.terminal.isInteractive && !m_call.arguments.has("--json"); }
    void show(const esc::EscLineRow &row);
    Checked<AllowedRequest> allowed(const esc::Request &request);
    Checked<void> askToWrite(const esc::Request &request);
    bool wasSent() const { return m_answered && m_answered->result.sent > 0; }
    QString whatWasDone() const;
    bool goesOn() const { return m_call.terminal.canPrint(); } // otherwise nobody sees what comes
    Checked<Encoders> identified(EscLineAddress address);
    Checked<void> contact(EscLineAddress address);
    Checked<void> contactEverybody();
    Checked<void> contactWhoIsAlone();
    void send(const AllowedRequest &request);
    bool fail(const Complaint &complaint);
    bool cancel();

    const Call &m_call;
    EscLineAccess &m_access;
    EscLineSession &m_line;
    TypedLines m_lines;
    QObject m_scope;
    std::optional<esc::Request> m_lastRequest;
    std::vector<Written> m_written;
    std::optional<TypedAnswered> m_answered;
    std::optional<Complaint> m_complaint; // the first
    bool m_isPolling = false;             // to get to know an encoder
};

TypedCall::TypedCall(const Call &call, EscLineAccess &access)
    : m_call(call)
    , m_access(access)
    , m_line(access.line())
    , m_lines(call.terminal)
{
    m_line.setRunning(false);
    QObject::connect(&m_line, &EscLineSession::passed, &m_scope,
                     [this](const esc::EscLineRow &row) { show(row); });
    QObject::connect(&m_line, &EscLineSession::typedAnswered, &m_scope,
                     [this](const TypedAnswered &answer) { m_answered = answer; });
}

void TypedCall::show(const esc::EscLineRow &row)
{
    const PassedRow passed = passedRow(row, m_lastRequest);
    if (m_isPolling && passed.isPoll())
        return;
    const esc::ExplainOptions explain = m_access.explainOptions();
    if (m_call.arguments.has("--json"))
        m_call.terminal.print(
            QString::fromUtf8(QJsonDocument(rowJson(passed, explain)).toJson(QJsonDocument::Compact)) +
            u'\n');
    else
        m_call.terminal.print(terminalRow(passed, explain));
}

// A user may go on; a script ends at the first error.
bool TypedCall::fail(const Complaint &complaint)
{
    if (isAnswered()) {
        m_call.terminal.complain(complaint.text);
        return m_access.isConnected();
    }
    m_complaint = complaint;
    return false;
}

// What was typed is not sent.
bool TypedCall::cancel()
{
    m_complaint = aboutCancelling();
    return false;
}

bool TypedCall::take(const QString &typed)
{
    if (typed.trimmed().isEmpty())
        return true;
    const auto request = typedRequest(typed, m_access.explainOptions().fractionBits);
    if (!request)
        return fail({ExitCode::badInput, QStringLiteral("notARequest"), request.error(), {typed}});
    const auto sendable = allowed(*request);
    if (m_lines.isStopped())
        return cancel();
    if (!sendable)
        return fail(sendable.error());
    send(*sendable);
    if (m_answered && m_answered->result.answer)
        return goesOn();
    if (!wasSent())
        return fail(m_answered && m_answered->refused ? complaintAbout(*m_answered->refused)
                                                      : m_access.linkLost());
    Complaint complaint = m_access.complaint({RefusalKind::device,
                                              RefusalId::escNoAnswer,
                                              {QString::fromLatin1(request->text()), std::int64_t{1}}});
    if (esc::shapeOf(request->command).writes)
        complaint.text += u' ' + CommandLine::tr("Whether it was carried out is not known: read the value.");
    return fail(complaint);
}

Checked<AllowedRequest> TypedCall::allowed(const esc::Request &request)
{
    if (const auto reading = AllowedRequest::reading(request))
        return *reading;
    if (const auto agreed = askToWrite(request); !agreed)
        return tl::unexpected(agreed.error());
    return identified(request.to).and_then([&](const Encoders &encoders) {
        return requestConsent(m_call, encoders, request);
    });
}

Checked<void> TypedCall::askToWrite(const esc::Request &request)
{
    if (auto shown = checkWasShown(m_call); !shown)
        return shown;
    if (m_call.arguments.has("--yes"))
        return {};
    if (!isAnswered())
        return badInput("noConsent",
                        CommandLine::tr("%1 writes, and was not sent: there is nobody to ask. Add --yes."),
                        {QString::fromLatin1(request.text())});
    m_call.terminal.print(writeQuestion(request, m_access.explainOptions()) + u' ' +
                          CommandLine::tr("Send it?") +
                          QStringLiteral(" [%1] ").arg(CommandLine::tr("y/N", "answers to a question")));
    const QString typed = m_lines.next().value_or(QString()).trimmed();
    if (Terminal::isYes(typed))
        return {};
    return badInput("declined", CommandLine::tr("Nothing was sent."));
}

// Whose EEPROM it may be, each with its serial number, by which its writes are counted.
Checked<Encoders> TypedCall::identified(EscLineAddress address)
{
    constexpr Instant longestPoll = 50ms; // one that is under way
    const QScopedValueRollback polling(m_isPolling, true);
    m_line.setRunning(true);
    const auto known = address.isMaster() ? contactEverybody() : contact(address);
    m_line.setRunning(false);
    m_access.advance(longestPoll);
    if (!known)
        return tl::unexpected(known.error());
    Encoders encoders;
    for (const Place place : m_line.places())
        if (const EscLineAddress its = EscLineAddress::of(place.node);
            its == address || its.isMaster() || address.isMaster())
            encoders.push_back(m_line.encoder(place));
    return encoders;
}

// It may be silent.
Checked<void> TypedCall::contact(EscLineAddress address)
{
    const auto device = deviceOnLine(m_call, m_line.placeOf(address.node()));
    if (address.isDevice() && device)
        static_cast<void>(m_access.encoder(address, *device));
    return {};
}

// At the master address: the encoders of the project; without one, whoever is alone there.
Checked<void> TypedCall::contactEverybody()
{
    const auto planned = m_call.project != nullptr ? devicesOn(*m_call.project, m_line.id())
                                                   : std::span<const ProjectDevice>();
    for (const ProjectDevice &encoder : planned)
        if (auto there = m_access.contact(m_call, encoder); !there)
            return there;
    return planned.empty() ? contactWhoIsAlone() : Checked<void>();
}

// That a different one was asked for before does not mean that it is alone.
Checked<void> TypedCall::contactWhoIsAlone()
{
    const auto forgetAll = [this] {
        for (const Place place : m_line.places())
            static_cast<void>(m_line.remove(place));
    };
    forgetAll();
    const EscLineAddress address = EscLineAddress::master();
    const auto alone = deviceOnLine(m_call, m_line.placeOf(address.node())).and_then([&](const QString &key) {
        return m_access.encoder(address, key);
    });
    if (alone)
        return {};
    forgetAll();
    return tl::unexpected(m_access.isConnected() ? aboutNobodyKnown() : m_access.linkLost());
}

void TypedCall::send(const AllowedRequest &request)
{
    m_answered.reset();
    const bool writes = esc::shapeOf(request.request().command).writes;
    if (writes)
        m_line.setOperate(true);
    m_line.send(request.request());
    bool isConnected = true;
    while (!m_answered && isConnected)
        isConnected = m_access.advance(m_access.lookInterval());
    if (!writes)
        return;
    m_line.setOperate(false);
    if (wasSent())
        m_written.push_back(
            {QString::fromLatin1(request.request().text()), m_answered->result.answer.has_value()});
}

QString TypedCall::whatWasDone() const
{
    QString text;
    for (const Written &one : m_written)
        text += sentence(one.isAnswered ? CommandLine::tr("%1 was sent, and answered.")
                                        : CommandLine::tr("%1 was sent: whether it was carried out is not "
                                                          "known."),
                         {one.request}) +
                u'\n';
    return text;
}

Answer TypedCall::answer() const
{
    const EscLineFigures &figures = m_line.latest().figures;
    return {.text = {},
            .json = {{QStringLiteral("port"), m_access.portKey()},
                     {QStringLiteral("figures"), figuresJson(figures)}},
            .done = whatWasDone(),
            .complaint = m_complaint};
}

void takeAll(TypedCall &typed, const QStringList &requests)
{
    for (const QString &request : requests)
        if (!typed.take(request))
            return;
}

// On a simulated line no time passes while nobody types.
void takeTyped(const EscLineAccess &access, TypedCall &typed)
{
    const auto meanwhile =
        access.link().isSimulated() ? std::function<bool()>() : [&typed] { return typed.listen(); };
    while (const auto line = typed.lines().next(meanwhile))
        if (!typed.take(*line))
            return;
}

Checked<Answer> runTerminal(const Call &call)
{
    const auto bus = busMeant(call, QString::fromLatin1(escKind));
    if (!bus)
        return tl::unexpected(bus.error());
    auto &line = static_cast<EscLineAccess &>(**bus); // of its kind
    if (const auto device = deviceOnLine(call, line.line().placeOf(EscLineAddress::master().node())); !device)
        return tl::unexpected(device.error());
    if (const auto opened = line.open(); !opened)
        return tl::unexpected(opened.error());
    TypedCall typed(call, line);
    if (!call.arguments.rest.isEmpty())
        takeAll(typed, call.arguments.rest);
    else
        takeTyped(line, typed);
    Answer answer = typed.answer();
    addBus(answer.json, line);
    if (!answer.complaint && !line.isConnected())
        answer.complaint = line.linkLost();
    return answer;
}

} // namespace

const Subcommand terminalCommand{
    .name = "terminal",
    .usage = "[REQUEST...] [--bus BUS] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "send typed requests over a serial line"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Sends each REQUEST once: the address as two hexadecimal digits, the command, and the data of a\n"
        "write, as 05P or 03GP5200. Without one, requests are read from standard input, a line each, until\n"
        "its end (Ctrl+D). What passes both ways is printed with its time, as text, as bytes, and in words;\n"
        "with --json as one object in each line. No position is polled.\n"
        "\n"
        "What writes is asked for first; where nobody can be asked, --yes is needed. In a pipe the first\n"
        "request that is wrong, not answered, or refused for want of --yes is the last."),
    .examples = terminalExamples,
    .options = terminalOptions,
    .arguments = {0, ArgumentCount::any},
    .needsBus = true,
    .answersInLines = true,
    .textIsAccount = true,
    .run = runTerminal,
};

} // namespace codewheel
