// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"
#include "widgets/help/key_help.h"
#include "widgets/look/painted_parts.h"
#include "widgets/monitor/bit_cell.h"
#include "widgets/monitor/change_marks.h"
#include "widgets/monitor/word_layout.h"

#include <QWidget>

#include <functional>

namespace codewheel {

// The words of a device bit under bit, each bit a separate control for mouse, keys and screen readers,
// painted as one widget. It shows what it is given and asks for changes by bitToggled(). All bits are in one
// row if it is wide enough, else in two.
//
// Keys: Left to the higher bit, Right to the lower, Up and Down to the bit above and below, Home to the
// highest, End to bit 0, Space toggles.
class WordView : public QWidget, public PaintedParts
{
    Q_OBJECT

public:
    struct Line
    {
        QString caption; // "OUT", left of its bits
        QString place;   // "OUT 1.0": names the bits for screen readers
        bool isEditable = false;
        // The meaning of a bit in this device, for tooltip, status tip and screen reader; empty if nothing is
        // known.
        std::function<QString(int bit)> bitText{};
    };

    // From top to bottom; at least one.
    WordView(const WordForm &form, std::vector<Line> lines, QWidget *parent = nullptr);

    // Old bits are grey.
    void setOld(int word, bool old);
    void setKnown(int word, bool known); // the bits of one that is not known are not drawn
    bool isOld(int word) const { return at(word).isOld; }
    // In rows of 8 bits, whatever the width.
    void setMatrix(bool matrix);

    // shown: including staged changes; onBus: as last sent or received; edges: bits that changed in any cycle
    // since the last call. Call it for each frame, even if nothing has changed: marks expire by `now`.
    void setWord(int word, Word shown, Word onBus, Word edges, Instant now);
    Word word(int word = 0) const { return at(word).shown; }

    int bits() const { return m_layout.bits(); }
    int words() const { return m_layout.words(); }
    bool isEditable(int word) const { return at(word).line.isEditable; }
    bool isSet(WordBit bit) const;
    bool isStaged(WordBit bit) const;
    bool isMarked(WordBit bit) const;
    QString bitName(WordBit bit) const; // "OUT 1.0 bit 25"
    QString bitDescription(WordBit bit) const;
    QRect bitRect(WordBit bit) const { return m_layout.cell(bit); }
    std::optional<WordBit> bitAt(QPoint point) const { return m_layout.bitAt(point); }
    static int captionWidth(const QStringList &captions); // of the column of captions

    WordBit focusedBit() const { return m_focused; }
    void setFocusedBit(WordBit bit);
    // As if the bit were clicked: does nothing if it cannot be.
    void toggleBit(WordBit bit);

    // Its bits, word by word, the highest first.
    int partCount() const override { return words() * bits(); }
    QString partName(int part) const override { return bitName(bitOf(part)); }
    QString partDescription(int part) const override { return bitDescription(bitOf(part)); }
    QRect partRect(int part) const override { return bitRect(bitOf(part)); }
    std::optional<int> partAt(QPoint point) const override;
    bool isPartChecked(int part) const override { return isSet(bitOf(part)); }
    bool isPartEditable(int part) const override { return isEditable(bitOf(part).word); }
    int focusedPart() const override { return partOf(m_focused); }
    void focusPart(int part) override { setFocusedBit(bitOf(part)); }
    void togglePart(int part) override { toggleBit(bitOf(part)); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return layoutFor(width).size().height(); }
    static QList<KeyHelp> keys(); // that it handles

Q_SIGNALS:
    void bitToggled(codewheel::WordBit bit);

protected:
    bool event(QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    struct Shown
    {
        Line line;
        Word shown = 0;
        Word staged = 0;
        ChangeMarks marks{};
        bool isOld = false;
        bool isKnown = true;
    };

    const Shown &at(int word) const { return m_words[static_cast<std::size_t>(word)]; }
    Shown &at(int word) { return m_words[static_cast<std::size_t>(word)]; }
    bool has(WordBit bit) const;
    int partOf(WordBit bit) const { return bit.word * bits() + bits() - 1 - bit.bit; }
    WordBit bitOf(int part) const { return {part / bits(), bits() - 1 - part % bits()}; }
    QStringList captions() const;
    WordLayout layoutWith(int rows, bool isTight = false) const;
    WordLayout layoutFor(int width) const;
    void arrange();
    std::optional<WordBit> bitForKey(int key) const;
    WordBit below(WordBit bit, int lines) const;
    BitCell lookOf(WordBit bit) const;
    void setHoveredBit(std::optional<WordBit> bit);
    void updateCells(int word, Word bits);
    void updateCell(WordBit bit) { update(m_layout.cell(bit)); }
    void paintCaptions(QPainter &painter, const QRegion &exposed) const;
    void showStatusTip(std::optional<WordBit> bit);
    bool showToolTip(QPoint position, QPoint globalPosition);

    std::vector<Shown> m_words;
    bool m_matrix = false;
    WordLayout m_layout;
    BitCellPictures m_pictures;
    WordBit m_focused;
    std::optional<WordBit> m_hovered;
    std::optional<WordBit> m_pressed;
};

} // namespace codewheel
