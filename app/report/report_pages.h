// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/page_cuts.h"
#include "report/report.h"

#include <QImage>
#include <QTextDocument>

#include <memory>

class QPainter;

namespace codewheel {

// The report on A4 sheets, each with a header and a numbered footer. Needs fonts, and so a QGuiApplication.
class ReportPages
{
public:
    explicit ReportPages(const Report &report);

    int count() const { return static_cast<int>(m_cuts.size()); }
    // In the dots of sheet_format.h, on any device.
    void paint(QPainter &painter, int page) const;

private:
    void paintPart(QPainter &painter, const QRectF &part, qreal top) const;
    void paintHeadAndFoot(QPainter &painter, int page) const;

    QString m_title;
    QString m_subject;
    QString m_origin;
    QImage m_paper; // gives the dots for font sizes
    std::unique_ptr<QTextDocument> m_document;
    std::vector<PageCut> m_cuts;
};

} // namespace codewheel
