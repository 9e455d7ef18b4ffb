// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"

#include <QObject>

class QWidget;

namespace codewheel {

class BusSession;
class InlineMessage;
class LedgerKeeper;
class ProjectDocument;

// File > Commissioning report: saves the report of the open project, with what is known of the connected
// encoders, as a PDF or a web page. Sends nothing. What goes wrong is told inline.
class ReportExport : public QObject
{
    Q_OBJECT

public:
    // All must outlive it; notice stands in the window.
    ReportExport(QWidget &window, const ProjectDocument &document, const BusSession &bus,
                 const LedgerKeeper &ledger, InlineMessage &notice);

    void askWhere();
    // In place of a file that may be there. False: it was not saved, and says why.
    bool saveTo(const QString &path);

Q_SIGNALS:
    void told(const codewheel::Message &message);

private:
    QString proposedPath() const;

    QWidget &m_window;
    const ProjectDocument &m_document;
    const BusSession &m_bus;
    const LedgerKeeper &m_ledger;
    InlineMessage &m_notice;
};

} // namespace codewheel
