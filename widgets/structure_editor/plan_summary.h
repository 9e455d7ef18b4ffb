// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/project/project_document.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace codewheel {

// The line below the structure editor: how much of what a ring may have is used, and about how long a cycle
// takes, by both formulas at both speeds.
class PlanSummary : public QWidget
{
    Q_OBJECT

public:
    explicit PlanSummary(ProjectDocument &document, QWidget *parent = nullptr);
    ~PlanSummary() override;

    void setRing(BusId ring); // the first one at first
    QString countsText() const;
    QString timesText() const;

private:
    void show();

    ProjectDocument &m_document;
    BusId m_ring = firstRing;
    QLabel *m_counts;
    QLabel *m_times;
    QDoubleSpinBox *m_cable;
    ProjectDocument::Gesture m_stepping; // until the field is left or Return is pressed
};

} // namespace codewheel
