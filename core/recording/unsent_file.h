// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/server_address.h"
#include "vocabulary/instant.h"

#include <QLockFile>
#include <QStringList>

#include <memory>

namespace codewheel {

// A recording file with what a server has yet to get. Only the program that has it locked sends it; the
// system unlocks it however that program ends. It lies in a folder of its server, and has the name that the
// recording has there.
class UnsentFile
{
public:
    // The files of this user.
    static QString usualFolder();
    // The name is new, the file is not made as yet. Nothing: the folder cannot be written to.
    static std::unique_ptr<UnsentFile> forNew(const QString &folder, const ServerAddress &server,
                                              Instant begun);
    // The oldest one that a program left. Nothing: there is none but those named and those being sent.
    static std::unique_ptr<UnsentFile> leftOver(const QString &folder, const ServerAddress &server,
                                                const QStringList &except);

    const QString &path() const { return m_path; }
    QString recording() const; // its name on the server
    void remove();             // all has been sent

private:
    explicit UnsentFile(const QString &path);
    bool isLocked() { return m_lock.tryLock(0); }

    QString m_path;
    QLockFile m_lock;
};

} // namespace codewheel
