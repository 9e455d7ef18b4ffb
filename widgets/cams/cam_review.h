// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "widgets/models/table_model_base.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class EepromGate;

struct CamReviewRow
{
    std::optional<unsigned> program; // the encoder is in; nothing: it is not in cam mode
    Word word = 0;                   // as it will stand in OUT
    QString meaning{};               // "Start of cam 3 = 21"
    QString old{};                   // what the encoder has instead; empty: the word sets no cams
    bool isThere = false;            // the encoder is known to have what the word sets

    friend bool operator==(const CamReviewRow &, const CamReviewRow &) = default;
};

// Program, word, meaning, old.
class CamReviewModel final : public TableModelBase<CamReviewRow>
{
    Q_OBJECT

public:
    using TableModelBase::TableModelBase;
    enum Column { programColumn, wordColumn, meaningColumn, oldColumn };

protected:
    int columns() const override { return oldColumn + 1; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const CamReviewRow &row, int column, int role) const override;

private:
    QString text(const CamReviewRow &row, int column) const;
};

// Shown in the cam editor before anything is written: what will change, the exact words in their order, what
// it costs, and in which mode the encoder is left.
class CamReview : public QWidget
{
    Q_OBJECT

public:
    explicit CamReview(QWidget *parent = nullptr);

    // before: the mode the encoder is in, or is to be left in as was answered.
    void review(EncoderSession &encoder, const std::vector<CamProgram> &programs, const SwitchMode &before);

Q_SIGNALS:
    void confirmed(const codewheel::WriteCams &job);
    void cancelled();

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    QWidget *makeAfterwards();
    void offerAfterwards(const SwitchMode &before);
    void showPlan();
    void allow();
    QString notes() const;
    QString notesOnWords() const;
    WriteCams job() const;

    QPointer<EncoderSession> m_encoder;
    std::vector<CamProgram> m_programs;
    std::vector<SwitchMode> m_choices; // beside the entries of m_afterwards
    std::optional<Refusal> m_problem;  // why there is no plan
    CamReviewModel *m_model;
    QLabel *m_title;
    QTableView *m_table;
    QLabel *m_notes;
    EepromGate *m_gate;
    QComboBox *m_afterwards;
    QCheckBox *m_writeAll;
    QPushButton *m_write;
    QPushButton *m_cancel;
};

} // namespace codewheel
