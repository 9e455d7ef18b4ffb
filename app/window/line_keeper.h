// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"
#include "project/line_plan.h"

#include <QObject>

namespace codewheel {

class EncoderSession;
class ProjectDocument;
class LineAtWork;

// Keeps in the project what becomes of its serial line, each change a step of undo. The training line is not
// the project's: of its encoders, which do not exist, nothing is kept. Used by LineViews.
class LineKeeper : public QObject
{
    Q_OBJECT

public:
    // Both must outlive it.
    LineKeeper(const LineAtWork &line, ProjectDocument &project, QObject *parent = nullptr);

    // Of the project; where that has none, the one that is open, as the factory has it where none is.
    LinePlan line() const;

    // As it is open now, with these settings.
    void keepPort(const LinePlan &line);
    void keepFractionBits(int bits);
    void keepBaudRate(int baudRate);
    // Whether the warnings of this encoder come with their bytes in the other order.
    void keepByteOrder(Place number, bool isSwapped);
    // Those that the project has already stay as they are.
    void keepEncoders(const std::vector<Place> &numbers);
    void removeEncoder(Place number);
    // All that is planned and known of the encoder goes along.
    void moveEncoder(Place from, Place to);

private:
    const EncoderSession *sessionOf(Place number) const;
    void edit(const LinePlan &after, const QString &what);
    void edit(std::vector<ProjectDevice> after, const QString &what);
    std::vector<ProjectDevice> encoders() const; // of the project

    const LineAtWork &m_line;
    ProjectDocument &m_project;
};

} // namespace codewheel
