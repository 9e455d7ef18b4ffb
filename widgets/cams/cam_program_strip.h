// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/key_help.h"

#include <QAbstractButton>

#include <array>

namespace codewheel {

class CamSheet;

// One of the eight programs: its number, its cams in miniature, and a mark where it differs from the
// encoder's.
class CamProgramButton : public QAbstractButton
{
    Q_OBJECT

public:
    CamProgramButton(CamSheet &sheet, unsigned number, QWidget *parent);

    unsigned number() const { return m_number; }
    void describe(); // again, when the program, or what the encoder has, has changed

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void drawCams(QPainter &painter, const QRectF &room) const;

    CamSheet &m_sheet;
    unsigned m_number;
};

// All eight programs side by side, so that all 64 cams are in sight; a click opens a program. So do the
// number keys while one of them has the focus.
class CamProgramStrip : public QWidget
{
    Q_OBJECT

public:
    explicit CamProgramStrip(CamSheet &sheet, QWidget *parent = nullptr);
    static QList<KeyHelp> keys(); // that it answers

Q_SIGNALS:
    void programChosen(unsigned number); // 0 and 9 can be typed as well

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void refresh();

    CamSheet &m_sheet;
    std::array<CamProgramButton *, 8> m_buttons;
};

} // namespace codewheel
