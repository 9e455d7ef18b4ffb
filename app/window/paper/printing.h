// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/printed_view.h"

#include <QDateTime>
#include <QObject>

#include <functional>

class QPrinter;

namespace codewheel {

class ReportExport;

// File > Print: prints the table that has the focus or is visible beside it; otherwise the commissioning
// report. Shows a preview first.
class Printing : public QObject
{
    Q_OBJECT

public:
    // What buses and stations are called.
    struct Names
    {
        std::function<QString(BusId)> bus;
        std::function<QString(Place)> station;
    };

    // Both outlive it.
    Printing(QWidget &window, const ReportExport &report, Names names);

    void preview();
    void print(QPrinter &printer) const; // for the preview

private:
    QString title() const;
    QString origin() const;

    QWidget &m_window;
    const ReportExport &m_report;
    Names m_names;
    std::optional<PrintedView> m_view; // as it was when the preview was asked for
    QDateTime m_when;
    QPointer<const QAbstractItemView> m_table; // neither this nor a picture: the report
};

} // namespace codewheel
