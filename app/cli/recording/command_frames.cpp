// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_log_reader.h"
#include "can/can_log_writer.h"
#include "can/frame_meaning.h"
#include "cli/call/json_list.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/recording/frame_rows.h"
#include "cli/recording/log_source.h"
#include "project/file_replacement.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace codewheel {
namespace {

constexpr const char *framesExamples[] = {"frames candump.log", "frames trace.asc --json",
                                          "frames screen.txt --times differences",
                                          "frames trace.asc --save trace.log"};

constexpr std::array framesOptions{
    Option{
        "--times", "absolute|relative|differences",
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "what the times of the log are, if it is taken for something else: since 1970 or "
                          "its date, from its beginning, or each from the line before")},
    Option{"--save", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "write the frames to FILE as well, as candump -L does, for other programs")},
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "replace FILE if it is there")},
};

constexpr CanLogTimes allTimes[] = {CanLogTimes::absolute, CanLogTimes::relative, CanLogTimes::differences};

constexpr qsizetype portion = 65'536; // of text printed at once

Checked<std::optional<CanLogTimes>> timesMeant(const Arguments &arguments)
{
    const auto given = arguments.value("--times");
    if (!given)
        return std::nullopt;
    const auto found = std::ranges::find(allTimes, *given, timesKey);
    if (found != std::end(allTimes))
        return *found;
    return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                    {QStringLiteral("--times"), *given, listed(allTimes, timesKey)});
}

struct Note
{
    std::int64_t line;
    CanLogFault fault;
};

// Prints the frames of a log as they are read, saves them where a file was named, and keeps what is to be
// said of it.
class FramesOfLog
{
public:
    FramesOfLog(const Call &call, std::optional<CanLogTimes> meant, FileReplacement *saved)
        : m_terminal(call.terminal)
        , m_meant(meant)
        , m_saved(saved)
        , m_list(call.arguments.has("--json")
                     ? std::make_unique<JsonList>(call.terminal, QStringLiteral("frames"))
                     : nullptr)
        , m_reader([this](const CanFrame &frame) { take(frame); },
                   [this](std::int64_t line, CanLogFault fault) { note(line, fault); }, meant)
    {}

    CanLogReader &reader() { return m_reader; }
    void show(); // all rows so far
    void end();  // of the rows
    QJsonObject json() const;
    void complain() const;

private:
    void take(const CanFrame &frame);
    void print(const CanFrame &frame);
    QString meaningOf(const CanFrame &frame);
    void tellApart(const CanFrame &frame);
    void note(std::int64_t line, CanLogFault fault);
    std::size_t left() const { return m_faults - m_notes.size(); }

    const Terminal &m_terminal;
    std::optional<CanLogTimes> m_meant;
    FileReplacement *m_saved;         // null: none was named
    std::unique_ptr<JsonList> m_list; // null: rows of text
    TextTable m_rows;
    QString m_text;                                     // to be printed in one go
    std::map<std::string, CanFrameMeanings> m_meanings; // by interface
    std::string m_interface;                            // of the first frame
    bool m_hasInterfaces = false;                       // there are others: the rows tell which
    std::vector<Note> m_notes;
    std::size_t m_faults = 0;
    CanLogReader m_reader;
};

void FramesOfLog::take(const CanFrame &frame)
{
    if (m_saved != nullptr)
        m_saved->write(QByteArray::fromStdString(canLogLine(frame)));
    print(frame);
}

void FramesOfLog::print(const CanFrame &frame)
{
    const QString meaning = meaningOf(frame);
    if (m_list) {
        m_list->add(frameJson(frame, meaning));
        return;
    }
    tellApart(frame);
    QStringList cells = frameCells(frame, meaning, m_reader.isSince1970());
    if (m_hasInterfaces)
        cells.insert(1, QString::fromStdString(frame.interface));
    m_text += m_rows.next(cells);
    if (m_text.size() >= portion)
        show();
}

// Interfaces are buses of their own; a log of nonsense may have any number of them.
QString FramesOfLog::meaningOf(const CanFrame &frame)
{
    constexpr std::size_t mostInterfaces = 100;
    const auto known = m_meanings.find(frame.interface);
    if (known != m_meanings.end())
        return known->second.next(frame)();
    return m_meanings[m_meanings.size() < mostInterfaces ? frame.interface : std::string()].next(frame)();
}

