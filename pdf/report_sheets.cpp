// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/report_sheets.h"

#include "encoder/sentence.h"
#include "pdf/cam_picture_layout.h"
#include "pdf/sheet_flow.h"
#include "pdf/sheet_format.h"
#include "pdf/table_layout.h"

#include <QCoreApplication>
#include <QFontMetricsF>

namespace codewheel {
namespace {

using sheet::body;
using sheet::mm;

// The context of these texts.
struct ReportSheets
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ReportSheets)
};

constexpr qreal nameWidth = mm(40);       // of facts
constexpr qreal withHeading = mm(24);     // what must follow a heading on its sheet
constexpr qreal signatureHeight = mm(30); // of one role
constexpr qreal lineAbove = mm(14);       // room to write above a line

struct BlockLayout
{
    SheetFlow &flow;

    void operator()(const QString &paragraph) const
    {
        flow.addParagraph(paragraph, flow.fonts().text, body.left(), body.width());
        flow.skip(sheet::gap);
    }

    void operator()(const ReportFacts &facts) const
    {
        const QFont &font = flow.fonts().text;
        for (const ReportFact &fact : facts) {
            const QStringList names = textLines(fact.name, font, nameWidth - sheet::gap);
            const QStringList texts = textLines(fact.text, font, body.width() - nameWidth);
            for (qsizetype line = 0; line < std::max(names.size(), texts.size()); ++line) {
                flow.need(lineHeight(font));
                flow.addText(names.value(line), font, body.left(), nameWidth);
                flow.addText(texts.value(line), font, body.left() + nameWidth, body.width() - nameWidth);
                flow.skip(lineHeight(font));
            }
        }
        flow.skip(sheet::gap);
    }

    void operator()(const ReportTable &table) const { TableLayout(flow, table).add(); }

    void operator()(const CamPicture &picture) const { addCamPicture(flow, picture); }

    void operator()(const SignaturePlaces &places) const
    {
        for (const QString &role : places.roles) {
            flow.need(signatureHeight);
            flow.addText(role, flow.fonts().text, body.left(), body.width());
            flow.skip(lineHeight(flow.fonts().text) + lineAbove);
            addPlace(places.name, 0, 0.36);
            addPlace(places.date, 0.4, 0.2);
            addPlace(places.signature, 0.64, 0.36);
            flow.skip(signatureHeight - lineHeight(flow.fonts().text) - lineAbove);
        }
    }

private:
    // A line with its caption below; where it begins and how long it is, as parts of the width.
    void addPlace(const QString &caption, qreal begin, qreal length) const
    {
        const qreal left = body.left() + begin * body.width();
        const qreal width = length * body.width();
        flow.sheet().lines.push_back({{left, flow.y(), left + width, flow.y()}, sheet::thickLine});
        flow.addText(caption, flow.fonts().small, left, width);
    }
};

qreal heightToKeep(const ReportSection &section)
{
    if (section.blocks.empty())
        return 0;
    const auto *places = std::get_if<SignaturePlaces>(&section.blocks.front());
    return places ? signatureHeight * static_cast<qreal>(places->roles.size()) : withHeading;
}

void addHeading(SheetFlow &flow, const ReportSection &section)
{
    const bool isChapter = section.level == ReportSection::Level::chapter;
    const QFont &font = isChapter ? flow.fonts().chapter : flow.fonts().part;
    const qreal above = isChapter ? mm(6) : mm(4);
    const QStringList lines = textLines(section.heading, font, body.width());
    flow.need(above + static_cast<qreal>(lines.size()) * lineHeight(font) + heightToKeep(section));
    if (!flow.isAtTop())
        flow.skip(above);
    flow.addParagraph(section.heading, font, body.left(), body.width());
    flow.skip(mm(0.8));
    if (isChapter)
        flow.addThickRule();
    flow.skip(sheet::gap);
}

void addTitle(SheetFlow &flow, const Report &report)
{
    flow.addParagraph(report.title, flow.fonts().title, body.left(), body.width());
    if (!report.subject.isEmpty())
        flow.addParagraph(report.subject, flow.fonts().chapter, body.left(), body.width());
    flow.skip(mm(4));
}

// The first sheet has the title instead of a head.
void addHeadAndFoot(std::vector<Sheet> &sheets, const Report &report, const QFont &font)
{
    const qreal height = lineHeight(font);
    const qreal half = body.width() / 2 - sheet::gap;
    const QString subject = QFontMetricsF(font).elidedText(
        textLines(report.subject, font, body.width()).front(), Qt::ElideRight, half);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (i > 0) {
            placeText(sheets[i], report.title, font, {body.left(), sheet::headLine, half, height},
                      SheetFlow::Align::left);
            placeText(sheets[i], subject, font, {body.right() - half, sheet::headLine, half, height},
                      SheetFlow::Align::right);
        }
        const QString number = sentence(ReportSheets::tr("Page %1 of %2"),
                                        {QString::number(i + 1), QString::number(sheets.size())});
        placeText(sheets[i], report.origin, font, {body.left(), sheet::footLine, half, height},
                  SheetFlow::Align::left);
        placeText(sheets[i], number, font, {body.right() - half, sheet::footLine, half, height},
                  SheetFlow::Align::right);
    }
}

} // namespace

std::vector<Sheet> reportSheets(const Report &report)
{
    SheetFlow flow;
    addTitle(flow, report);
    BlockLayout{flow}(report.facts);
    for (const ReportSection &section : report.sections) {
        addHeading(flow, section);
        for (const ReportBlock &block : section.blocks)
            std::visit(BlockLayout{flow}, block);
    }
    std::vector<Sheet> sheets = flow.take();
    addHeadAndFoot(sheets, report, flow.fonts().small);
    return sheets;
}

} // namespace codewheel
