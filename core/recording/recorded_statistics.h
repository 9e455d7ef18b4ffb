// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/history.h"
#include "recording/recorded_key.h"

#include <QObject>

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace codewheel {

// Statistics of spans of a recording that take seconds, in a thread of their own. Of each channel the newest
// question counts.
class RecordedStatistics : public QObject
{
    Q_OBJECT

public:
    explicit RecordedStatistics(QString file);

    // Nothing: they are not known as yet, or nothing is known of the span.
    std::optional<History::Statistics> of(const RecordedKey &key, const TimeSpan &span);
    void forget(); // there is more in the file

Q_SIGNALS:
    void ready();

private:
    struct Question
    {
        TimeSpan span{};
        bool isAnswered = false;
        std::optional<History::Statistics> answer{};
    };

    void run(const std::stop_token &stop);
    std::optional<std::pair<RecordedKey, TimeSpan>> next(const std::stop_token &stop);

    const QString m_file;
    std::mutex m_mutex;
    std::condition_variable_any m_asked;
    std::map<RecordedKey, Question> m_questions;
    std::jthread m_thread; // last, so that it is destroyed first
};

} // namespace codewheel
