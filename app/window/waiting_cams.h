// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;

namespace codewheel {

class InlineMessage;

// A file of cams that was opened or dropped while no encoder with cams was chosen: it waits for one, until
// its notice is closed.
class WaitingCams : public QObject
{
    Q_OBJECT

public:
    // The notice is part of the window and used by nothing else; `cams` is enabled while an encoder with cams
    // is chosen.
    WaitingCams(InlineMessage &notice, const QAction &cams, QObject *parent = nullptr);

    void open(const QString &path);

Q_SIGNALS:
    void ready(const QString &path);

private:
    InlineMessage &m_notice;
    const QAction &m_cams;
    QString m_path; // empty: none waits
};

} // namespace codewheel
