// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <cstdint>

class QDial;
class QGridLayout;

namespace codewheel {

// Turns a shaft by hand: a wheel to drag (zero at the top), and buttons for exact steps. Used by the training
// panel.
class HandWheel : public QWidget
{
    Q_OBJECT

public:
    explicit HandWheel(QWidget *parent = nullptr);

    void setStepsPerTurn(int steps);
    // Follows the shaft, except while the wheel is held.
    void showRaw(std::int64_t raw);

Q_SIGNALS:
    void turned(qint64 steps); // clockwise positive

private:
    struct Turn
    {
        int part; // of a turn: 4 is a quarter; 0: one step
        int sense;
        QString text;
        QString name;
    };
    void addButton(QGridLayout *grid, int row, const Turn &turn);
    void turnWheel(int place);

    static constexpr int places = 1024; // of the wheel per turn

    QDial *m_wheel;
    int m_stepsPerTurn = places;
    int m_place = 0; // position of the wheel
};

} // namespace codewheel
