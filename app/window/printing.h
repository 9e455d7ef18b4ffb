// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QAbstractItemView;
class QPrinter;
class QWidget;

namespace codewheel {

class ReportExport;

// File > Print: the table that has the focus, or that is seen beside it; elsewhere the commissioning report.
// A preview shows it first.
class Printing : public QObject
{
    Q_OBJECT

public:
    // Both outlive it.
    Printing(QWidget &window, const ReportExport &report);

    void preview();
    void print(QPrinter &printer) const; // what the preview shows

private:
    QWidget &m_window;
    const ReportExport &m_report;
    QPointer<const QAbstractItemView> m_table; // null: the report
};

} // namespace codewheel
