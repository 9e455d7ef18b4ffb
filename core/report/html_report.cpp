// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_report.h"

#include "report/html_style.h"
#include "report/printable_text.h"

namespace codewheel {
namespace {

QString escaped(const QString &text)
{
    return printableText(text).toHtmlEscaped();
}

// Never QString::arg() with a text of the user's: it may contain a %1 itself.
QString element(const QString &name, const QString &text, const QString &attributes = {})
{
    return u'<' + name + attributes + u'>' + escaped(text) + QStringLiteral("</") + name + u'>';
}

QString classOf(ReportTable::Column column)
{
    switch (column) {
    case ReportTable::Column::number:
        return QStringLiteral(" class=\"number\"");
    case ReportTable::Column::code:
        return QStringLiteral(" class=\"code\"");
    case ReportTable::Column::text:
        break;
    }
    return {};
}

QString headerCell(const QString &text, ReportTable::Column column)
{
    const bool isRight = column == ReportTable::Column::number;
    return element(QStringLiteral("th"), text,
                   QStringLiteral(" scope=\"col\"") + (isRight ? classOf(column) : QString()));
}

QString rowHtml(const ReportTable &table, const ReportTable::Row &row)
{
    QString html = row.stressed ? QStringLiteral("<tr class=\"stressed\">") : QStringLiteral("<tr>");
    for (qsizetype i = 0; i < row.cells.size(); ++i)
        html +=
            element(QStringLiteral("td"), row.cells[i], classOf(table.columns[static_cast<std::size_t>(i)]));
    return html + QStringLiteral("</tr>\n");
}

struct BlockHtml
{
    const std::function<QString(const CamPicture &)> &drawn;

    QString operator()(const QString &paragraph) const
    {
        return element(QStringLiteral("p"), paragraph) + u'\n';
    }

    QString operator()(const ReportFacts &facts) const
    {
        QString html = QStringLiteral("<table class=\"facts\">\n");
        for (const ReportFact &fact : facts)
            html += QStringLiteral("<tr>") +
                    element(QStringLiteral("th"), fact.name, QStringLiteral(" scope=\"row\"")) +
                    element(QStringLiteral("td"), fact.text) + QStringLiteral("</tr>\n");
        return html + QStringLiteral("</table>\n");
    }

    QString operator()(const ReportTable &table) const
    {
        QString html = QStringLiteral("<table>\n<thead><tr>");
        for (qsizetype i = 0; i < table.header.size(); ++i)
            html += headerCell(table.header[i], table.columns[static_cast<std::size_t>(i)]);
        html += QStringLiteral("</tr></thead>\n<tbody>\n");
        for (const ReportTable::Row &row : table.rows)
            html += rowHtml(table, row);
        return html + QStringLiteral("</tbody>\n</table>\n");
    }

    QString operator()(const CamPicture &picture) const
    {
        return QStringLiteral("<figure>\n<figcaption>") + element(QStringLiteral("p"), picture.title) +
               QStringLiteral("</figcaption>\n") + drawn(picture) + QStringLiteral("</figure>\n");
    }

    QString operator()(const SignaturePlaces &places) const
    {
        QString html;
        for (const QString &role : places.roles) {
            html += element(QStringLiteral("p"), role, QStringLiteral(" class=\"role\"")) +
                    QStringLiteral("\n<table class=\"sign\"><tr>") +
                    QStringList{element(QStringLiteral("td"), places.name),
                                element(QStringLiteral("td"), places.date),
                                element(QStringLiteral("td"), places.signature)}
                        .join(QStringLiteral("<td class=\"gap\"></td>")) +
                    QStringLiteral("</tr></table>\n");
        }
        return html;
    }
};

QString sectionHtml(const ReportSection &section, const BlockHtml &blocks)
{
    const bool isChapter = section.level == ReportSection::Level::chapter;
    QString html = QStringLiteral("<section>\n") +
                   element(isChapter ? QStringLiteral("h2") : QStringLiteral("h3"), section.heading) + u'\n';
    for (const ReportBlock &block : section.blocks)
        html += std::visit(blocks, block);
    return html + QStringLiteral("</section>\n");
}

QString head(const Report &report)
{
    const QString title =
        report.subject.isEmpty() ? report.title : report.title + QStringLiteral(": ") + report.subject;
    return QStringLiteral("<head>\n<meta charset=\"utf-8\"/>\n"
                          "<meta http-equiv=\"Content-Security-Policy\" "
                          "content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n"
                          "<meta name=\"viewport\" content=\"width=device-width\"/>\n") +
           element(QStringLiteral("title"), title) + QStringLiteral("\n<style>") +
           QString::fromLatin1(reportStyle) + QStringLiteral("</style>\n</head>\n");
}

} // namespace

QString reportBody(const Report &report, const std::function<QString(const CamPicture &)> &drawn)
{
    const BlockHtml blocks{drawn};
    QString html = element(QStringLiteral("h1"), report.title) + u'\n';
    if (!report.subject.isEmpty())
        html += element(QStringLiteral("p"), report.subject, QStringLiteral(" class=\"subject\"")) + u'\n';
    html += blocks(report.facts);
    for (const ReportSection &section : report.sections)
        html += sectionHtml(section, blocks);
    return html;
}

QByteArray reportAsHtml(const Report &report)
{
    const QString language = escaped(report.language);
    return (QStringLiteral("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"") +
            language + QStringLiteral("\" xml:lang=\"") + language + QStringLiteral("\">\n") + head(report) +
            QStringLiteral("<body>\n") + reportBody(report, camPictureAsSvg) +
            element(QStringLiteral("footer"), report.origin) + QStringLiteral("\n</body>\n</html>\n"))
        .toUtf8();
}

} // namespace codewheel
