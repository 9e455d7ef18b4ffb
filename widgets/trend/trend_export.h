// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "trend/trend_files.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace codewheel {

// Writes a part of a trend to files, a piece at a time, so that the window stays responsive. They appear once
// they are complete; destroyed before, it leaves nothing behind.
class TrendExport : public QObject
{
    Q_OBJECT

public:
    using Origin = std::function<TrendOrigin()>; // at the end, when all that is written has happened

    TrendExport(std::unique_ptr<TrendFiles> files, Origin origin, QObject *parent);

    const TrendFiles &files() const { return *m_files; }

Q_SIGNALS:
    void progressed(int percent);
    void ended(const QString &failure); // why it was not written; empty: it was. Can be used only once

private:
    void writePiece();
    void end(const Result<void> &written);

    std::unique_ptr<TrendFiles> m_files;
    Origin m_origin;
    bool m_isBegun = false;
    QTimer m_timer;
};

} // namespace codewheel
