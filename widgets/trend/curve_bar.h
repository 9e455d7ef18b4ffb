// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"
#include "widgets/trend/encoder_scales.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QToolButton;

namespace codewheel {

// What can be set of the curve that is chosen in the table: its unit, its axis, its place, or that it goes.
class CurveBar : public QWidget
{
    Q_OBJECT

public:
    // Both outlive it.
    CurveBar(TrendTracks &tracks, const EncoderScales &scales, QWidget *parent = nullptr);

    void setCurve(std::optional<std::size_t> index); // nothing: none is chosen
    std::optional<std::size_t> curve() const { return m_index; }
    void move(int by); // the chosen curve, by one: up (-1) or down (1); not beyond the others
    void showAnew();   // after something else has changed

Q_SIGNALS:
    void moved(std::size_t to); // the curve that is chosen

private:
    void showUnits(const TrendTracks::Shown &shown);
    QString whyNot(Place place, TrackUnit unit) const;
    void showTravel(const TrendTracks::Shown &shown);
    std::optional<TrendTracks::Shown> shown() const;

    TrendTracks &m_tracks;
    const EncoderScales &m_scales;
    std::optional<std::size_t> m_index;
    QComboBox *m_unit;
    DecimalField *m_travel;
    QCheckBox *m_shares;
    QToolButton *m_up;
    QToolButton *m_down;
    QToolButton *m_remove;
};

} // namespace codewheel
