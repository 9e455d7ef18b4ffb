// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/recovery.h"
#include "vocabulary/message.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <vector>

namespace codewheel {

class InlineMessage;
class ProjectDocument;
class ProjectFiles;

// Keeps unsaved changes every 30 s, or at the set interval, and offers them at the next start if the program
// ended without asking. Outlives the window.
class ProjectRecovery : public QObject
{
    Q_OBJECT

public:
    // The document must outlive it; the folder is created when there is something to keep.
    ProjectRecovery(ProjectDocument &document, const QString &folder, QObject *parent = nullptr);
    // The program is ending properly: nothing is left to recover.
    ~ProjectRecovery() override;

    // Asks in this window, if anything was left.
    void ask(InlineMessage &notice, ProjectFiles &files);
    void setPeriod(std::chrono::seconds period);
    // Now, without waiting for the timer.
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
