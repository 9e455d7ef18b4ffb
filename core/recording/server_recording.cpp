// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/server_recording.h"

#include "journal/journal_texts.h"
#include "recording/server_texts.h"

namespace codewheel {
namespace {

constexpr int triesAtEnd = 2;   // the connection may be lost, and the server there
constexpr int longestPause = 4; // 2^4 seconds

Stored<void> reach(const ServerAddress &address)
{
    return PostgresDatabase::connect(address).and_then(
        [&](const auto &server) { return server->useRecording(address.recording); });
}

} // namespace

Result<std::unique_ptr<ServerRecording>> ServerRecording::begin(const RecordingSettings &settings)
{
    const auto address = ServerAddress::parse(settings.server);
    if (!address)
        return tl::unexpected(address.error());
    if (settings.largestSize > 0)
        return refuse(RefusalKind::badInput, RefusalId::noSizeOnServer);
    const QString folder =
        settings.unsentFolder.isEmpty() ? UnsentFile::usualFolder() : settings.unsentFolder;
    auto file = UnsentFile::forNew(folder, *address, settings.begun);
    if (!file)
        return refuse(RefusalKind::link, RefusalId::databaseFailed,
                      {folder, Journal::tr("it is not writable.")});
    RecordingSettings local = settings;
    local.file = file->path();
    auto writer = RecordingWriter::begin(local);
    if (!writer)
        return tl::unexpected(writer.error());
    const ServerAddress named = address->withRecording(file->recording());
    const auto reached = reach(named);
    if (!reached && reached.error().kind != DatabaseError::Kind::away) {
        (void)(*writer)->end();
        file->remove();
        return refuse(RefusalKind::link, RefusalId::databaseFailed, {named.place(), reached.error().reason});
    }
    const auto away =
        reached ? std::nullopt : std::optional(RecordingSender::awayRefusal(named, reached.error(), 0));
    return std::unique_ptr<ServerRecording>(
        new ServerRecording(folder, named, std::move(file), std::move(*writer), away));
}

ServerRecording::ServerRecording(QString folder, ServerAddress address, std::unique_ptr<UnsentFile> file,
                                 std::unique_ptr<RecordingWriter> writer, const std::optional<Refusal> &away)
    : m_folder(std::move(folder))
    , m_address(std::move(address))
    , m_file(std::move(file))
    , m_writer(std::move(writer))
    , m_server{.address = m_address.text(), .isConnected = !away}
    , m_problem(away)
    , m_thread([this](const std::stop_token &stop) { run(stop); })
{}

ServerRecording::~ServerRecording()
{
    (void)ServerRecording::end();
}

void ServerRecording::flush()
{
    m_writer->flush();
    std::unique_lock lock(m_mutex);
    m_mustSend = true;
    m_wanted.notify_one();
    m_done.wait(lock, [this, wanted = m_begunRounds + 1] { return m_doneRounds >= wanted || m_hasEnded; });
}

RecordingStatus ServerRecording::status() const
{
    RecordingStatus status = m_writer->status();
    const std::lock_guard lock(m_mutex);
    status.server = m_server;
    status.server->lasts =
        std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - m_connectedOrNotSince);
    for (const std::optional<Refusal> &problem : {m_problem, m_leftOverProblem})
        if (!status.problem)
            status.problem = problem;
    return status;
}

RecordingStatus ServerRecording::end()
{
    if (!m_thread.joinable())
        return status();
    (void)m_writer->end();
    {
        const std::lock_guard lock(m_mutex);
        m_endBy = Clock::now() + longestEnd;
    }
    m_thread.request_stop();
    m_thread.join();
    {
        const std::lock_guard lock(m_mutex);
        m_hasEnded = true;
        m_done.notify_all();
        if (m_hasSentAll)
            m_file->remove();
        else
            m_problem = Refusal{RefusalKind::link,
                                RefusalId::notAllSent,
                                {m_address.place(),
                                 m_problem ? m_problem->arguments.at(1)
                                           : RefusalArgument(Server::tr("sending it takes longer.")),
                                 RecordingSender::megabytes(m_server.waitingBytes), m_file->path()}};
    }
    m_file.reset(); // whoever records next may send it
    return status();
}

void ServerRecording::run(const std::stop_token &stop)
{
    RecordingSender own(m_file->path(), m_address);
    int failures = 0; // one after the other
    while (true) {
        const bool isLast = stop.stop_requested(); // all has come into the file
        {
            const std::lock_guard lock(m_mutex);
            ++m_begunRounds;
            m_mustSend = false;
        }
        const bool hasSent = sendOwn(own, stop);
        failures = hasSent ? 0 : failures + 1;
        {
            const std::lock_guard lock(m_mutex);
            m_doneRounds = m_begunRounds;
            m_hasSentAll = isLast && hasSent;
            m_done.notify_all();
        }
        if (isLast && (hasSent || !mayGoOn(stop) || failures >= triesAtEnd))
            return;
        if (isLast || !hasSent || !sendLeftOver())
            wait(stop, failures);
    }
}

bool ServerRecording::mayGoOn(const std::stop_token &stop) const
{
    const std::lock_guard lock(m_mutex);
    return !stop.stop_requested() || Clock::now() < m_endBy;
}

// Whether all that was in the file has arrived.
bool ServerRecording::sendOwn(RecordingSender &sender, const std::stop_token &stop)
{
    while (true) {
        const auto sent = sender.send();
        tell(sender, sent);
        if (!sent || *sent == RecordingSender::Sent::all)
            return sent.has_value();
        if (!mayGoOn(stop))
            return false;
    }
}

// A piece of what another program left; whether there may be more.
bool ServerRecording::sendLeftOver()
{
    if (!m_leftOver) {
        m_leftOver = UnsentFile::leftOver(m_folder, m_address, m_brokenFiles);
        if (!m_leftOver)
            return false;
        m_leftOverSender = std::make_unique<RecordingSender>(
            m_leftOver->path(), m_address.withRecording(m_leftOver->recording()));
    }
    const auto sent = m_leftOverSender->send();
    if (sent && *sent == RecordingSender::Sent::some)
        return true;
    m_leftOverSender.reset();
    if (sent)
        m_leftOver->remove();
    else if (sent.error().id == RefusalId::databaseFailed) {
        m_brokenFiles << m_leftOver->path();
        const std::lock_guard lock(m_mutex);
        m_leftOverProblem = sent.error();
    }
    m_leftOver.reset();
    return sent.has_value();
}

void ServerRecording::tell(const RecordingSender &sender, const Result<RecordingSender::Sent> &sent)
{
    const bool hasAll = sent && *sent == RecordingSender::Sent::all;
    const std::int64_t waiting = hasAll ? 0 : sender.waitingBytes();
    const std::lock_guard lock(m_mutex);
    if (std::exchange(m_server.isConnected, sender.isConnected()) != sender.isConnected())
        m_connectedOrNotSince = Clock::now();
    m_server.waitingBytes = waiting;
    m_problem = sent ? std::nullopt : std::optional(sent.error());
}

// A server that refuses is asked less and less often.
void ServerRecording::wait(const std::stop_token &stop, int failures)
{
    const int pauses = 1 << std::min(failures, longestPause);
    std::unique_lock lock(m_mutex);
    m_wanted.wait_for(lock, stop, RecordingWriter::gathering * pauses, [this] { return m_mustSend; });
}

} // namespace codewheel
