// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"
#include "widgets/dial/shaft_state.h"
#include "widgets/look/printed_view.h"

#include <QPointer>
#include <QWidget>

namespace codewheel {

class AgeTimer;
class CodeDisc;
class MissingValues;

// An encoder on a shaft as a dial: position, turns, speed. Where coding or scale are not known it shows the
// raw word, says what is missing, and offers to read it.
class ShaftDial : public QWidget
{
    Q_OBJECT

public:
    explicit ShaftDial(QWidget *parent = nullptr);

    void setEncoder(EncoderSession *encoder); // null: none is shown
    std::optional<PrintedView> printedView() const;

private:
    void knownChanged();
    void draw();

    QPointer<EncoderSession> m_encoder;
    std::optional<ShaftScale> m_scale;
    AgeTimer *m_age;
    CodeDisc *m_disc;
    MissingValues *m_missing;
};

} // namespace codewheel
