// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/report_pages.h"
#include "app/report/sheet_format.h"
#include "app/screenshots/pictures.h"
#include "app/window/kinds/training_window.h"
#include "bus/buses.h"
#include "bus/encoder_bus.h"
#include "report/live_encoders.h"
#include "report/make_report.h"

#include <QCoreApplication>
#include <QLabel>
#include <QPainter>

namespace codewheel {
namespace {

constexpr double dotsPerPixel = sheet::dotsPerInch / 84.0;
constexpr QSize sheetSize(static_cast<int>(sheet::paper.width() / dotsPerPixel),
                          static_cast<int>(sheet::paper.height() / dotsPerPixel));
constexpr int gap = 12;

Report reportOf(TrainingWindow &shown)
{
    const EncoderBus &bus = *shown.buses().connected().front();
    ReportInput input{.project = shown.project().project(),
                      .file = QStringLiteral("crane.codewheel"),
                      .version = QCoreApplication::applicationVersion(),
                      .now = bus.dateTime(bus.now())};
    input.project.title = QStringLiteral("Crane 1");
    addConnected(input, shown.buses());
    return makeReport(input, shown.catalog());
}

} // namespace

QWidget *reportOnPaper(TrainingWindow &shown)
{
    constexpr int sheetsShown = 2;
    const ReportPages pages(reportOf(shown));
    QPixmap picture(sheetsShown * (sheetSize.width() + gap) + gap, sheetSize.height() + 2 * gap);
    picture.fill(Qt::gray);
    QPainter painter(&picture);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.translate(gap, gap);
    for (int i = 0; i < sheetsShown; ++i) {
        painter.fillRect(QRect({}, sheetSize), Qt::white);
        painter.save();
        painter.scale(1 / dotsPerPixel, 1 / dotsPerPixel);
        pages.paint(painter, i);
        painter.restore();
        painter.translate(sheetSize.width() + gap, 0);
    }
    painter.end();
    auto *label = new QLabel(&shown.window());
    label->setPixmap(picture);
    label->resize(picture.size());
    return label;
}

} // namespace codewheel
