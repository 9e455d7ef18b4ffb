// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

class InlineMessage;

// A device description that was dropped onto the window: looked at as at a start, and kept with the user's
// own if that is wanted. Descriptions are read at the start alone, since encoders go by those there are.
class DroppedDevice : public QObject
{
    Q_OBJECT

public:
    // The notice stands in the window and is this one's alone.
    DroppedDevice(InlineMessage &notice, QString folder, QObject *parent = nullptr);

    void offer(const QString &path);

private:
    QString keptAs(const QString &path) const;
    void keep();

    InlineMessage &m_notice;
    const QString m_folder;
    QString m_path;
};

} // namespace codewheel
