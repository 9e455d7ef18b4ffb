// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/id_runs.h"
#include "journal/message_writer.h"
#include "project/file_replacement.h"

#include <QTimer>

namespace codewheel {

class MessageModel;

// Writes the messages a model shows now to a file, a piece at a time, so that the window stays responsive.
// The file appears once it is complete.
class MessageExport : public QObject
{
    Q_OBJECT

public:
    // The model outlives it.
    MessageExport(const MessageModel &messages, const QString &fileName, MessageWriter::Format format,
                  QObject *parent);

    QString fileName() const { return m_file.path(); }
    qint64 total() const { return m_ids.size(); }

Q_SIGNALS:
    void progressed(double part);       // 0..1
    void ended(const QString &failure); // why it was not written; empty: it was. Can be used only once

private:
    void writePiece();
    void end(const Result<void> &written);

    const MessageModel &m_messages;
    const IdRuns m_ids;
    FileReplacement m_file;
    MessageWriter m_writer;
    qint64 m_next = 0;
    QTimer m_timer;
};

} // namespace codewheel
