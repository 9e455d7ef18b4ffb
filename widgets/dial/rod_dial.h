// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"
#include "widgets/dial/rod_state.h"
#include "widgets/look/printed_view.h"

#include <QPointer>
#include <QWidget>

class QPushButton;

namespace codewheel {

class AgeTimer;
class MissingValues;
class RodView;
class ValueField;

// A linear encoder as its rod. The length of the rod is only on its label: entering it here turns steps into
// mm.
class RodDial : public QWidget
{
    Q_OBJECT

public:
    explicit RodDial(QWidget *parent = nullptr);

    void setEncoder(EncoderSession *encoder); // null: none is shown
    std::optional<PrintedView> printedView() const;

private:
    void knownChanged();
    void showTellRow();
    void tellLength();
    void draw();

    QPointer<EncoderSession> m_encoder;
    RodState m_known; // length, scale, direction
    AgeTimer *m_age;
    RodView *m_rod;
    MissingValues *m_missing;
    QPushButton *m_readStatus;
    QWidget *m_tellRow;
    ValueField *m_lengthField = nullptr;
    QPushButton *m_tell;
};

} // namespace codewheel
