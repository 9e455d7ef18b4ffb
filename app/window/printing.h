// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QAbstractItemView;
class QPrinter;
class QWidget;

namespace codewheel {

class ReportExport;

// File > Print: prints the table that has the focus or is visible beside it; otherwise the commissioning
// report. Shows a preview first.
class Printing : public QObject
{
    Q_OBJECT

public:
    // Both outlive it.
    Printing(QWidget &window, const ReportExport &report);

    void preview();
    void print(QPrinter &printer) const; // for the preview

private:
    QWidget &m_window;
    const ReportExport &m_report;
    QPointer<const QAbstractItemView> m_table; // null: the report
};

} // namespace codewheel
