// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/report_preview.h"

#include "app/window/paper/printed_report.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"

#include <QDialogButtonBox>
#include <QPrintDialog>
#include <QPrintPreviewWidget>
#include <QPushButton>

namespace codewheel {
namespace {

constexpr QSize sizeOfSheets(900, 700);

} // namespace

ReportPreview::ReportPreview(Report report, QWidget *parent)
    : QDialog(parent)
    , m_report(std::move(report))
    , m_sheets(nullptr)
{
    setObjectName(QStringLiteral("reportPreview"));
    setWindowTitle(m_report.title);
    setHelpTopic(*this, "report.md");
    m_printer.setPageSize(QPageSize(QPageSize::A4));
    m_printer.setDocName(m_report.title);
    m_sheets = describe(new QPrintPreviewWidget(&m_printer, this), "reportSheets", tr("Sheets of the report"),
                        tr("The report as it will be saved or printed"));
    connect(m_sheets, &QPrintPreviewWidget::paintRequested, this,
            [this](QPrinter *printer) { printReport(m_report, *printer); });
    layOutColumn(this, {{m_sheets, 1}}, {.spacing = grid::margin, .margins = allAround(grid::margin)});
    makeButtons();
    m_sheets->setZoomMode(QPrintPreviewWidget::FitToWidth);
    resize(parent == nullptr ? sizeOfSheets : sizeOfSheets.boundedTo(parent->size()));
}

int ReportPreview::sheets() const
{
    return m_sheets->pageCount();
}

void ReportPreview::makeButtons()
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    const auto add = [&](Icon icon, const QString &text, QDialogButtonBox::ButtonRole role, const char *id,
                         const QString &tip) {
        auto *button = describe(buttons->addButton(text, role), id, tip);
        button->setIcon(lineIcon(icon));
        return button;
    };
    QPushButton *save = add(Icon::exportData, tr("&Save…"), QDialogButtonBox::AcceptRole, "saveReport",
                            tr("Asks where to save it, as a PDF or a web page"));
    QPushButton *paper = add(Icon::write, tr("&Print…"), QDialogButtonBox::ActionRole, "printReport",
                             tr("Asks for the printer"));
    save->setDefault(true);
    save->setFocus();
    layout()->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(paper, &QPushButton::clicked, this, &ReportPreview::print);
}

void ReportPreview::print()
{
    QPrintDialog dialog(&m_printer, this);
    if (dialog.exec() == QDialog::Accepted)
        printReport(m_report, m_printer);
}

} // namespace codewheel
