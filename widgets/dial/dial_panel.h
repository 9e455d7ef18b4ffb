// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "widgets/dial/dial_state.h"
#include "widgets/dial/shaft_motion.h"

#include <QPointer>
#include <QWidget>

class QPushButton;
class QStackedWidget;

namespace codewheel {

class CodeDisc;
class InlineMessage;

// The chosen encoder as a dial: position, turns, speed. Where coding or scale are not known it shows the raw
// word, says what is missing, and offers to read it.
class DialPanel : public QWidget
{
    Q_OBJECT

public:
    explicit DialPanel(QWidget *parent = nullptr);

    void setEncoder(EncoderSession *encoder); // null: an empty state

private:
    // What has to be known for the disc to turn.
    struct Scale
    {
        double stepsPerTurn = 0;
        bool clockwise = true;
        std::optional<std::int64_t> total;
    };

    void knownChanged();
    void draw();
    void read();
    std::vector<Parameter> missing() const;
    std::optional<Scale> scale() const;
    DialState running(const Reading &reading);
    QString rawNote(const Reading &reading) const;
    QString missingNote() const;

    QPointer<EncoderSession> m_encoder;
    std::vector<Parameter> m_missing;
    std::optional<Scale> m_scale;
    ShaftMotion m_motion;
    QStackedWidget *m_pages;
    CodeDisc *m_disc;
    QPushButton *m_read;
    InlineMessage *m_message;
};

} // namespace codewheel
