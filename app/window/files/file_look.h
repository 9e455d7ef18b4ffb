// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/start/recent_file.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>

namespace codewheel {

// Checks whether files exist, each in a thread of its own: an unreachable network folder may take minutes to
// answer, and neither the window nor the end of the program waits for it.
class FileLook : public QObject
{
    Q_OBJECT

public:
    explicit FileLook(QObject *parent = nullptr);
    ~FileLook() override;

    // As far as known: unknown at first, silent after a while without an answer.
    RecentFile::State state(const QString &path) const;
    // Checks again, unless a check is under way.
    void look(const QString &path);

Q_SIGNALS:
    void changed(); // state() of any path
    void hasMail(); // from a thread that has looked

private:
    struct Mail;
    void takeMail();
    void callSilent();

    std::shared_ptr<Mail> m_mail;
    std::map<QString, RecentFile::State> m_states;
    std::map<QString, RecentFile::State> m_pending; // the previous states
    QTimer m_patience;
};

} // namespace codewheel
