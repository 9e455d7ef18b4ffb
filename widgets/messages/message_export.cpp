// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_export.h"

#include "project/file_access.h"
#include "widgets/messages/message_model.h"

namespace codewheel {
namespace {

constexpr qint64 piece = 1'000; // messages, some 10 ms

} // namespace

MessageExport::MessageExport(const MessageModel &messages, const QString &fileName,
                             MessageWriter::Format format, QObject *parent)
    : QObject(parent)
    , m_messages(messages)
    , m_ids(messages.ids())
    , m_file(fileName)
    , m_writer(m_file, format, &messages.busNames())
{
    connect(&m_timer, &QTimer::timeout, this, &MessageExport::writePiece);
    m_timer.start(0);
}

// A failure to write is reported when the file is replaced.
void MessageExport::writePiece()
{
    if (!m_file.isOpen()) {
        if (const auto begun = m_file.begin(); !begun)
            return end(begun);
        m_writer.begin();
    }
    std::vector<qint64> ids;
    for (; std::ssize(ids) < piece && m_next < m_ids.size(); ++m_next)
        ids.push_back(m_ids.at(m_next));
    std::vector<StoredMessage> messages = m_messages.read(ids);
    std::erase_if(messages, [](const StoredMessage &message) { return message.id == 0; });
    if (m_writer.write(messages) && m_next < m_ids.size()) {
        Q_EMIT progressed(static_cast<double>(m_next) / static_cast<double>(m_ids.size()));
        return;
    }
    m_writer.end();
    end(m_file.replace());
}

void MessageExport::end(const Result<void> &written)
{
    m_timer.stop();
    Q_EMIT ended(written ? QString() : whyNotWritten(written.error()));
}

} // namespace codewheel