void FramesOfLog::tellApart(const CanFrame &frame)
{
    if (m_interface.empty())
        m_interface = frame.interface;
    if (m_hasInterfaces || frame.interface == m_interface)
        return;
    m_hasInterfaces = true;
    m_rows = TextTable();
}

void FramesOfLog::note(std::int64_t line, CanLogFault fault)
{
    constexpr std::size_t mostNotes = 1'000; // kept; the others are counted
    ++m_faults;
    if (m_notes.size() < mostNotes)
        m_notes.push_back({line, fault});
}

void FramesOfLog::show()
{
    if (!m_text.isEmpty())
        m_terminal.print(std::exchange(m_text, {}));
}

void FramesOfLog::end()
{
    m_list.reset();
    show();
    std::ranges::stable_sort(m_notes, {}, &Note::line);
}

QJsonObject FramesOfLog::json() const
{
    QJsonArray notes;
    for (const Note &note : m_notes)
        notes.append(QJsonObject{{QStringLiteral("line"), static_cast<qint64>(note.line)},
                                 {QStringLiteral("reason"), canLogFaultText(note.fault)}});
    const auto times = m_reader.times();
    const QString since = m_reader.isSince1970() ? QStringLiteral("1970") : QStringLiteral("first");
    return {{QStringLiteral("count"), static_cast<qint64>(m_reader.frames())},
            {QStringLiteral("canFd"), static_cast<qint64>(m_reader.canFdFrames())},
            {QStringLiteral("times"), times ? QJsonValue(timesKey(*times)) : QJsonValue()},
            {QStringLiteral("since"), times ? QJsonValue(since) : QJsonValue()},
            {QStringLiteral("notes"), notes},
            {QStringLiteral("moreNotes"), static_cast<qint64>(left())}};
}

// Beside the rows, so that these can be passed on to other programs.
void FramesOfLog::complain() const
{
    constexpr std::size_t mostShown = 20;
    const std::size_t shown = std::min(mostShown, m_notes.size());
    for (std::size_t i = 0; i < shown; ++i)
        m_terminal.complain(sentence(CommandLine::tr("Line %1: %2"),
                                     {QString::number(m_notes[i].line), canLogFaultText(m_notes[i].fault)}));
    if (m_faults > shown)
        m_terminal.complain(sentence(CommandLine::tr("Further lines that were not read: %1"),
                                     {numberText(static_cast<std::int64_t>(m_faults - shown))}));
    if (m_reader.canFdFrames() > 0)
        m_terminal.complain(
            sentence(CommandLine::tr("CAN FD frames: %1"), {numberText(m_reader.canFdFrames())}));
    if (const QString times = timesText(m_reader.times(), m_reader.isSince1970()); !times.isEmpty())
        m_terminal.complain(times);
    if (m_meant && m_reader.times() && *m_meant != *m_reader.times())
        m_terminal.complain(
            sentence(CommandLine::tr("--times %1 does not fit this log, and is left out of account."),
                     {timesKey(*m_meant)}));
}

Complaint aboutSource(const LogSource &source)
{
    return complaintAbout(
        {RefusalKind::badInput, RefusalId::fileNotReadable, {source.path(), source.error()}});
}

// How the reading ended. hasMore: nobody looks at the rows any longer; with `toItsEnd` it goes on all the
// same.
LogSource::State readAll(LogSource &source, FramesOfLog &frames, const Terminal &terminal, bool toItsEnd)
{
    using State = LogSource::State;
    State state = State::hasMore;
    while (toItsEnd || terminal.canPrint()) {
        state = source.read();
        if (state == State::isEmpty) {
            frames.show();
            state = source.wait();
        } else if (state == State::hasMore) {
            frames.reader().read(source.bytes());
        }
        if (state != State::hasMore && state != State::isEmpty)
            break;
    }
    return state;
}

