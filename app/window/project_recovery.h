// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"
#include "project/recovery.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <vector>

namespace codewheel {

class InlineMessage;
class ProjectDocument;
class ProjectFiles;

// Keeps what is not saved every 30 s, or as often as is set, and offers it at the next start where the
// program ended without asking. Outlives the window.
class ProjectRecovery : public QObject
{
    Q_OBJECT

public:
    // The document must outlive it; the folder is made when there is something to keep.
    ProjectRecovery(ProjectDocument &document, const QString &folder, QObject *parent = nullptr);
    // The program ends as it should: nothing is left to recover.
    ~ProjectRecovery() override;

    // Asks in this window, if anything was left.
    void ask(InlineMessage &notice, ProjectFiles &files);
    void setPeriod(std::chrono::seconds period);
    // Now, rather than when its time comes.
    void keep();

Q_SIGNALS:
    void told(const codewheel::Message &message);

private:
    void recover();
    void showNext();

    ProjectDocument &m_document;
    Recovery m_recovery;
    std::vector<LeftProject> m_left; // the newest first
    QTimer m_timer;
    InlineMessage *m_notice = nullptr;
    ProjectFiles *m_files = nullptr;
};

} // namespace codewheel
