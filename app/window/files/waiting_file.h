// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

namespace codewheel {

class InlineMessage;

// A file that was opened or dropped while what it is for was not there, such as cams without an encoder that
// has some: it waits, until its notice is closed.
class WaitingFile : public QObject
{
    Q_OBJECT

public:
    struct Wish
    {
        std::function<bool()> isThere;
        std::function<QString(const QString &file)> sentence; // what the file is, and what to do
        QString action{};                                     // empty: none
    };

    // The notice is part of the window and used by nothing else.
    WaitingFile(InlineMessage &notice, Wish wish, QObject *parent = nullptr);

    void open(const QString &path);
    // Something has come or gone.
    void lookAgain();

Q_SIGNALS:
    void ready(const QString &path);
    void actionTriggered();

private:
    InlineMessage &m_notice;
    const Wish m_wish;
    QString m_path; // empty: none waits
};

} // namespace codewheel
