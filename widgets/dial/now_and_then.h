// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/position_scale.h"
#include "vocabulary/encoder_session.h"
#include "widgets/dial/rod_state.h"
#include "widgets/dial/shaft_state.h"

#include <QPointer>
#include <QWidget>

namespace codewheel {

class AgeTimer;
class CodeDisc;
class RodView;

// Before the position of an encoder is set: its dial or rod as it is now, also while it moves, and what it
// will show. Sends nothing, and offers nothing to send.
class NowAndThen : public QWidget
{
    Q_OBJECT

public:
    explicit NowAndThen(QWidget *parent = nullptr);

    void setEncoder(EncoderSession &encoder);
    // Empty: it is not known; `whyNot` says so. `valueThen`: the values of then, if they may be others than
    // those of now.
    void setThen(std::optional<std::int64_t> position, const QString &whyNot = {},
                 const ValueOf &valueThen = {});
    // By its programmed preset, with these values.
    void setThenByPreset(const ValueOf &valueThen);

private:
    void knownChanged();
    void draw();
    void drawRod();
    void drawShaft();
    RodState::Then rodThen() const;
    std::optional<ShaftScale> shaftThen() const;

    QPointer<EncoderSession> m_encoder;
    std::optional<std::int64_t> m_then;
    QString m_whyNot;
    std::optional<ShaftScale> m_scale;
    ValueOf m_valueThen; // empty: as now
    RodState m_known;
    QString m_missing;
    AgeTimer *m_age;
    CodeDisc *m_disc;
    RodView *m_rod;
};

} // namespace codewheel
