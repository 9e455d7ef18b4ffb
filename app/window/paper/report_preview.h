// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

#include <QDialog>
#include <QPrinter>

class QPrintPreviewWidget;

namespace codewheel {

// The sheets of a report before it is saved or printed. Accepted: it is to be saved.
class ReportPreview : public QDialog
{
    Q_OBJECT

public:
    explicit ReportPreview(Report report, QWidget *parent = nullptr);

    int sheets() const;

private:
    void makeButtons();
    void print();

    const Report m_report;
    QPrinter m_printer;
    QPrintPreviewWidget *m_sheets;
};

} // namespace codewheel
