// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/write_plan.h"
#include "widgets/look/fonts.h"
#include "widgets/models/table_model_base.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class EepromGate;
class InlineMessage;

// Parameter, old, new, word.
class WriteReviewModel final : public TableModelBase<WritePlan::Row>
{
    Q_OBJECT

public:
    using TableModelBase::TableModelBase;
    enum Column { name, oldValue, newValue, word };

    void show(const EncoderSession &encoder, const WritePlan &plan);

protected:
    int columns() const override { return 4; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const WritePlan::Row &row, int column, int role) const override;

private:
    QString text(const WritePlan::Row &row, int column) const;
    TextSize size() const;

    QPointer<const EncoderSession> m_encoder;
};

// Shown in the parameter panel before anything is written: what will change, the exact words, what it costs.
class WriteReview : public QWidget
{
    Q_OBJECT

public:
    explicit WriteReview(QWidget *parent = nullptr);

    void review(EncoderSession &encoder, const ParameterValues &wanted);

Q_SIGNALS:
    void confirmed(const codewheel::WriteParameters &job);
    void cancelled();

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void showPlan();
    void allow();
    QString notes() const;

    QPointer<EncoderSession> m_encoder;
    ParameterValues m_wanted;
    WritePlan m_plan;
    WriteReviewModel *m_model;
    QTableView *m_table;
    InlineMessage *m_problem; // why nothing can be written
    QLabel *m_notes;
    EepromGate *m_gate;
    QCheckBox *m_writeAll;
    QPushButton *m_write;
    QPushButton *m_cancel;
};

} // namespace codewheel
