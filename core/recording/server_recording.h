// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_sender.h"
#include "recording/recording_writer.h"
#include "recording/unsent_file.h"

namespace codewheel {

// A recording on a PostgreSQL server. It is written to a file on this computer first, as any other, and a
// thread sends on what comes into that file; while the server is away it waits there. What a program could
// not send before it ended is sent by the next one that records to the same server.
class ServerRecording final : public RecordingTarget
{
public:
    // How long end() goes on sending.
    static constexpr std::chrono::seconds longestEnd{10};

    // What the server refuses is refused; a server that cannot be reached is waited for.
    static Result<std::unique_ptr<ServerRecording>> begin(const RecordingSettings &settings);
    ~ServerRecording() override;

    void add(RecordingEntry entry) override { m_writer->add(std::move(entry)); }
    void flush() override;
    RecordingStatus status() const override;
    // If not all could be sent, the problem says how much waits where.
    RecordingStatus end() override;

private:
    using Clock = std::chrono::steady_clock;

    ServerRecording(QString folder, ServerAddress address, std::unique_ptr<UnsentFile> file,
                    std::unique_ptr<RecordingWriter> writer, const std::optional<Refusal> &away);

    void run(const std::stop_token &stop);
    bool sendOwn(RecordingSender &sender, const std::stop_token &stop);
    bool sendLeftOver();
    void tell(const RecordingSender &sender, const Result<RecordingSender::Sent> &sent);
    void wait(const std::stop_token &stop, int failures);
    bool mayGoOn(const std::stop_token &stop) const;

    const QString m_folder;
    const ServerAddress m_address; // with the name of the recording
    std::unique_ptr<UnsentFile> m_file;
    std::unique_ptr<RecordingWriter> m_writer;

    // Shared by the threads.
    mutable std::mutex m_mutex;
    std::condition_variable_any m_wanted;
    std::condition_variable m_done;
    std::uint64_t m_begunRounds = 0;
    std::uint64_t m_doneRounds = 0;
    bool m_mustSend = false;
    bool m_hasSentAll = false;
    bool m_hasEnded = false;
    Clock::time_point m_endBy = Clock::time_point::max();
    ServerStatus m_server;
    Clock::time_point m_connectedOrNotSince = Clock::now();
    std::optional<Refusal> m_problem;
    std::optional<Refusal> m_leftOverProblem;

    // Used by the sending thread only.
    std::unique_ptr<UnsentFile> m_leftOver;
    std::unique_ptr<RecordingSender> m_leftOverSender;
    QStringList m_brokenFiles;

    std::jthread m_thread; // last, so that it is destroyed first
};

} // namespace codewheel
