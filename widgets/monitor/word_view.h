// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/bit_cell.h"
#include "widgets/monitor/change_marks.h"
#include "widgets/monitor/word_layout.h"
#include "words/k3_word.h"

#include <QPointer>
#include <QWidget>

#include <functional>

namespace codewheel {

// A word as its bits, each a control of its own for mouse, keys and screen readers, painted as one widget. It
// shows what it is given and asks for a change by bitToggled(); monitors and the wizard use it.
//
// Keys: Left to the higher bit, Right to the lower, Up and Down between the rows, Home to the highest, End to
// bit 0, Space toggles.
class WordView : public QWidget
{
    Q_OBJECT

public:
    explicit WordView(const WordForm &form, QWidget *parent = nullptr);

    // "OUT 1.0": names the bits for screen readers.
    void setPlace(const QString &place);
    QString place() const { return m_place; }
    void setEditable(bool editable);
    bool isEditable() const { return m_editable; }
    // The bits are of before: grey.
    void setOld(bool old);
    bool isOld() const { return m_old; }
    // In rows of 8 bits, whatever the width of the window.
    void setMatrix(bool matrix);
    // What a bit means in this device, for tooltip, status tip and screen reader; empty where nothing is
    // known.
    void setBitText(std::function<QString(int bit)> text);

    // shown: with what is staged; onBus: as last sent or received; edges: bits that changed in any cycle
    // since the last call. Call it for each picture, also where nothing changed: marks go by now.
    void setWord(Word shown, Word onBus, Word edges, Instant now);
    Word word() const { return m_shown; }

    int bits() const { return m_layout.bits(); }
    bool isSet(int bit) const;
    bool isStaged(int bit) const;
    bool isMarked(int bit) const;
    QString bitName(int bit) const; // "OUT 1.0 bit 25"
    QString bitDescription(int bit) const;
    QRect bitRect(int bit) const { return m_layout.cell(bit); }
    std::optional<int> bitAt(QPoint point) const { return m_layout.bitAt(point); }

    int focusedBit() const { return m_focusedBit; }
    void setFocusedBit(int bit);
    // As if the bit were clicked: does nothing where it cannot be.
    void toggleBit(int bit);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void bitToggled(int bit);

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    std::optional<int> bitForKey(int key) const;
    BitCell lookOf(int bit) const;
    void setHoveredBit(std::optional<int> bit);
    void updateCells(Word bits);
    void watchWindow();
    int wantedRows() const;
    bool fitsIntoOneRow() const;
    void arrange();
    void showStatusTip(std::optional<int> bit);
    bool showToolTip(QPoint position, QPoint globalPosition);

    WordLayout m_layout;
    BitCellPictures m_pictures;
    QPointer<QWidget> m_window;
    QPointer<QWidget> m_room; // of the column it stands in, if it does
    QString m_place;
    std::function<QString(int)> m_bitText;
    Word m_shown = 0;
    Word m_staged = 0;
    ChangeMarks m_marks;
    bool m_editable = false;
    bool m_old = false;
    bool m_matrix = false;
    int m_focusedBit;
    std::optional<int> m_hoveredBit;
    std::optional<int> m_pressedBit;
};

} // namespace codewheel
