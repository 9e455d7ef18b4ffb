// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"
#include "widgets/project/project_document.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;

namespace codewheel {

// Below the structure editor for a ring: how addresses in the process image are counted, how much of the
// ring's limits is used, and the approximate cycle time, by both formulas at both speeds.
class RingPlanFields : public QWidget
{
    Q_OBJECT

public:
    // The document outlives it.
    RingPlanFields(ProjectDocument &document, BusId ring, QWidget *parent = nullptr);
    ~RingPlanFields() override;

private:
    QHBoxLayout *makeAddressing();
    QHBoxLayout *makeTimes();
    void setAddressing();
    void show();
    QString countsText() const;
    QString timesText() const;

    ProjectDocument &m_document;
    const BusId m_ring;
    QComboBox *m_unit;
    IntegerField *m_first;
    QCheckBox *m_step5;
    QLabel *m_counts;
    QLabel *m_times;
    DecimalField *m_cable;
    ProjectDocument::Gesture m_stepping; // until the field is left or Return is pressed
};

} // namespace codewheel
