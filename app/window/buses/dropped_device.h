// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace codewheel {

class InlineMessage;

// A device description dropped onto the window: checked as at a start, and on request kept with the user's
// own. Descriptions are read only at the start, since encoders rely on them.
class DroppedDevice : public QObject
{
    Q_OBJECT

public:
    // The notice is part of the window and used by nothing else.
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
