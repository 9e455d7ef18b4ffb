// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"

#include <QString>
#include <QStringList>

#include <variant>
#include <vector>

namespace codewheel {

// What a commissioning report says, in the user's language, before it becomes a web page
// (report/html_report.h) or sheets of paper (app/report). Texts are plain: whoever writes them out escapes
// them.

// "Software: Codewheel 0.1.0"
struct ReportFact
{
    QString name;
    QString text;
};
using ReportFacts = std::vector<ReportFact>;

struct ReportTable
{
    enum class Column : std::uint8_t { text, number, code }; // code: hexadecimal, in a fixed font
    struct Row
    {
        QStringList cells;
        bool stressed = false; // what the reader must not overlook; a cell also says why
    };

    QStringList header;
    std::vector<Column> columns;
    std::vector<Row> rows;
};

// A cam program as bars over the positions 0..positions - 1.
struct CamPicture
{
    QString title;
    CamProgram program;
    std::int64_t positions = 1;
    QString firstText;                   // of position 0
    QString lastText;                    // of the last position
    std::size_t cams = CamProgram::cams; // to be shown
};

// Lines to sign on: one for each role, with nothing filled in.
struct SignaturePlaces
{
    QStringList roles; // "Commissioned by"
    QString name;      // captions of the lines
    QString date;
    QString signature;
};

using ReportBlock = std::variant<QString, ReportFacts, ReportTable, CamPicture, SignaturePlaces>;

struct ReportSection
{
    enum class Level : std::uint8_t { chapter, part };

    Level level = Level::chapter;
    QString heading;
    std::vector<ReportBlock> blocks;
};

struct Report
{
    QString language; // of the texts: "en"
    QString title;    // "Commissioning report"
    QString subject;  // title of the project
    QString origin;   // program and date, for the footer of a sheet
    ReportFacts facts;
    std::vector<ReportSection> sections;
};

} // namespace codewheel