// What is to be said of how it ended.
std::optional<Complaint> complaintAfter(LogSource::State state, const LogSource &source,
                                        const CanLogReader &reader)
{
    if (state == LogSource::State::wasStopped)
        return notDone("framesCancelled", CommandLine::tr("This was cancelled before the end of the log."));
    if (state == LogSource::State::failed)
        return aboutSource(source);
    if (state != LogSource::State::isAtEnd || reader.frames() > 0)
        return std::nullopt;
    return notDone("noFrames", sentence(CommandLine::tr("There is no CAN frame in %1."), {source.path()}),
                   {source.path()});
}

Checked<void> checkNames(const Arguments &arguments)
{
    if (arguments.rest.front().isEmpty())
        return badInput("missingFile", CommandLine::tr("Name the file of the log."));
    const auto saved = arguments.value("--save");
    if (saved && saved->isEmpty())
        return badInput("missingFile", CommandLine::tr("Name the file to save the frames in: --save FILE."));
    return {};
}

bool areOneFile(const QString &one, const QString &other)
{
    const QString path = QFileInfo(one).canonicalFilePath();
    return !path.isEmpty() && path == QFileInfo(other).canonicalFilePath();
}

// Empty: none was named.
Checked<std::unique_ptr<FileReplacement>> fileToSave(const Arguments &arguments)
{
    const auto path = arguments.value("--save");
    if (!path)
        return nullptr;
    if (areOneFile(*path, arguments.rest.front()))
        return badInput("fileExists",
                        CommandLine::tr("%1 is the log itself. Nothing was saved. Name another file."),
                        {*path});
    if (const auto can = checkTargetFile(arguments, *path); !can)
        return tl::unexpected(can.error());
    auto file = std::make_unique<FileReplacement>(*path);
    if (const auto begun = file->begin(); !begun)
        return tl::unexpected(complaintAbout(begun.error()));
    return file;
}

// Only the whole of it.
std::optional<Complaint> save(FileReplacement &file, const CanLogReader &reader, const Terminal &terminal,
                              bool asJson)
{
    if (!reader.times())
        return notDone("noTimes",
                       CommandLine::tr("The log has no times, and a log of candump needs them. Nothing was "
                                       "saved."));
    if (const auto saved = file.replace(); !saved)
        return complaintAbout(saved.error());
    if (!asJson)
        terminal.complain(sentence(CommandLine::tr("Saved in %1."), {file.path()}));
    return std::nullopt;
}

Checked<Answer> runFrames(const Call &call)
{
    const auto meant = timesMeant(call.arguments);
    if (!meant)
        return tl::unexpected(meant.error());
    if (const auto named = checkNames(call.arguments); !named)
        return tl::unexpected(named.error());
    LogSource source(call.arguments.rest.front());
    if (!source.isOpen())
        return tl::unexpected(aboutSource(source));
    const auto saved = fileToSave(call.arguments);
    if (!saved)
        return tl::unexpected(saved.error());
    FramesOfLog frames(call, *meant, saved->get());
    const auto ended = readAll(source, frames, call.terminal, *saved != nullptr);
    if (ended == LogSource::State::isAtEnd)
        frames.reader().finish();
    else
        frames.reader().breakOff();
    frames.end();
    const bool asJson = call.arguments.has("--json");
    if (!asJson)
        frames.complain();
    auto complaint = complaintAfter(ended, source, frames.reader());
    if (!complaint && *saved != nullptr)
        complaint = save(**saved, frames.reader(), call.terminal, asJson);
    return Answer{.json = frames.json(), .hasBegunJson = asJson, .complaint = complaint};
}

} // namespace

const Subcommand framesCommand{
    .name = "frames",
    .usage = "FILE [--times absolute|relative|differences] [--save FILE] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "list the CAN frames of a log, and what they say"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Reads logs of candump, in its log format or as on its screen, and asc files of Vector's programs, "
        "log2asc\nand BUSMASTER, and prints a row for each frame: time, identifier, data, and what it says "
        "in "
        "CANopen.\nIt says what the times of the log are (--times corrects it), and which lines it has not "
        "read. A log\nof any length is read piece by piece.\n\nNeeds no bus and sends nothing."),
    .examples = framesExamples,
    .options = framesOptions,
    .arguments = {1},
    .run = runFrames,
};

} // namespace codewheel
