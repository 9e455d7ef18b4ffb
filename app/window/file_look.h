// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/start/recent_file.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>

namespace codewheel {

// Looks whether files are there, each in a thread of its own: a network folder that is gone may keep one
// waiting for minutes, and then neither the window nor the end of the program waits for it.
class FileLook : public QObject
{
    Q_OBJECT

public:
    explicit FileLook(QObject *parent = nullptr);
    ~FileLook() override;

    // As far as it is known: unknown at first, silent where no answer came for a while.
    RecentFile::State state(const QString &path) const;
    // Again, unless it is being looked at.
    void look(const QString &path);

Q_SIGNALS:
    void changed(); // state() of any
    void hasMail(); // from a thread that looked

private:
    struct Mail;
    void takeMail();
    void callSilent();

    std::shared_ptr<Mail> m_mail;
    std::map<QString, RecentFile::State> m_states;
    std::map<QString, RecentFile::State> m_pending; // what was known before
    QTimer m_patience;
};

} // namespace codewheel
