// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/ledger_keeper.h"
#include "report/report.h"
#include "vocabulary/message.h"

#include <QObject>

class QWidget;

namespace codewheel {

class Buses;
class Catalog;
class InlineMessage;
class ProjectDocument;

// File > Commissioning report: saves the report of the open project, with what is known of the connected
// encoders, as a PDF or a web page. Sends nothing. Failures are reported inline.
class ReportExport : public QObject
{
    Q_OBJECT

public:
    // All must outlive it; the notice is part of the window.
    ReportExport(QWidget &window, const ProjectDocument &document, const Buses &buses, const Catalog &catalog,
                 FindLedgers ledgers, InlineMessage &notice);

    Report report() const; // as of now
    void preview();        // then asks where to save it, if it is to be saved
    void askWhere();
    // Replaces any existing file. False: it was not saved, and says why.
    bool saveTo(const QString &path);

Q_SIGNALS:
    void told(const codewheel::Message &message);

private:
    QString proposedPath() const;
    void openSaved();

    QWidget &m_window;
    const ProjectDocument &m_document;
    const Buses &m_buses;
    const Catalog &m_catalog;
    const FindLedgers m_ledgers;
    InlineMessage &m_notice;
    QString m_saved; // the last one
    QString m_told;  // the notice about it
};

} // namespace codewheel
