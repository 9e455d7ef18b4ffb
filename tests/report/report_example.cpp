// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/report/report_example.h"

#include "kinds/interbus/ring/ring_device.h"
#include "report/html_report.h"
#include "report/make_report.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QDateTime noon(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC);

ProjectDevice frabaK3()
{
    ProjectDevice device;
    device.participant = RingDevice{NodeId("1.0"), 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib"), 0};
    device.station = QStringLiteral("Crane 1, hoist");
    device.wanted = {{Parameter::steps, 4096}, {Parameter::direction, 3}, {Parameter::preset, 0}};
    device.stored = {{Parameter::steps, 8192, Evidence::read, noon},
                     {Parameter::direction, 3, Evidence::echoed, noon.addSecs(60)}};
    return device;
}

ProjectDevice baumerK3()
{
    ProjectDevice device;
    device.participant = RingDevice{NodeId("2.0"), 0x0237, 2, 2, QStringLiteral("baumer-gxp6w"), 0};
    device.station = QStringLiteral("Crane 1, trolley");
    device.label.serialNumber = QStringLiteral("B 4711");
    return device;
}

ProjectDevice busTerminal()
{
    ProjectDevice device;
    device.participant = RingDevice{NodeId("3.0"), busTerminalIdCode, 0, 0, {}, 0};
    return device;
}

struct RowsOfBlock
{
    std::vector<std::string> &rows;

    void operator()(const ReportTable &table) const
    {
        for (const ReportTable::Row &row : table.rows)
            rows.push_back(row.cells.join(QStringLiteral(" | ")).toStdString());
    }
    template <typename Other>
    void operator()(const Other &) const
    {}
};

} // namespace

ReportInput exampleInput()
{
    ReportInput input;
    input.project.title = QStringLiteral("Harbour crane");
    input.project.devices = {frabaK3(), baumerK3(), busTerminal()};
    input.file = QStringLiteral("crane.codewheel");
    input.version = QStringLiteral("0.1.0");
    input.now = noon.addSecs(7200);
    return input;
}

ProjectDevice &fraba(ReportInput &input)
{
    return input.project.devices.front();
}

const Catalog &catalog()
{
    static const Catalog builtIn = Catalog::builtIn();
    return builtIn;
}

Report reportOf(const ReportInput &input)
{
    return makeReport(input, catalog());
}

const ReportSection &sectionOf(const Report &report, const char *heading)
{
    for (const ReportSection &section : report.sections)
        if (section.heading == QString::fromUtf8(heading))
            return section;
    ADD_FAILURE() << "no section " << heading;
    return report.sections.front();
}

std::vector<std::string> rowsOf(const ReportSection &section)
{
    std::vector<std::string> rows;
    for (const ReportBlock &block : section.blocks)
        std::visit(RowsOfBlock{rows}, block);
    return rows;
}

std::vector<std::string> factsOf(const std::vector<ReportBlock> &blocks)
{
    std::vector<std::string> texts;
    for (const ReportBlock &block : blocks)
        if (const auto *facts = std::get_if<ReportFacts>(&block))
            for (const ReportFact &fact : *facts)
                texts.push_back((fact.name + QStringLiteral(": ") + fact.text).toStdString());
    return texts;
}

std::vector<std::string> paragraphsOf(const ReportSection &section)
{
    std::vector<std::string> texts;
    for (const ReportBlock &block : section.blocks)
        if (const auto *paragraph = std::get_if<QString>(&block))
            texts.push_back(paragraph->toStdString());
    return texts;
}

QString htmlOf(const ReportInput &input)
{
    return QString::fromUtf8(reportAsHtml(reportOf(input)));
}

} // namespace codewheel
